#pragma once

#include "ndframe/interface/body_trace.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// The interface nodes of one body whose normal displacement is free.
struct BodyTraceNodes
{
  std::vector<TraceNormal> traces;
  std::vector<int> unknowns;
  std::vector<ContactRole> roles;
  std::vector<const double*> points;
  /// Per node, what its unknown makes of the normal displacements: itself, or a Bernstein coefficient. Constants come
  /// from nodes where supports hold the body.
  AffineRows coefficients;

  /// Without those that depend on others. Coefficients stay as they are.
  BodyTraceNodes without(const std::vector<DependentTrace>& dependents) const;
};

/// Numbers the unknowns of all interfaces, with their gaps and obstacles in the basis of the model's conditions, and
/// hands each to its bodies that are free there.
std::vector<BodyTraceNodes> numberUnknowns(const Model& model, InterfaceSystem& system);

/// How the values of a body's trace depend on its kept dofs, and its unknowns that depend on others.
struct BodyTraceMap
{
  AffineRows coefficients; ///< the values from the normal displacements
  TraceMap map;            ///< from the kept dofs
  std::vector<DependentUnknown> dependents;
};
BodyTraceMap mapOf(const BodyTraceNodes& nodes, const DofLayout& layout);

} // namespace ndframe
