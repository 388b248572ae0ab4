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

/// One body's part.
class BodyOscillation
{
public:
  explicit BodyOscillation(const BodyModel& body)
      : body_(body), lifted_(zeroCorrection(body.mesh, richestDegree)), beyond_(std::size_t(body.mesh.numCells()), 0.0)
  {}

  /// rest: moments along the Dirichlet body's facet, mode by mode, two components. The first two modes are carried:
  /// what is there is round-off.
  void add(const ContactFacet& contact, bool isDirichlet, const Vector& rest)
  {
    const Facet facet = isDirichlet ? contact.dirichlet : contact.neumann;
    const bool backwards = !isDirichlet && contact.isReversed();
    const std::size_t carried = 2 * (std::size_t(richestDegree) + 1);
    double* traction = lifted_.tractions.data() +
                       (std::size_t(facet.cell) * 3 + std::size_t(sortedFacet(body_.mesh, facet))) * carried;
    double square = 0.0;
    for (std::size_t i = 4; i < rest.size(); ++i)
      if (i < carried)
        traction[i] += (backwards && i / 2 % 2 == 1) == isDirichlet ? -rest[i] : rest[i];
      else
        square += rest[i] * rest[i];
    if (square > 0.0) {
      double normal[3];
      square /= isDirichlet || !contact.isDrawnApart ? contact.measure : facetNormal(body_.mesh, facet, normal);
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

std::vector<Vector> contactOscillation(const std::vector<const BodyModel*>& bodies,
                                       const std::vector<ContactFacet>& facets, const ContactTraction& traction)
{
  if (traction.vectors.empty())
    return {};
  std::vector<BodyOscillation> parts;
  for (const BodyModel* body : bodies)
    parts.emplace_back(*body);
  const EndTables modes = turningModes(traction.degree, std::max(traction.degree + 1, richestDegree));
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const ContactFacet& facet = facets[f];
    if (!facet.turns)
      continue;
    Vector rest = turned(modes, facet, traction.moments(int(f)));
    const double size = norm(rest);
    const auto carried = std::size_t(traction.degree + 1) * 2;
    for (std::size_t i = 0; i < 2 * carried; ++i)
      rest[i % carried] -= traction.vectors[f * 2 * carried + i];
    if (norm(rest) <= roundOff * size)
      continue;
    for (const auto& [body, isDirichlet] : {std::pair(facet.dirichletBody, true), std::pair(facet.neumannBody, false)})
      if (!bodies[std::size_t(body)]->isRigid)
        parts[std::size_t(body)].add(facet, isDirichlet, rest);
  }
  std::vector<Vector> squares;
  for (const BodyOscillation& part : parts)
    squares.push_back(part.squares());
  return squares;
}

} // namespace ndframe
