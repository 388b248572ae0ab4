#include "load_moments.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ndframe/sampling/point_sums.hpp"

namespace ndframe
{
namespace
{

/// What a load may differ from its polynomial by, relative to its size, and still be that polynomial.
constexpr double roundOff = 1e-12;

/// factor sum_g rows_g q_g, per row and component: rows of `count` numbers.
template <std::size_t size>
void addUp(const std::vector<double>& rows, std::size_t count, double factor, const double* q, double* sums)
{
  for (std::size_t row = 0; row < rows.size(); row += count, sums += size) {
    double sum[size] = {};
    for (std::size_t g = 0; g < count; ++g)
      for (std::size_t i = 0; i < size; ++i)
        sum[i] += rows[row + g] * q[g * size + i];
    for (std::size_t i = 0; i < size; ++i)
      sums[i] = factor * sum[i];
  }
}

void addUp(const std::vector<double>& rows, double factor, const std::vector<double>& q, std::size_t count,
           std::vector<double>& sums)
{
  const std::size_t size = q.size() / count;
  sums.resize(rows.size() / count * size);
  (size == 2 ? addUp<2> : addUp<3>)(rows, count, factor, q.data(), sums.data());
}

/// |q_1 - q_h| for the affine function q_1 with these moments and the piecewise constants q_h that act like the same
/// forces at the vertices. The affine functions have the value of their mean on a sub-cell at its centroid, and the
/// centroids scatter by (n + 1) / n^2 of the cell's points (n vertices, squares): |q_h - mean|^2 is n^2 / (n + 1) times
/// |q_1 - mean|^2 and their product is |q_1 - mean|^2.
double distanceToPiecewise(const LoadedSimplex& simplex, const std::vector<double>& moments, int components, int dim)
{
  double square = 0.0;
  for (std::size_t i = std::size_t(components); i < moments.size(); ++i)
    square += moments[i] * moments[i];
  const double n = dim + 1.0;
  return std::sqrt((n * n / (n + 1.0) - 1.0) * square / simplex.measure);
}

} // namespace

LoadMoments::LoadMoments(int dim, int order, const MomentBasis& basis, const MomentBasis& fine, int carried)
    : dim_(dim), order_(order), isPiecewise_(false), basis_(basis),
      tested_(order == 2 ? basis : MomentBasis::polynomials(basis.dim(), 0)), fine_(fine), all_(fine),
      carried_(std::size_t(carried)), unit_(basis, order)
{}

LoadMoments LoadMoments::onFacets(int dim, int order, int degree, int fine)
{
  const MomentBasis basis = facetBasis(dim, degree);
  LoadMoments result(dim, order, basis, facetBasis(dim, fine), order == 1 ? dim : basis.size()); // order 1: affine
  result.all_ = SampledBasis(MomentBasis::polynomials(dim - 1, std::max(fine, order == 2 ? degree + 1 : 1)));
  result.testByHats();
  return result;
}

LoadMoments LoadMoments::inCells(int dim, int order, int degree, int fine)
{
  NDFRAME_ASSERT(order == 1 || degree > 1, "loads of order 2 are shared out as polynomials");
  const MomentBasis basis = loadBasis(dim, degree);
  const int ofFine = std::max(1, fine - 1);
  LoadMoments result(dim, order, basis, MomentBasis::polynomials(dim, ofFine), basis.size());
  result.isPiecewise_ = degree == 1;
  result.all_ = SampledBasis(MomentBasis::polynomials(dim, std::max(ofFine, order == 2 ? degree : 1)));
  result.testByHats();
  return result;
}

/// phi_a m_j = sum_k <phi_a m_j, M_k> M_k.
void LoadMoments::testByHats()
{
  const std::size_t vertices = std::size_t(all_.basis().dim()) + 1, tested = std::size_t(tested_.size());
  const auto all = std::size_t(all_.size());
  const QuadratureRule rule = simplexRule(all_.basis().dim(), 10);
  ofHats_.assign(vertices * tested * all, 0.0);
  std::vector<double> m(tested), M(all);
  for (int g = 0; g < rule.size(); ++g) {
    tested_.values(rule.point(g), m.data());
    all_.basis().values(rule.point(g), M.data());
    for (std::size_t row = 0; row < vertices * tested; ++row)
      for (std::size_t k = 0; k < all; ++k)
        ofHats_[row * all + k] += rule.weights[std::size_t(g)] * rule.point(g)[row / tested] * m[row % tested] * M[k];
  }
}

/// Per vertex the force times the share of a unit force there.
void LoadMoments::spreadForces()
{
  const std::size_t vertices = std::size_t(basis_.dim()) + 1, size = std::size_t(dim_);
  result_.shares.clear();
  for (std::size_t a = 0; a < vertices; ++a)
    for (std::size_t k = 0; k < std::size_t(basis_.size()); ++k)
      for (std::size_t i = 0; i < size; ++i)
        result_.shares.push_back(forces_[a * size + i] * double(vertices) * unit_.ofOne(int(a))[k]);
}

/// int phi_a q m_j per vertex, mode and component, by the moments.
void LoadMoments::addShares(std::size_t size)
{
  addUp(ofHats_, 1.0, moments_, moments_.size() / size, order_ == 2 ? result_.shares : forces_);
  if (order_ == 1)
    spreadForces();
}

/// The moments of samples. Returns |q - q_h| for q_h with those of the finer basis.
double LoadMoments::takeSamples(const LoadedSimplex& simplex)
{
  const auto modes = std::size_t(fine_.size()), size = std::size_t(dim_);
  const BasisTables& tables = all_.at(simplex.samples, ascendingPlaces(simplex));
  rowsOf(simplex.samples, dim_, rows_);
  sumOverPoints(tables.weighted.data(), simplex.samples.rule.size(), all_.size(), simplex.measure,
                simplex.samples.values.data(), size, moments_.data());
  scaled_.resize(modes * size);
  for (std::size_t i = 0; i < scaled_.size(); ++i)
    scaled_[i] = moments_[i] / simplex.measure;
  return std::sqrt(simplex.measure * squareOfRest(tables.values.data(), modes, tables.weights.size(), scaled_.data(),
                                                  rows_.data(), size, tables.weights.data()));
}

/// The same of a projection, whose functions the basis begins with, or it with the basis.
double LoadMoments::takeProjection(const LoadedSimplex& simplex)
{
  const auto size = std::size_t(dim_), given = std::size_t(simplex.functions) * size;
  for (std::size_t i = 0; i < moments_.size(); ++i)
    moments_[i] = i < given ? simplex.measure * simplex.projection[i] : 0.0;
  double square = simplex.samples.rest * simplex.samples.rest;
  for (std::size_t i = std::size_t(fine_.size()) * size; i < given; ++i)
    square += simplex.projection[i] * simplex.projection[i];
  return std::sqrt(simplex.measure * square);
}

/// A projection may have been made on fewer functions than the finer basis has.
bool LoadMoments::isOrthogonalToAll(const LoadedSimplex& simplex) const
{
  return simplex.projection == nullptr || simplex.functions >= fine_.size();
}

/// rest: |q - q_h| for q_h with the moments of the finer basis.
void LoadMoments::addRemainder(const LoadedSimplex& simplex, double rest)
{
  const double root = std::sqrt(simplex.measure), small = roundOff * simplex.samples.scale * root;
  double others = isOrthogonalToAll(simplex) ? 0.0 : std::exchange(rest, 0.0);
  if (isPiecewise_)
    others += distanceToPiecewise(simplex, {moments_.begin(), moments_.begin() + std::ptrdiff_t(dim_ + 1) * dim_}, dim_,
                                  dim_);
  others += 2.0 * dim_ * simplex.samples.spread * root; // of the samples and of the data
  if (rest + others > small) {
    result_.rest = rest;
    result_.others = others;
  }
  const std::size_t size = std::size_t(dim_), end = std::size_t(fine_.size()) * size;
  double largest = 0.0, square = 0.0;
  for (std::size_t i = carried_ * size; i < end; ++i) {
    largest = std::max(largest, std::abs(moments_[i]));
    square += moments_[i] * moments_[i];
  }
  if (largest <= small * root)
    return;
  result_.beyond.assign(moments_.begin(), moments_.begin() + std::ptrdiff_t(end));
  std::fill_n(result_.beyond.begin(), carried_ * size, 0.0);
  result_.beyondNorm = std::sqrt(square / simplex.measure);
}

const SimplexMoments& LoadMoments::of(const LoadedSimplex& simplex)
{
  result_.beyond.clear();
  result_.rest = result_.others = result_.beyondNorm = 0.0;
  if (simplex.projection != nullptr || !simplex.samples.pieces.empty()) {
    moments_.resize(std::size_t(all_.size()) * std::size_t(dim_));
    const double rest = simplex.projection != nullptr ? takeProjection(simplex) : takeSamples(simplex);
    addShares(std::size_t(dim_));
    addRemainder(simplex, rest);
    return result_;
  }
  const std::size_t vertices = std::size_t(basis_.dim()) + 1, size = std::size_t(dim_); // constant
  forces_.resize(vertices * size);
  for (std::size_t i = 0; i < forces_.size(); ++i)
    forces_[i] = simplex.measure / double(vertices) * simplex.samples.values[i % size];
  spreadForces();
  return result_;
}

} // namespace ndframe
