#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/interface/body_trace.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// The scene assembled, factored and condensed to the interfaces: what every sweep, tolerance and load case works on.
struct CondensedModel
{
  std::vector<BodySystem> systems;                       ///< per body; the factors refer to their matrices
  std::vector<SparseField> loads;                        ///< effective loads, per body
  std::vector<std::unique_ptr<CondensedBody>> condensed; ///< per body: its factor
  InterfaceSystem interface;                             ///< no unknowns without interfaces
  std::vector<std::vector<int>> ranks;                   ///< per body and vertex, which rank has its rows
  SceneRecipe recipe;                                    ///< of the model that was condensed
  std::vector<int> exchanged;                            ///< bodies whose roles were exchanged since then, ascending
  int threads = 1;                                       ///< that may solve with different bodies at the same time

  /// The trace of a body, null if it touches nothing.
  const BodyTrace* trace(int body) const;
};

/// The bodies' systems with their interface normals as dofs, in the state in which condense() factors them.
std::vector<BodySystem> assembleSystems(const Model& model, const Comm& comm);

/// What a linear solver needs to know of a body; points to the system's matrix.
SolverProblem solverProblem(const Model& model, int body, const BodySystem& system);

/// Lets solvers be chosen that solve solids in contact whole, where the coupling takes that and the list of the
/// interface operator, `representation`, leaves it open.
void offerWhole(Model& model, const Coupling& coupling, const Params& representation);

/// Told of every body that is factored, and how.
using FactorObserver = std::function<void(const std::string& body, const std::string& description)>;

/// Gives back what bodies that are solved by iterations have for that, their matrices included: most of the memory of a
/// scene of solids. Solutions and the layouts of dofs stay.
void giveBackStiffness(CondensedModel& condensed);
/// The matrices again, where they were given back; solvers set up again by themselves what they need.
void assembleAgain(CondensedModel& condensed, const Model& model, Ledger& ledger);

/// One factorisation per body, whatever follows.
///
/// What `previous` was made from in the same way is taken over ("factors reused" in the ledger, which must be the one
/// that those factors count in): the factor of a body whose mesh, material, linear solver, fixed dofs and interface
/// nodes are the same, and with the same loads and prescribed values its reduced load. Another load, prescribed value
/// or representation of the interface costs a back-solve a touching body.
CondensedModel condense(const Model& model, const LinearSolver& solver, const InterfaceOperator& representation,
                        const Comm& comm, Ledger& ledger, CondensedModel previous = {},
                        const FactorObserver& onFactor = {});

} // namespace ndframe
