#include "ndframe/admissibility/contact_oscillation.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ndframe/admissibility/turning_normal.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "oscillation.hpp"

namespace ndframe
{
namespace
{

constexpr int richestDegree = 3; ///< of stresses
constexpr double roundOff = 1e-13;

/// `dim` components, mode by mode, as columns.
DenseMatrix byModes(const Vector& components, int dim)
{
  DenseMatrix columns(int(components.size()) / dim, dim);
  for (int k = 0; k < columns.rows(); ++k)
    for (int i = 0; i < dim; ++i)
      columns(k, i) = components[std::size_t(dim) * std::size_t(k) + std::size_t(i)];
  return columns;
}

/// One body's part.
class BodyOscillation
{
public:
  BodyOscillation(const BodyModel& body, OscillationBound bound)
      : body_(body), dim_(body.mesh.dim),
        lifted_(dim_ == 2 || bound == OscillationBound::Sharp ? numFacetModes(dim_, richestDegree) : 0)
  {}

  /// rest: moments along the patch in the body's own modes, `dim` components. Linear modes, the first `dim`, are
  /// carried: what is there is round-off.
  void add(const ContactPatch& patch, std::size_t side, const DenseMatrix& rest)
  {
    const Facet facet = patch.sides[side].facet;
    double quadratic = 0.0, above = 0.0;
    for (int i = 0; i < dim_; ++i)
      for (int k = std::max(dim_, lifted_); k < rest.rows(); ++k)
        (k < numFacetModes(dim_, 2) ? quadratic : above) += rest(k, i) * rest(k, i);
    if (lifted_ > 0)
      lift(facet, sideSign(side), rest);
    if (quadratic + above > 0.0) {
      double normal[3];
      const double measure = side == 0 || !patch.isDrawnApart ? patch.measure : facetNormal(body_.mesh, facet, normal);
      beyond_[facet.cell] += facetOscillationConstant(body_.mesh, facet) / std::sqrt(measure) *
                             (std::sqrt(quadratic) + shareBeyondPolynomials(dim_, 2) * std::sqrt(above));
    }
  }

  Vector squares() const
  {
    Vector result(std::size_t(body_.mesh.numCells()), 0.0);
    for (const auto& [cell, correction] : carried_)
      result[std::size_t(cell)] = energy(cell, correction);
    const Vector stiffness = smallestStiffness(body_.laws);
    for (const auto& [cell, size] : beyond_) {
      double& square = result[std::size_t(cell)];
      square = std::pow(std::sqrt(square) + size / std::sqrt(stiffness[std::size_t(body_.laws.number(cell))]), 2);
    }
    return result;
  }

private:
  void lift(Facet facet, double sign, const DenseMatrix& rest)
  {
    StressCorrection& correction = carried_[facet.cell];
    if (correction.tractions.empty()) { // of this cell alone
      const ReferenceStress& reference = referenceStress(dim_, richestDegree);
      correction = {dim_, richestDegree, Vector(std::size_t(reference.tractions), 0.0),
                    Vector(std::size_t(reference.loads), 0.0)};
    }
    double* traction = correction.tractions.data() + std::ptrdiff_t(sortedFacet(body_.mesh, facet)) * lifted_ * dim_;
    for (int k = dim_; k < std::min(rest.rows(), lifted_); ++k)
      for (int i = 0; i < dim_; ++i)
        traction[dim_ * k + i] += sign * rest(k, i);
  }

  double energy(int cell, const StressCorrection& correction) const
  {
    const ReferenceStress& reference = referenceStress(dim_, richestDegree);
    const Elasticity& law = body_.laws(cell);
    SplitStress stress{dim_, richestDegree, sortedCell(body_.mesh, cell), {}, {}};
    stress.map = cellMap(body_.mesh, stress.cell);
    stress.coefficients =
        CellForm(reference, stress.map, law).coefficients(pullBack(reference, stress.map, correction, 0));
    return stress.energy(law);
  }

  const BodyModel& body_;
  int dim_, lifted_;                        ///< of space; the modes that a stress carries, none with constants alone
  std::map<int, StressCorrection> carried_; ///< per cell
  std::map<int, double> beyond_;            ///< per cell, what is bounded by constants
};

} // namespace

std::vector<CellValues> contactOscillation(const std::vector<const BodyModel*>& bodies,
                                           const std::vector<ContactPatch>& patches, const ContactTraction& traction,
                                           OscillationBound bound)
{
  if (traction.vectors.empty())
    return {};
  std::vector<BodyOscillation> parts;
  for (const BodyModel* body : bodies)
    parts.emplace_back(*body, bound);
  const int dim = traction.dim, fine = std::max(traction.degree + 1, richestDegree);
  const EndTables modes = turningModes(dim, traction.degree, fine);
  OrderedModes inOrder(dim, fine);
  const std::size_t carried = traction.numModes() * std::size_t(dim);
  for (std::size_t f = 0; f < patches.size(); ++f) {
    const ContactPatch& patch = patches[f];
    if (!patch.turns)
      continue;
    Vector rest = turned(modes, patch, traction.moments(int(f)));
    const double size = norm(rest);
    for (std::size_t i = 0; i < std::size_t(dim) * carried; ++i)
      rest[i % carried] -= traction.vectors[f * std::size_t(dim) * carried + i];
    if (norm(rest) <= roundOff * size)
      continue;
    for (std::size_t side = 0; side < 2; ++side)
      if (const auto body = std::size_t(patch.sides[side].body); !bodies[body]->isRigid)
        parts[body].add(patch, side, multiply(inOrder(patch.sides[side]), byModes(rest, dim)));
  }
  std::vector<CellValues> squares;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    squares.push_back(
        ofCells(bodies[b]->isRigid ? Vector(std::size_t(bodies[b]->mesh.numCells()), 0.0) : parts[b].squares()));
  return squares;
}

} // namespace ndframe
