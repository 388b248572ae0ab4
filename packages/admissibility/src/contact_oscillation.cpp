#include "ndframe/admissibility/contact_oscillation.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/admissibility/turning_normal.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/simd/cell_distances.hpp"
#include "oscillation.hpp"

namespace ndframe
{
namespace
{

constexpr int richestDegree = 3; ///< of plane stresses
constexpr double roundOff = 1e-13;

/// Two components, mode by mode, as columns.
DenseMatrix byModes(const Vector& components)
{
  DenseMatrix columns(int(components.size()) / 2, 2);
  for (int k = 0; k < columns.rows(); ++k)
    for (int i = 0; i < 2; ++i)
      columns(k, i) = components[2 * std::size_t(k) + std::size_t(i)];
  return columns;
}

/// One body's part.
class BodyOscillation
{
public:
  explicit BodyOscillation(const BodyModel& body)
      : body_(body), lifted_(zeroCorrection(body.mesh, richestDegree)), beyond_(std::size_t(body.mesh.numCells()), 0.0)
  {}

  /// rest: moments along the patch in the body's own modes, two components. The first two modes are carried: what is
  /// there is round-off.
  void add(const ContactPatch& patch, std::size_t side, const DenseMatrix& rest)
  {
    const Facet facet = patch.sides[side].facet;
    const std::size_t place = std::size_t(facet.cell) * 3 + std::size_t(sortedFacet(body_.mesh, facet));
    double* traction = lifted_.tractions.data() + place * 2 * (std::size_t(richestDegree) + 1);
    double square = 0.0;
    for (int k = 2; k < rest.rows(); ++k)
      for (int i = 0; i < 2; ++i)
        if (k <= richestDegree)
          traction[2 * k + i] += sideSign(side) * rest(k, i);
        else
          square += rest(k, i) * rest(k, i);
    if (square > 0.0) {
      double normal[3];
      square /= side == 0 || !patch.isDrawnApart ? patch.measure : facetNormal(body_.mesh, facet, normal);
      beyond_[std::size_t(facet.cell)] += facetOscillationConstant(body_.mesh, facet) * std::sqrt(square);
    }
  }

  Vector squares() const
  {
    if (body_.isRigid)
      return beyond_;
    Vector result = cellDistances(body_, lifted_, nullptr);
    const Vector stiffness = smallestStiffness(body_.laws);
    for (std::size_t cell = 0; cell < result.size(); ++cell)
      result[cell] = std::pow(
          std::sqrt(result[cell]) + beyond_[cell] / std::sqrt(stiffness[std::size_t(body_.laws.number(int(cell)))]), 2);
    return result;
  }

private:
  const BodyModel& body_;
  StressCorrection lifted_; ///< carries the rest
  Vector beyond_;           ///< per cell, of higher degree
};

} // namespace

std::vector<CellValues> contactOscillation(const std::vector<const BodyModel*>& bodies,
                                           const std::vector<ContactPatch>& patches, const ContactTraction& traction)
{
  if (traction.vectors.empty())
    return {};
  std::vector<BodyOscillation> parts;
  for (const BodyModel* body : bodies)
    parts.emplace_back(*body);
  const int fine = std::max(traction.degree + 1, richestDegree);
  const EndTables modes = turningModes(traction.degree, fine);
  OrderedModes inOrder(2, fine);
  for (std::size_t f = 0; f < patches.size(); ++f) {
    const ContactPatch& patch = patches[f];
    if (!patch.turns)
      continue;
    Vector rest = turned(modes, patch, traction.moments(int(f)));
    const double size = norm(rest);
    const auto carried = std::size_t(traction.degree + 1) * 2;
    for (std::size_t i = 0; i < 2 * carried; ++i)
      rest[i % carried] -= traction.vectors[f * 2 * carried + i];
    if (norm(rest) <= roundOff * size)
      continue;
    for (std::size_t side = 0; side < 2; ++side)
      if (const auto body = std::size_t(patch.sides[side].body); !bodies[body]->isRigid)
        parts[body].add(patch, side, multiply(inOrder(patch.sides[side]), byModes(rest)));
  }
  std::vector<CellValues> squares;
  for (const BodyOscillation& part : parts)
    squares.push_back(ofCells(part.squares()));
  return squares;
}

} // namespace ndframe
