#pragma once

#include <memory>
#include <string>

#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/interface/body_trace.hpp"
#include "ndframe/interface/interface_mesh.hpp"

namespace ndframe::test
{

// Entries of a deck's list.
std::string doubles(const std::string& key, const std::string& values);
std::string ints(const std::string& key, const std::string& values);
std::string text(const std::string& key, const std::string& value);
std::string list(const std::string& name, const std::string& entries);

/// "Lower", "Upper" and "Cells" of a box.
std::string box(const std::string& lower, const std::string& upper, const std::string& cells);

/// A box of an isotropic material with the given `Mesh` entries and supports (named lists).
BodyModel boxBody(const std::string& name, const std::string& meshEntries, int order, const std::string& supports = {});
/// Every cell becomes 2^dim.
void refine(BodyModel& body);

/// The same body with its points and cells numbered the other way round.
BodyModel renumbered(const BodyModel& body);

/// An entry of `Interfaces`, called "contact", with these values.
InterfaceSettings interfaceEntry(const std::string& dirichletSide, const std::string& neumannSide,
                                 const std::string& gap = "0", double cornerAngle = 35.0);

/// A body assembled and condensed on the traces.
struct CondensedBox
{
  CondensedBox(const BodyModel& model, const std::vector<TraceNormal>& traces);

  Ledger ledger;
  ConstraintSet constraints;
  BodySystem system;
  SolverProblem problem;
  std::unique_ptr<CondensedBody> condensed;
};

/// The interface operator of that type; `entries` are further entries of its list.
std::unique_ptr<InterfaceOperator> makeInterfaceOperator(const std::string& type, const std::string& entries = {});

/// A stored matrix that only shows its products.
std::shared_ptr<const SymmetricOperator> appliedOnly(DenseMatrix A, double tolerance = 1e-14);

/// A rectangle's side y = 0, split at these x coordinates, as an interface seen from above.
InterfaceMesh straightInterface(const std::vector<double>& x, int order);

} // namespace ndframe::test
