#pragma once

#include "ndframe/coupling/coupling.hpp"
#include "ndframe/interface/body_trace.hpp"
#include "ndframe/subdomain/closed_rows.hpp"
#include "ndframe/subdomain/status_method.hpp"

namespace ndframe
{

/// All bodies side by side: v, the normal displacements at their kept dofs, body after body, and the unknowns of the
/// interfaces as rows over v:
///
///   uDirichlet_i = D_i v + d_i,   uNeumann_i = N_i v + n_i,   min 1/2 v^T S v - g^T v  with  (D - N) v <= bound,
///
/// S with one block a body, bound = gap + obstacle - d + n. Where contact is asked in means (MortarSpace), the rows of
/// both sides of the conditions are those, W (D - N) and W bound, and statuses and forces belong to them. An unknown
/// may stand in rows of a body that other unknowns follow already, so that any number of interfaces may meet at a node.
struct Network
{
  std::vector<const BodyTrace*> bodies;
  std::vector<int> offsets; ///< of the bodies' first entries in v; one more at the end
  Vector g;
  std::vector<SparseRow> dirichlet, neumann; ///< D, N
  Vector dirichletOffset, neumannOffset;     ///< d, n
  std::vector<SparseRow> jump;               ///< D - N, one row a condition
  Vector bound;
  bool hasMeans = false; ///< whether conditions are W (D - N)

  int size() const { return offsets.back(); }
};

/// The system must outlive it.
Network networkOf(const InterfaceSystem& system);
/// The same without g, which may take a solve a body.
Network unloadedNetworkOf(const InterfaceSystem& system);

/// rows v + offset.
Vector rowValues(const std::vector<SparseRow>& rows, const Vector& offset, const Vector& v);

/// The motions that supports leave free, of all bodies.
std::vector<std::string> motionNames(const Network& network);

/// The closed unknowns, tightest bounds first.
std::vector<int> tightestFirst(const Network& network, const std::vector<char>& closed);

/// The forces of a traction, per condition.
Vector conditionForces(const InterfaceSystem& system, const InterfaceValues& traction);

/// What a pass found, but for its forces: the unknowns at v, and what round-off is compared with.
void setDisplacement(const Network& network, const Vector& v, StatusPass& pass);

/// Statuses of all unknowns, from those of the start.
UnilateralState findStatuses(StatusSystem& problem, const Network& network, const InterfaceSystem& system,
                             const CouplingStart& start, Ledger& ledger);

/// The state of the system at v with these statuses and forces.
InterfaceState stateAt(const Network& network, const InterfaceSystem& system, const Vector& v,
                       const UnilateralState& status);

/// Throws NotConverged, in the coupling's name, where a body's operator is only applied.
void needStoredOperators(const InterfaceSystem& system, const std::string& coupling);

/// Whether contact alone holds some body.
bool floats(const InterfaceSystem& system);

/// Whether some body takes part in more unknowns at a node than the node can follow one by one.
bool hasDependents(const InterfaceSystem& system);

} // namespace ndframe
