#pragma once

#include <string>

#include "assembly/sample_body.hpp"
#include "ndframe/admissibility/contact_traction.hpp"

namespace ndframe::test
{

/// Two boxes of 1 x 1 on top of each other, the upper one the Dirichlet body, touching along y = 1; both meshes are
/// numbered at random, so that some facets run against each other.
struct ContactStrip
{
  std::vector<BodyModel> bodies; ///< upper, lower
  std::vector<ConstraintSet> constraints;
  std::vector<ContactPatch> patches;

  std::vector<const BodyModel*> bodyPointers() const;
  std::vector<const ConstraintSet*> constraintPointers() const;
  /// Displacement of a body at the interface node `number` of a facet (0, 1 vertices, 2 middle).
  const double* at(const std::vector<NodalField>& displacement, std::size_t patch, std::size_t number,
                   bool isUpper) const;
  /// The jump (u1 - u2) . n at t on a facet, from its first vertex to its second.
  double jump(const std::vector<NodalField>& displacement, std::size_t patch, double t) const;
  /// The point at t.
  std::array<double, 2> point(std::size_t patch, double t) const;
};

/// bend: the slope of the interface for x > 0.5 (flat before).
ContactStrip contactStrip(int numFacets, int order, double bend = 0.0, const Conditions& upper = {},
                          const Conditions& lower = {});

/// The same with a normal that turns along the facets (turnFacets).
ContactStrip turningStrip(int numFacets, int order, double bend);

/// What tests go through.
struct Strip
{
  int order;
  double bend;
  bool turns = false;
};
constexpr Strip strips[] = {{1, 0.0}, {2, 0.0}, {1, 0.6}, {2, 0.6}, {1, 0.6, true}, {2, 0.6, true}};
inline std::string nameOf(const Strip& strip)
{
  return "Order" + std::to_string(strip.order) + (strip.turns ? "Turning" : strip.bend > 0.0 ? "Bent" : "Flat");
}

} // namespace ndframe::test
