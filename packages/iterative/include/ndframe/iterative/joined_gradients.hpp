#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "ndframe/algebra/joined_system.hpp"

namespace ndframe
{

struct LinearLevel;

/// What a rank sends to others one by one.
struct Traffic
{
  std::int64_t messages = 0, bytes = 0;

  Traffic& operator+=(const Traffic& more)
  {
    messages += more.messages;
    bytes += more.bytes;
    return *this;
  }
};

/// What cycles on two levels cost since they were set up, the set-up included.
struct CycleWork
{
  int products = 0; ///< of the matrix of all nodes
  int cycles = 0;   ///< times that the preconditioner was applied
  Traffic traffic;  ///< of this rank, in products and cycles
};

/// Preconditioned conjugate gradients on the interior problem of a body. All functions are collective.
class ConjugateGradients
{
public:
  virtual ~ConjugateGradients() = default;

  virtual CycleWork work() const { return {}; } ///< zeros where there are no two levels

  /// What a solve returns.
  struct Result
  {
    Vector x;       ///< of this rank's nodes; round-off on fixed and kept dofs
    int iterations; ///< of this call
  };

  /// Called every ten iterations, on all ranks alike; residual: CG's own, relative to the right-hand side. Does not
  /// throw.
  using Watch = std::function<void(int iteration, double residual)>;

  /// K_ii x_i = b_i from x = 0 until CG's own residual is below `tolerance` |b_i|, or maxIterations. `b` has the dofs
  /// of this rank's nodes, zero outside the interior. Throws SingularBody when CG meets a direction without energy.
  virtual Result solve(const Vector& b, double tolerance, int maxIterations, const Watch& watch) const = 0;
};

/// The unknowns of a joined system.
struct JoinedUnknowns
{
  JoinedRows rows; ///< E and L
  Vector diagonal; ///< per kept dof that of E^T K E + springs, zero where no unknown stands
  Vector springs;  ///< per kept dof; empty: none
};

/// Several bodies, one after another, with kept dofs that follow unknowns.
struct JoinedBodies
{
  std::vector<const RankProblem*> problems; ///< kept dofs are interior ones
  std::vector<const LinearLevel*> levels;   ///< of them
  /// Numbers of the kept dofs among all, and among vertices' (-1: not at one).
  std::vector<RankProblem::Global> kept, keptOnVertices;
};

/// Conjugate gradients on a joined system: b and x have the dofs of this rank's nodes (or vertices), one body after
/// another, those of unknowns at their places.
class FollowingGradients : public ConjugateGradients
{
public:
  virtual void follow(const JoinedUnknowns& unknowns) = 0; ///< from now on
  /// K x of the bodies as if nothing joined them, zero where no dof is free; on the dofs of this rank's nodes.
  virtual Vector multiply(const Vector& x) const = 0;
  /// |K| |x| of the bodies, the same of moduli, in all rows.
  virtual Vector sizes(const Vector& x) const = 0;
};

/// The same on two levels, of which the coarse one stays as it is until setCoarse(), whatever the unknowns are.
class JoinedGradients : public FollowingGradients
{
public:
  virtual double largestEigenvalue() const = 0; ///< of D^-1 K for the first unknowns
  /// problem: that of all vertices. isRead(): called as soon as it is not needed any more, before the coarse level is
  /// set up, which takes much memory.
  virtual void setCoarse(const JoinedRows& rows, const RankProblem& problem, double decoupledDiagonal,
                         const std::function<void()>& isRead) = 0;

  /// The equations P^T K P of linear functions with unknowns of their own, at the vertices of this rank, preconditioned
  /// by polynomials there and the coarse level. It must be asked for before setCoarse(); unknowns: the first ones,
  /// whose operator has the largest eigenvalue. Lives as long as this.
  virtual FollowingGradients& onVertices(const JoinedUnknowns& unknowns) = 0;
  virtual Vector toVertices(const Vector& x) const = 0;   ///< P^T x of the bodies as if nothing joined them
  virtual Vector fromVertices(const Vector& c) const = 0; ///< P c, the same
};

} // namespace ndframe
