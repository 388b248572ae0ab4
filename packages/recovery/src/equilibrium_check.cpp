#include "ndframe/recovery/equilibrium_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "prescribed_tractions.hpp"
#include "sub_cell.hpp"

namespace ndframe
{
namespace
{

double largestOf(const Direction& vector)
{
  return std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
}

Direction sum(Direction a, const Direction& b, double factor = 1.0)
{
  for (std::size_t i = 0; i < 3; ++i)
    a[i] += factor * b[i];
  return a;
}

/// Gradient of lambda_a, a in sorted order.
Direction gradient(const CellMap& map, int a)
{
  Direction result{};
  for (int k = 1; k <= map.dim; ++k)
    for (int i = 0; i < map.dim; ++i)
      result[std::size_t(i)] +=
          (a == 0 ? -1.0 : (a == k ? 1.0 : 0.0)) * map.inverse[std::size_t((k - 1) * map.dim + i)];
  return result;
}

/// Length of the longest edge.
double cellSize(const Mesh& mesh, int cell)
{
  double size = 0.0;
  for (int a = 0; a <= mesh.dim; ++a)
    for (int b = 0; b < a; ++b) {
      double square = 0.0;
      for (int i = 0; i < mesh.dim; ++i)
        square += std::pow(mesh.point(mesh.cell(cell)[a])[i] - mesh.point(mesh.cell(cell)[b])[i], 2);
      size = std::max(size, std::sqrt(square));
    }
  return size;
}

/// Goes through the cells once; tractions wait on their facet for the neighbour's. Defects are absolute until all cells
/// have been seen. Points are enough to determine the polynomials.
class EquilibriumSearch
{
public:
  EquilibriumSearch(const BodyModel& body, const StaticData& data, const FieldInput& field)
      : mesh_(body.mesh), data_(data), prescribed_(body, data, field), load_(loadBasis(data.dim, data.degree)),
        cellRule_(simplexRule(data.dim, 2 * data.degree)), facetRule_(simplexRule(data.dim - 1, 2 * data.degree))
  {}

  void addCell(const SplitStress& stress, int cell)
  {
    checkDivergence(stress, cell);
    checkInside(stress);
    for (int facet = 0; facet <= mesh_.dim; ++facet)
      addFacet(stress, {cell, stress.cell.local[std::size_t(facet)]}, facet);
  }

  EquilibriumDefects finish();

private:
  struct Waiting
  {
    Facet facet;
    std::vector<Direction> tractions; ///< outward
  };

  Direction traction(const SplitStress& stress, int sub, const double* lambda, const Direction& normal);
  Direction bodyForce(int cell, const double* lambda) const;
  void checkDivergence(const SplitStress& stress, int cell);
  void checkInside(const SplitStress& stress);
  void addFacet(const SplitStress& stress, Facet facet, int sorted);
  void checkBoundary(const Waiting& outer);

  const Mesh& mesh_;
  const StaticData& data_;
  PrescribedTractions prescribed_;
  MomentBasis load_;
  QuadratureRule cellRule_, facetRule_;
  std::map<std::array<int, 3>, Waiting> waiting_; ///< by the facet's vertices
  EquilibriumDefects defects_;
  double largest_ = 0.0; ///< stress, traction or load
};

Direction EquilibriumSearch::traction(const SplitStress& stress, int sub, const double* lambda, const Direction& normal)
{
  double sigma[6];
  stress.stress(sub, lambda, sigma);
  Direction result{};
  for (int i = 0; i < mesh_.dim; ++i)
    for (int j = 0; j < mesh_.dim; ++j)
      result[std::size_t(i)] += sigma[voigt(mesh_.dim, i, j)] * normal[std::size_t(j)];
  for (int s = 0; s < (mesh_.dim == 2 ? 3 : 6); ++s) {
    NDFRAME_ASSERT(std::isfinite(sigma[s]), "a stress is not a finite number");
    largest_ = std::max(largest_, std::abs(sigma[s]));
  }
  return result;
}

Direction EquilibriumSearch::bodyForce(int cell, const double* lambda) const
{
  Direction force{};
  if (data_.cellShares.empty())
    return force;
  std::vector<double> m(std::size_t(load_.size()), 0.0);
  load_.values(lambda, m.data());
  const std::size_t dim = std::size_t(mesh_.dim), perCell = (dim + 1) * m.size() * dim;
  const double* share = data_.cellShares.data() + std::size_t(cell) * perCell;
  for (std::size_t at = 0; at < perCell; ++at)
    force[at % dim] += share[at] * m[at / dim % m.size()] / cellMeasure(mesh_, cell);
  return force;
}

void EquilibriumSearch::checkDivergence(const SplitStress& stress, int cell)
{
  const double size = cellSize(mesh_, cell);
  for (int sub = 0; sub <= mesh_.dim; ++sub)
    for (int q = 0; q < cellRule_.size(); ++q) {
      double lambda[4];
      SubCell{mesh_.dim, sub}.simplexCoordinates(cellRule_.point(q), lambda);
      Direction divergence{};
      stress.divergence(sub, lambda, divergence.data());
      const Direction force = bodyForce(cell, lambda);
      defects_.divergence = std::max(defects_.divergence, size * largestOf(sum(divergence, force)));
      largest_ = std::max(largest_, size * largestOf(force));
    }
}

void EquilibriumSearch::checkInside(const SplitStress& stress)
{
  const int dim = mesh_.dim;
  for (int i = 0; i <= dim; ++i)
    for (int j = i + 1; j <= dim; ++j) {
      const Direction across = sum(gradient(stress.map, i), gradient(stress.map, j), -1.0);
      const Direction normal = sum({}, across, 1.0 / std::sqrt(dotProduct(across, across)));
      for (int q = 0; q < facetRule_.size(); ++q) {
        // The inner facet joins the barycentre to the vertices that both sub-cells have.
        double lambda[4];
        int next = 1;
        for (int a = 0; a <= dim; ++a)
          lambda[a] = facetRule_.point(q)[0] / (dim + 1) + (a == i || a == j ? 0.0 : facetRule_.point(q)[next++]);
        const Direction jump = sum(traction(stress, i, lambda, normal), traction(stress, j, lambda, normal), -1.0);
        defects_.interior = std::max(defects_.interior, largestOf(jump));
      }
    }
}

void EquilibriumSearch::addFacet(const SplitStress& stress, Facet facet, int sorted)
{
  Waiting here{facet, {}};
  Direction normal{};
  facetNormal(mesh_, facet, normal.data());
  std::array<int, 3> key{-1, -1, -1};
  for (int a = 0, next = 0; a <= mesh_.dim; ++a)
    if (a != sorted)
      key[std::size_t(next++)] = stress.cell.vertices[std::size_t(a)];
  for (int q = 0; q < facetRule_.size(); ++q) {
    double lambda[4] = {};
    for (int a = 0, next = 0; a <= mesh_.dim; ++a)
      if (a != sorted)
        lambda[a] = facetRule_.point(q)[next++];
    here.tractions.push_back(traction(stress, sorted, lambda, normal));
  }
  const auto [other, isFirst] = waiting_.emplace(key, here);
  if (isFirst)
    return;
  for (std::size_t q = 0; q < here.tractions.size(); ++q)
    defects_.jumps = std::max(defects_.jumps, largestOf(sum(here.tractions[q], other->second.tractions[q])));
  waiting_.erase(other);
}

void EquilibriumSearch::checkBoundary(const Waiting& outer)
{
  for (int q = 0; q < facetRule_.size(); ++q) {
    const Direction given = prescribed_.value(outer.facet, facetRule_.point(q));
    const Direction difference = sum(outer.tractions[std::size_t(q)], given, -1.0);
    defects_.loads = std::max(defects_.loads, largestOf(prescribed_.freePart(outer.facet, difference)));
    largest_ = std::max(largest_, largestOf(given));
  }
}

EquilibriumDefects EquilibriumSearch::finish()
{
  for (const auto& [vertices, outer] : waiting_)
    checkBoundary(outer);
  const double scale = largest_ > 0.0 ? 1.0 / largest_ : 0.0;
  return {defects_.divergence * scale, defects_.interior * scale, defects_.jumps * scale, defects_.loads * scale};
}

} // namespace

double EquilibriumDefects::largest() const
{
  return std::max({divergence, interior, jumps, loads});
}

EquilibriumDefects checkEquilibrium(const BodyModel& body, const StaticData& data, const FieldInput& field,
                                    const StressCorrection& correction)
{
  NDFRAME_ASSERT(field.displacement != nullptr && data.degree == correction.degree, "data and stress do not match");
  EquilibriumSearch search(body, data, field);
  for (int cell = 0; cell < body.mesh.numCells(); ++cell)
    search.addCell(equilibratedStress(body, *field.displacement, correction, cell), cell);
  return search.finish();
}

} // namespace ndframe
