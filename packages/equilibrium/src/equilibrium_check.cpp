#include "ndframe/equilibrium/equilibrium_check.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/equilibrium/sub_cell.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "prescribed_tractions.hpp"

namespace ndframe
{
namespace
{

/// A stress that is this small beside the terms that cancel in it shows their round-off: nothing is measured beside it.
constexpr double visibleRoundOff = 1e-3;

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
      result[std::size_t(i)] += (a == 0 ? -1.0 : (a == k ? 1.0 : 0.0)) *
                                map.inverse[std::size_t(k - 1) * std::size_t(map.dim) + std::size_t(i)];
  return result;
}

/// The smallest height: a load b in the cell amounts to tractions of b times it.
double cellHeight(const Mesh& mesh, int cell)
{
  double largest = 0.0, normal[3];
  for (int facet = 0; facet <= mesh.dim; ++facet)
    largest = std::max(largest, facetNormal(mesh, {cell, facet}, normal));
  return mesh.dim * cellMeasure(mesh, cell) / largest;
}

/// Goes through the cells once; tractions wait on their facet for the neighbour's. Defects are absolute until all cells
/// have been seen. Points are enough to determine the polynomials: tractions of degree q, divergences of q - 1.
class EquilibriumSearch
{
public:
  EquilibriumSearch(const BodyModel& body, const StaticData& data, const FieldInput& field)
      : body_(body), displacement_(*field.displacement), mesh_(body.mesh), data_(data), prescribed_(body, data, field),
        load_(loadBasis(data.dim, data.degree)), cellRule_(simplexRule(data.dim, 2 * (data.degree - 1))),
        facetRule_(simplexRule(data.dim - 1, 2 * data.degree))
  {}

  /// Of a cell that another rank owns.
  void addGhost(const SplitStress& stress, int cell)
  {
    for (int facet = 0; facet <= mesh_.dim; ++facet)
      addFacet(stress, {cell, stress.cell.local[std::size_t(facet)]}, facet);
  }

  void addCell(const SplitStress& stress, int cell)
  {
    scale_ = std::max(scale_, visibleRoundOff * stressOfSums(stress.map, cell));
    checkDivergence(stress, cell);
    checkInside(stress);
    addGhost(stress, cell);
  }

  /// The boundary of cells for which isOwn(cell) holds.
  EquilibriumDefects finish(const std::function<bool(int)>& isOwn);

private:
  struct Waiting
  {
    Facet facet;
    std::vector<Direction> tractions; ///< outward
  };

  double stressOfSums(const CellMap& map, int cell) const;
  Direction traction(const SplitStress& stress, int sub, const double* lambda, const Direction& normal);
  Direction bodyForce(int cell, const double* lambda) const;
  void checkDivergence(const SplitStress& stress, int cell);
  void checkInside(const SplitStress& stress);
  void addFacet(const SplitStress& stress, Facet facet, int sorted);
  void checkBoundary(const Waiting& outer);

  const BodyModel& body_;
  const Vector& displacement_;
  const Mesh& mesh_;
  const StaticData& data_;
  PrescribedTractions prescribed_;
  MomentBasis load_;
  QuadratureRule cellRule_, facetRule_;
  std::map<std::array<int, 3>, Waiting> waiting_; ///< by the facet's vertices
  EquilibriumDefects defects_;
  double scale_ = 0.0; ///< largest stress, traction or load
};

/// What the terms of K eps(u) would amount to if they did not cancel: largest modulus, gradient and displacement.
double EquilibriumSearch::stressOfSums(const CellMap& map, int cell) const
{
  double modulus = 0.0, slope = 0.0, displacement = 0.0;
  for (const double entry : body_.laws(cell).D)
    modulus = std::max(modulus, std::abs(entry));
  for (int a = 0; a <= mesh_.dim; ++a)
    slope = std::max(slope, largestOf(gradient(map, a)));
  const int nodes = body_.nodes.nodesPerCell;
  for (int n = 0; n < nodes; ++n)
    for (int i = 0; i < mesh_.dim; ++i)
      displacement = std::max(
          displacement,
          std::abs(displacement_[std::size_t(body_.nodes.cell(cell)[n]) * std::size_t(mesh_.dim) + std::size_t(i)]));
  return modulus * slope * displacement;
}

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
    scale_ = std::max(scale_, std::abs(sigma[s]));
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
  const double height = cellHeight(mesh_, cell);
  for (int sub = 0; sub <= mesh_.dim; ++sub)
    for (int q = 0; q < cellRule_.size(); ++q) {
      double lambda[4];
      SubCell{mesh_.dim, sub}.simplexCoordinates(cellRule_.point(q), lambda);
      Direction divergence{};
      stress.divergence(sub, lambda, divergence.data());
      const Direction force = bodyForce(cell, lambda);
      defects_.divergence = std::max(defects_.divergence, height * largestOf(sum(divergence, force)));
      scale_ = std::max(scale_, height * largestOf(force));
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
    scale_ = std::max(scale_, largestOf(given));
  }
}

EquilibriumDefects EquilibriumSearch::finish(const std::function<bool(int)>& isOwn)
{
  for (const auto& [vertices, outer] : waiting_)
    if (isOwn(outer.facet.cell))
      checkBoundary(outer);
  const double factor = scale_ > 0.0 ? 1.0 / scale_ : 0.0;
  return {defects_.divergence * factor, defects_.interior * factor, defects_.jumps * factor, defects_.loads * factor,
          scale_};
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
  return search.finish([](int) { return true; });
}

EquilibriumDefects checkEquilibrium(const BodyPiece& piece, const FieldInput& field, const StressCorrection& correction,
                                    const Comm& comm)
{
  NDFRAME_ASSERT(field.displacement != nullptr && piece.data.degree == correction.degree,
                 "data and stress do not match");
  EquilibriumSearch search(piece.model, piece.data, field);
  for (int cell = 0; cell < piece.model.mesh.numCells(); ++cell) {
    const SplitStress stress = equilibratedStress(piece.model, *field.displacement, correction, cell);
    piece.owns(cell) ? search.addCell(stress, cell) : search.addGhost(stress, cell);
  }
  const EquilibriumDefects own = search.finish([&](int cell) { return piece.owns(cell); });
  Vector all{own.divergence * own.scale, own.interior * own.scale, own.jumps * own.scale, own.loads * own.scale,
             own.scale};
  takeLargest(all, comm);
  const double factor = all[4] > 0.0 ? 1.0 / all[4] : 0.0;
  return {all[0] * factor, all[1] * factor, all[2] * factor, all[3] * factor, all[4]};
}

} // namespace ndframe
