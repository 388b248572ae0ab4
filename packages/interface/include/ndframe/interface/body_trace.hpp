#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/interface/contact_matrix.hpp"
#include "ndframe/interface/interface_operators.hpp"

namespace ndframe
{

/// Another unknown that a body takes part in, at a node whose displacement other unknowns of the body say already:
/// u_N = share u_first + otherShare u_other + offset.
struct DependentUnknown
{
  int unknown;
  bool onDirichletSide;
  DependentTrace follows; ///< `first` and `other` are kept dofs of the trace
};

/// A body as the interface sees it:  S u_N = g + r,  r the nodal forces along n_c that act on this body.
struct BodyTrace
{
  int body = 0;                      ///< index into the list of bodies
  std::vector<int> unknowns;         ///< the interface unknown of each kept dof
  std::vector<char> onDirichletSide; ///< per kept dof: 1 if this body is the Dirichlet body there, or meets an obstacle
  std::shared_ptr<const SymmetricOperator> S;
  Vector g;                                 ///< reduced load, per kept dof
  std::vector<DependentUnknown> dependents; ///< where more unknowns meet than its nodes can follow one by one
  DenseMatrix freeMotions; ///< kept dofs x motions that the supports leave free: their normal displacements
  std::vector<std::string> motionNames;

  /// The contact forces on this body along n_c, per kept dof, from those per unknown; those of dependents are shared
  /// out.
  Vector forces(const Vector& onDirichlet, const Vector& onNeumann) const;
};

/// All interfaces as one system. An unknown is an interface node whose normal displacement is free on both bodies, or
/// on one: where supports hold the other body, that one is an obstacle. Everything at such an unknown is seen from the
/// free body, whatever its role: uDirichlet and forceDirichlet are its own, along its outward normal, and uNeumann is
/// the obstacle's displacement. Nodes that supports hold on both sides carry no contact force.
struct InterfaceSystem
{
  std::vector<int> nodeOfUnknown; ///< node number in the numbering of the contact matrix
  Vector gap;                     ///< per unknown
  std::vector<char> isObstacle;   ///< per unknown: only one body is free
  Vector obstacle;                ///< per unknown: the held body's displacement along the free one's normal; else 0
  std::vector<BodyTrace> bodies;
  std::shared_ptr<const ContactMatrix> C;

  int size() const { return int(nodeOfUnknown.size()); }
  /// A body's role on the unknowns that it shares; one that meets obstacles only is a Dirichlet body.
  bool isDirichlet(const BodyTrace& body) const;
  /// Displacements of the Neumann side with those of the obstacles filled in.
  Vector withObstacles(Vector uNeumann) const;
  /// Nodal tractions Lambda = C^-1 r from the forces at the unknowns (zero at the other nodes).
  Vector traction(const Vector& force) const;
  /// The forces r = C Lambda at the unknowns.
  Vector force(const Vector& traction) const;
};

/// S in the normal displacements of the trace: u_N = a s + b gives S_N = a^-T S a^-1; a is diagonal but where a node
/// has two normals. The condensed body must outlive it.
std::shared_ptr<const SymmetricOperator> traceOperator(const CondensedBody& body, const std::vector<TraceDof>& trace,
                                                       const InterfaceOperator& representation);

/// g in the normal displacements of the trace: g_N = a^-T g + S_N b. load: BodySystem::effectiveLoad.
Vector traceLoad(const CondensedBody& body, const std::vector<TraceDof>& trace, const SymmetricOperator& S,
                 const Vector& load);

/// The kept dofs' values s = a^-1 (u_N - b), and a s.
Vector keptValues(const std::vector<TraceDof>& trace, const Vector& normalDisplacement);
Vector normalParts(const std::vector<TraceDof>& trace, const Vector& kept);

/// The forces a^T r on the kept dofs that forces r along the normals are, and a^-T f.
Vector keptForces(const std::vector<TraceDof>& trace, const Vector& normalForce);
Vector normalForces(const std::vector<TraceDof>& trace, Vector keptForce);

/// Normal displacements of rigid motions (columns: coefficients in the basis) at interface nodes.
DenseMatrix motionTraces(const RigidBasis& basis, const DenseMatrix& motions, const std::vector<const double*>& points,
                         const std::vector<Direction>& normals);

} // namespace ndframe
