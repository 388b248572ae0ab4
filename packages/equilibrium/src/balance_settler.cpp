#include "balance_settler.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

/// Supports that resist a motion by less than this, relative, do not resist it.
constexpr double noResistance = 1e-10;

} // namespace

std::vector<char> BalanceSettler::ownOf(const BodyPiece* piece)
{
  std::vector<char> own;
  for (std::size_t cell = 0; piece != nullptr && cell < piece->cells.size(); ++cell)
    own.push_back(char(piece->owns(int(cell))));
  return own;
}

/// Sets what is known, and finds what is left.
void BalanceSettler::begin()
{
  setTractions();
  for (int cell = 0; cell < mesh_.numCells(); ++cell)
    if (isOwn(cell))
      setLoads(cell);
  for (int cell = 0; cell < mesh_.numCells(); ++cell)
    left_.push_back(isOwn(cell) ? cellWrench(cell) : Vector(std::size_t(wrenchSize(data_.dim)), 0.0));
}

Facet BalanceSettler::facetOf(int half) const
{
  const int facets = data_.dim + 1;
  return {half / facets, tree_.cell(half / facets).local[std::size_t(half % facets)]};
}

/// Moments of K eps(u~) n, outward: |f| n = - dim |E| grad lambda of the opposite vertex.
Vector BalanceSettler::elasticTraction(int half) const
{
  const int dim = data_.dim, facet = half % (dim + 1);
  const CellStress& stress = elastic_[std::size_t(half / (dim + 1))];
  Vector moments(std::size_t(facetData()), 0.0);
  for (int b = 0; b < dim; ++b) {
    double force[3] = {};
    addForce(stress, b < facet ? b : b + 1, facet, -dim * stress.measure, force);
    for (std::size_t at = 0; at < moments.size(); ++at)
      moments[at] += facetMeans_[at - at % std::size_t(dim) + std::size_t(b)] * force[at % std::size_t(dim)];
  }
  return moments;
}

/// What the loads and K eps(u~) leave to the correction in the directions without support; reactions stay.
void BalanceSettler::setOuterTraction(int half, const Vector& elastic)
{
  const Facet facet = facetOf(half);
  const Vector* given = prescribed_.moments(facet);
  const std::size_t dim = std::size_t(data_.dim);
  double* own = traction(half);
  for (std::size_t at = 0; at < elastic.size(); at += dim) {
    Direction excess{};
    for (std::size_t i = 0; i < dim; ++i)
      excess[i] = own[at + i] + elastic[at + i] - (given == nullptr ? 0.0 : (*given)[at + i]);
    excess = prescribed_.freePart(facet, excess);
    for (std::size_t i = 0; i < dim; ++i)
      own[at + i] -= excess[i];
  }
}

void BalanceSettler::setTractions()
{
  for (int half = 0; half < mesh_.numCells() * (data_.dim + 1); ++half) {
    const int twin = tree_.twin(half);
    if (twin >= 0 && twin < half)
      continue;
    const Vector elastic = elasticTraction(half);
    if (twin < 0) {
      if (isOwn(half / (data_.dim + 1))) // else another cell may be beyond it
        setOuterTraction(half, elastic);
      continue;
    }
    const Vector other = elasticTraction(twin);
    for (std::size_t i = 0; i < elastic.size(); ++i)
      traction(twin)[i] = -(traction(half)[i] + (elastic[i] + other[i]));
  }
}

/// div c = - b_h - div K eps(u~).
void BalanceSettler::setLoads(int cell)
{
  const int dim = data_.dim, size = reference_.loads;
  double* loads = correction_.loads.data() + std::ptrdiff_t(cell) * size;
  std::fill_n(loads, size, 0.0);
  for (int vertex = 0; vertex <= dim && !data_.cellShares.empty(); ++vertex) {
    const double* share = data_.cellShares.data() + (std::ptrdiff_t(cell) * (dim + 1) + vertex) * size;
    for (int i = 0; i < size; ++i)
      loads[i] -= share[i];
  }
  if (data_.order == 1)
    return;
  const CellStress& stress = elastic_[std::size_t(cell)];
  for (int vertex = 0; vertex <= dim; ++vertex) // the first load mode is 1, the others have no mean value
    addForce(stress, vertex, vertex, -stress.measure, loads);
}

Vector BalanceSettler::centre(int cell) const
{
  Vector mean(std::size_t(data_.dim), 0.0);
  for (const double* point : corners(mesh_, tree_.cell(cell), -1))
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += point[i] / (data_.dim + 1);
  return mean;
}

Vector BalanceSettler::arms(int half, const Vector& about) const
{
  const int facets = data_.dim + 1;
  return momentArms(facetMeans_, corners(mesh_, tree_.cell(half / facets), half % facets), about.data(), data_.dim);
}

void BalanceSettler::addTo(Vector& wrench, int half, const Vector& about, const Vector& traction, double sign) const
{
  addWrench(data_.dim, arms(half, about), traction.data(), sign, size_, wrench);
}

Vector BalanceSettler::cellWrench(int cell)
{
  const int dim = data_.dim;
  const Vector about = centre(cell);
  Vector wrench(std::size_t(wrenchSize(dim)), 0.0);
  for (int half = cell * (dim + 1); half < (cell + 1) * (dim + 1); ++half)
    addTo(wrench, half, about, Vector(traction(half), traction(half) + facetData()), 1.0);
  const Vector loadArms = momentArms(cellMeans_, corners(mesh_, tree_.cell(cell), -1), about.data(), dim);
  addWrench(dim, loadArms, correction_.loads.data() + std::ptrdiff_t(cell) * reference_.loads, -1.0, size_, wrench);
  return wrench;
}

void BalanceSettler::change(int half, const Vector& moments, double sign)
{
  for (std::size_t i = 0; i < moments.size(); ++i)
    traction(half)[i] += sign * moments[i];
  const int cell = half / (data_.dim + 1);
  addTo(left_[std::size_t(cell)], half, centre(cell), moments, sign);
}

/// Wrench of the reactions that supports can give on a facet, as a map of all its moments.
DenseMatrix BalanceSettler::reactions(int half, const Vector& about) const
{
  DenseMatrix map = wrenchMap(data_.dim, arms(half, about), reference_.facetModes, size_);
  for (int row = 0; row < map.rows(); ++row)
    for (int at = 0; at < map.cols(); at += data_.dim) {
      Direction all{};
      for (int i = 0; i < data_.dim; ++i)
        all[std::size_t(i)] = map(row, at + i);
      const Direction free = prescribed_.freePart(facetOf(half), all);
      for (int i = 0; i < data_.dim; ++i)
        map(row, at + i) -= free[std::size_t(i)];
    }
  return map;
}

void BalanceSettler::addTotal(const CellTree::Part& part, const Vector& about, Vector& total) const
{
  for (const int cell : part.cells) {
    const Vector moved = wrenchAbout(data_.dim, left_[std::size_t(cell)], centre(cell), about, size_);
    for (std::size_t i = 0; i < moved.size(); ++i)
      total[i] += moved[i];
  }
}

std::vector<int> BalanceSettler::supported(const CellTree::Part& part) const
{
  const int facets = data_.dim + 1;
  std::vector<int> halves;
  for (const int cell : part.cells)
    for (int half = cell * facets; half < (cell + 1) * facets; ++half)
      if (tree_.twin(half) < 0 && prescribed_.isSupported(facetOf(half)))
        halves.push_back(half);
  return halves;
}

void BalanceSettler::addResistance(const CellTree::Part& part, const Vector& about, DenseMatrix& resistance) const
{
  for (const int half : supported(part)) {
    const DenseMatrix map = reactions(half, about);
    for (int i = 0; i < map.rows(); ++i)
      for (int j = 0; j < map.rows(); ++j)
        for (int k = 0; k < map.cols(); ++k)
          resistance(i, j) += map(i, k) * map(j, k);
  }
}

/// The supports of a part of the mesh take its total wrench, by the smallest reactions that can.
void BalanceSettler::react(const CellTree::Part& part, const Vector& about, const Vector& total,
                           const DenseMatrix& resistance)
{
  const std::vector<int> halves = supported(part);
  if (halves.empty())
    return;
  const DenseMatrix motion = multiply(pseudoInverse(resistance, noResistance), DenseMatrix(total));
  for (const int half : halves)
    change(half, multiplyTransposed(reactions(half, about), motion).column(0), -1.0);
}

/// From the leaves to the root: each cell gives what it has to the next.
void BalanceSettler::handOn(const CellTree::Part& part)
{
  for (std::size_t at = part.cells.size() - 1; at > 0; --at) {
    const int cell = part.cells[at], half = part.towardsRoot[at];
    const FacetSplit split = splitFacet(data_.dim, arms(half, centre(cell)), reference_.facetModes, size_);
    const Vector moments = multiply(split.carrier, DenseMatrix(left_[std::size_t(cell)])).column(0);
    change(half, moments, -1.0);
    change(tree_.twin(half), moments, 1.0);
  }
}

/// What no other cell and no support took, moments over the size of the cell.
double BalanceSettler::largestLeft() const
{
  double largest = 0.0;
  for (int cell = 0; cell < mesh_.numCells(); ++cell) {
    const Vector& wrench = left_[std::size_t(cell)];
    const double arm = size_ / std::pow(cellMeasure(mesh_, cell), 1.0 / data_.dim);
    for (std::size_t i = 0; i < wrench.size() && isOwn(cell); ++i)
      largest = std::max(largest, std::abs(wrench[i]) * (int(i) < data_.dim ? 1.0 : arm));
  }
  return largest;
}

} // namespace ndframe
