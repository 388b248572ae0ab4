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
  std::vector<char> onDirichletSide;
  std::vector<const double*> points;

  /// Without those that depend on others.
  BodyTraceNodes without(const std::vector<DependentTrace>& dependents) const;
};

/// Numbers the unknowns of all interfaces and hands each to its bodies that are free there.
std::vector<BodyTraceNodes> numberUnknowns(const Model& model, InterfaceSystem& system);

} // namespace ndframe
