#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ndframe/algebra/joined_system.hpp"
#include "ndframe/assembly/body_system.hpp"
#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/interface/contact_basis.hpp"
#include "ndframe/interface/contact_matrix.hpp"
#include "ndframe/interface/interface_operators.hpp"
#include "ndframe/interface/mortar_space.hpp"
#include "ndframe/interface/trace_map.hpp"

namespace ndframe
{

/// Another unknown that a body takes part in, at a node whose displacement other unknowns of the body say already:
/// u_N = row u + offset, u the values of the trace.
struct DependentUnknown
{
  int unknown;      ///< number of the interface unknown
  ContactRole role; ///< of the body there
  SparseRow row;    ///< by places in the trace
  double offset;    ///< what prescribed displacements add, a length
};

/// A vector that may take a solve to find, and is found when it is first read. Not for several threads.
class ReducedLoad
{
public:
  ReducedLoad() = default;
  ReducedLoad(Vector values) : values_(std::move(values)) {}                     ///< known from the start
  explicit ReducedLoad(std::function<Vector()> find) : find_(std::move(find)) {} ///< called once, at the first reading

  operator const Vector&() const { return found(); }            ///< finds it, as all that read do
  std::size_t size() const { return found().size(); }           ///< number of entries; finds it
  double operator[](std::size_t i) const { return found()[i]; } ///< an entry; finds it
  double& operator[](std::size_t i) { return found()[i]; }      ///< an entry to be changed; finds it
  auto begin() const { return std::as_const(found()).begin(); } ///< of the entries; finds it
  auto end() const { return std::as_const(found()).end(); }     ///< of the entries; finds it
  auto begin() { return found().begin(); }                      ///< of entries to be changed; finds it
  auto end() { return found().end(); }                          ///< of entries to be changed; finds it
  void negate();                                                ///< changes the sign; finds nothing

private:
  Vector& found() const;

  mutable std::function<Vector()> find_; ///< null once it is found
  mutable Vector values_;
};

/// A body as the interface sees it:  S u_N = g + r,  r the nodal forces along n_c that act on this body.
struct BodyTrace
{
  int body = 0;                               ///< index into the list of bodies
  std::vector<int> unknowns;                  ///< the interface unknown of each kept dof
  std::vector<ContactRole> roles;             ///< per kept dof: the body's there
  std::shared_ptr<const SymmetricOperator> S; ///< condensed stiffness in the trace's values (traceOperator)
  TraceMap map;                               ///< from the kept dofs to u_N
  ReducedLoad g;                              ///< per value
  std::vector<DependentUnknown> dependents;   ///< where more unknowns meet than its nodes can follow one by one
  const WholeSolver* whole = nullptr;         ///< of the body, null where it is none
  const SparseField* load = nullptr;          ///< its effective load
  std::shared_ptr<const BodyShare> share;     ///< of a body that no rank has as a whole: `map` is about its part
  DenseMatrix freeMotions; ///< kept dofs x motions that the supports leave free: their normal displacements
  std::vector<std::string> motionNames; ///< per column of freeMotions: with the body's name, for messages

  bool isSolvedWhole() const { return whole != nullptr && whole->solvesWhole(); } ///< by iterations on all its dofs

  /// The contact forces on this body along n_c, per value of the trace, from those per unknown; those of dependents are
  /// shared out.
  Vector forces(const UnknownValues& onDirichlet, const UnknownValues& onNeumann) const;
};

/// An interface node where a slit ends (InterfaceMesh::facesItself), and those on its facets that face others. What is
/// pressed there stays inside the body, so that no force says it.
struct SlitEnd
{
  int node;                ///< numbered as in the contact matrix
  std::vector<int> beside; ///< the same; once for every facet that has both
};

/// All interfaces as one system. An unknown is an interface node whose normal displacement is free on both bodies, or
/// on one: where supports hold the other body, that one is an obstacle. Everything at such an unknown is seen from the
/// free body, whatever its role: uDirichlet and forceDirichlet are its own, along its outward normal, and uNeumann is
/// the obstacle's displacement. Nodes that supports hold on both sides carry no contact force. Displacements, forces
/// and gaps of an unknown are those of the contact basis: of the node's value, or of a coefficient.
struct InterfaceSystem
{
  int dim = 2;                               ///< of the bodies
  std::vector<int> nodeOfUnknown;            ///< node number in the numbering of the contact matrix
  UnknownValues gap;                         ///< between the bodies
  std::vector<char> isObstacle;              ///< per unknown: only one body is free
  UnknownValues obstacle;                    ///< the held body's displacement along the free one's normal; else 0
  std::vector<BodyTrace> bodies;             ///< those that have unknowns, by ascending BodyTrace::body
  std::vector<SlitEnd> slitEnds;             ///< of all interfaces; empty without slits
  std::shared_ptr<const ContactMatrix> C;    ///< null without interfaces
  std::shared_ptr<const ContactBasis> basis; ///< null: values at the nodes
  std::shared_ptr<const MortarSpace> mortar; ///< null: contact is asked of every unknown by itself

  int size() const { return int(nodeOfUnknown.size()); } ///< number of unknowns
  /// A body's role on the unknowns that it shares; one that meets obstacles only is a Dirichlet body.
  ContactRole roleOf(const BodyTrace& body) const;
  /// At the unknowns' own nodes.
  UnknownValues atUnknowns(const InterfaceValues& ofNodes) const;
  /// Displacements of the Neumann side with those of the obstacles filled in.
  UnknownValues withObstacles(UnknownValues uNeumann) const;
  /// Per interface node the integral of its function: what a traction of 1 makes of it.
  InterfaceValues shares() const;
  /// Nodal forces along n_c, per interface node, from those at the unknowns.
  InterfaceValues nodalForces(const UnknownValues& force) const;
  /// Nodal tractions Lambda = C^-1 r from the forces at the unknowns; where slits end with the mean of those beside.
  InterfaceValues traction(const UnknownValues& force) const;
  /// The forces at the unknowns of nodal tractions, and of the traction that has these values or coefficients there.
  UnknownValues force(const InterfaceValues& traction) const;
  UnknownValues forceOf(const UnknownValues& traction) const; ///< zero is taken where there is no unknown

private:
  /// Per interface node; zero where there is no unknown.
  Vector atNodes(const UnknownValues& ofUnknowns) const;
};

/// S in the values of the trace: u_N = A s + b gives S_N = A^-T S A^-1. The condensed body must outlive it.
std::shared_ptr<const SymmetricOperator> traceOperator(const CondensedBody& body, const TraceMap& map,
                                                       const InterfaceOperator& representation);

/// g in the values of the trace: g_N = A^-T g + S_N b. load: BodySystem::effectiveLoad.
Vector traceLoad(const CondensedBody& body, const TraceMap& map, const SymmetricOperator& S, const Vector& load);

/// Normal displacements of rigid motions (columns: coefficients in the basis) at interface nodes.
DenseMatrix motionTraces(const RigidBasis& basis, const DenseMatrix& motions, const std::vector<const double*>& points,
                         const std::vector<Direction>& normals);

} // namespace ndframe
