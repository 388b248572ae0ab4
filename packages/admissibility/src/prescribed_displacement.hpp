#pragma once

#include <vector>

#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// The displacement that all supports of a facet prescribe together, as a vector along their directions: linear in the
/// functions of all of them.
class PrescribedDisplacement
{
public:
  PrescribedDisplacement(const BodyModel& body, std::vector<const Support*> supports);

  const std::vector<SampledFunction>& functions() const { return functions_; }
  /// u (dim components) from the functions' values.
  void displacement(const double* values, double* u) const;
  /// For values of at most 1 no component of u is larger.
  double gain() const;
  /// At a facet's nodes, node by node.
  Vector atNodes(Facet facet) const;

private:
  const BodyModel& body_;
  std::vector<const Support*> supports_;
  std::vector<SampledFunction> functions_;
};

/// Facets that the same supports hold.
struct HeldFacets
{
  std::vector<const Support*> supports;
  std::vector<Facet> facets;
};

/// The facets on which what is prescribed varies.
std::vector<HeldFacets> varyingFacets(const BodyModel& body);

} // namespace ndframe
