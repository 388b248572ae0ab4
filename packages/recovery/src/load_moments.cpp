#include "load_moments.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

/// What a load may differ from its polynomial by, relative to its size, and still be that polynomial.
constexpr double roundOff = 1e-12;

/// Where the simplex's vertices stand in ascending order.
std::array<int, 4> ascendingPlaces(const LoadedSimplex& simplex)
{
  const int count = simplex.samples.rule.dim + 1;
  std::array<int, 4> places{};
  for (int v = 0; v < count; ++v)
    places[std::size_t(v)] = int(std::count_if(simplex.vertices.begin(), simplex.vertices.begin() + count,
                                               [&](int w) { return w < simplex.vertices[std::size_t(v)]; }));
  return places;
}

/// int phi_a q m_k per vertex, mode and component.
std::vector<double> hatMoments(const LoadedSimplex& simplex, const BasisSamples& at, int components)
{
  const auto vertices = std::size_t(at.dim + 1), modes = std::size_t(at.modes), size = std::size_t(components);
  std::vector<double> moments(vertices * modes * size, 0.0);
  for (std::size_t g = 0; g < std::size_t(simplex.samples.rule.size()); ++g) {
    const double weight = simplex.measure * simplex.samples.rule.weights[g];
    for (std::size_t a = 0; a < vertices; ++a)
      for (std::size_t k = 0; k < modes; ++k) {
        const double factor = weight * at.lambda[g * vertices + a] * at.values[g * modes + k];
        for (std::size_t i = 0; i < size; ++i)
          moments[(a * modes + k) * size + i] += factor * simplex.samples.values[g * size + i];
      }
  }
  return moments;
}

/// int q m_k per mode and component.
std::vector<double> momentsOf(const LoadedSimplex& simplex, const BasisSamples& at, int components)
{
  const auto modes = std::size_t(at.modes), size = std::size_t(components);
  std::vector<double> moments(modes * size, 0.0);
  for (std::size_t g = 0; g < std::size_t(simplex.samples.rule.size()); ++g)
    for (std::size_t k = 0; k < modes; ++k) {
      const double factor = simplex.measure * simplex.samples.rule.weights[g] * at.values[g * modes + k];
      for (std::size_t i = 0; i < size; ++i)
        moments[k * size + i] += factor * simplex.samples.values[g * size + i];
    }
  return moments;
}

/// Per vertex the force times the share of a unit force there.
std::vector<double> sharesOfForces(const std::vector<double>& forces, const Shares& unit, int vertices, int modes)
{
  const std::size_t size = forces.size() / std::size_t(vertices);
  std::vector<double> shares;
  shares.reserve(forces.size() * std::size_t(modes));
  for (int a = 0; a < vertices; ++a)
    for (int k = 0; k < modes; ++k)
      for (std::size_t i = 0; i < size; ++i)
        shares.push_back(forces[std::size_t(a) * size + i] * vertices * unit.ofOne(a)[k]);
  return shares;
}

/// |q - q_h| for q_h with these moments.
double distance(const LoadedSimplex& simplex, const BasisSamples& at, const std::vector<double>& moments)
{
  const std::size_t modes = std::size_t(at.modes), size = moments.size() / modes;
  double square = 0.0;
  for (std::size_t g = 0; g < std::size_t(simplex.samples.rule.size()); ++g)
    for (std::size_t i = 0; i < size; ++i) {
      double rest = simplex.samples.values[g * size + i];
      for (std::size_t k = 0; k < modes; ++k)
        rest -= moments[k * size + i] * at.values[g * modes + k] / simplex.measure;
      square += simplex.measure * simplex.samples.rule.weights[g] * rest * rest;
    }
  return std::sqrt(square);
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

LoadMoments::LoadMoments(int dim, int order, const MomentBasis& basis, const MomentBasis& fine, int carried,
                         bool isPiecewise)
    : dim_(dim), order_(order), isPiecewise_(isPiecewise), basis_(basis),
      constant_(MomentBasis::polynomials(basis.dim(), 0)), fine_(fine), carried_(std::size_t(carried)),
      unit_(basis, order)
{}

LoadMoments LoadMoments::onFacets(int dim, int order, int degree, int fine)
{
  const MomentBasis basis = facetBasis(dim, degree);
  const int carried = order == 1 ? dim : basis.size(); // order 1: affine functions
  return LoadMoments(dim, order, basis, facetBasis(dim, fine), carried, false);
}

LoadMoments LoadMoments::inCells(int dim, int order, int degree, int fine)
{
  const MomentBasis basis = loadBasis(dim, degree);
  return LoadMoments(dim, order, basis, MomentBasis::polynomials(dim, std::max(1, fine - 1)), basis.size(),
                     degree == 1);
}

/// Most simplices are one piece, so that their points are those of a rule in one of a few orders of the vertices.
const BasisSamples& LoadMoments::samplesOf(const LoadedSimplex& simplex, const MomentBasis& basis, int number) const
{
  const Samples& samples = simplex.samples;
  const auto places = ascendingPlaces(simplex);
  const bool isWhole = samples.pieces.size() == 1;
  if (isWhole)
    if (const auto known = known_.find({number, samples.pieces.front().rule, places}); known != known_.end())
      return known->second;
  BasisSamples at{basis.dim(), basis.size(), {}, {}};
  const auto vertices = std::size_t(at.dim + 1), modes = std::size_t(at.modes),
             points = std::size_t(samples.rule.size());
  at.lambda.resize(points * vertices);
  at.values.resize(points * modes);
  for (std::size_t g = 0; g < points; ++g) {
    for (std::size_t v = 0; v < vertices; ++v)
      at.lambda[g * vertices + std::size_t(places[v])] = samples.rule.point(int(g))[v];
    basis.values(at.lambda.data() + g * vertices, at.values.data() + g * modes);
  }
  if (isWhole)
    return known_[{number, samples.pieces.front().rule, places}] = std::move(at);
  return many_[std::size_t(number)] = std::move(at);
}

std::vector<double> LoadMoments::sharesOf(const LoadedSimplex& simplex) const
{
  const int vertices = basis_.dim() + 1;
  if (simplex.samples.pieces.empty()) { // constant
    std::vector<double> forces;
    for (int i = 0; i < vertices * dim_; ++i)
      forces.push_back(simplex.measure / vertices * simplex.samples.values[std::size_t(i % dim_)]);
    return sharesOfForces(forces, unit_, vertices, basis_.size());
  }
  if (order_ == 2)
    return hatMoments(simplex, samplesOf(simplex, basis_, 0), dim_);
  return sharesOfForces(hatMoments(simplex, samplesOf(simplex, constant_, 1), dim_), unit_, vertices, basis_.size());
}

void LoadMoments::addRemainder(const LoadedSimplex& simplex, SimplexMoments& moments) const
{
  const BasisSamples& at = samplesOf(simplex, fine_, 2);
  const auto all = momentsOf(simplex, at, dim_);
  const double small = roundOff * simplex.samples.scale * std::sqrt(simplex.measure);
  moments.rest = distance(simplex, at, all);
  if (isPiecewise_)
    moments.rest += distanceToPiecewise(simplex, {all.begin(), all.begin() + (dim_ + 1) * dim_}, dim_, dim_);
  moments.rest += 2.0 * dim_ * simplex.samples.spread * std::sqrt(simplex.measure); // of the samples and of the data
  if (moments.rest <= small)
    moments.rest = 0.0;
  auto beyond = all;
  std::fill_n(beyond.begin(), carried_ * std::size_t(dim_), 0.0);
  if (std::any_of(beyond.begin(), beyond.end(),
                  [&](double moment) { return std::abs(moment) > small * std::sqrt(simplex.measure); }))
    moments.beyond = std::move(beyond);
}

SimplexMoments LoadMoments::of(const LoadedSimplex& simplex) const
{
  SimplexMoments moments{sharesOf(simplex), {}, 0.0};
  if (!simplex.samples.pieces.empty())
    addRemainder(simplex, moments);
  return moments;
}

} // namespace ndframe
