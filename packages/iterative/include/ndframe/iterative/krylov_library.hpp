#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <Teuchos_ParameterList.hpp>

#include "ndframe/algebra/joined_system.hpp"

namespace ndframe
{

struct LinearLevel;
struct TpetraSystem;
struct PreconditionerHandle;

/// A symmetric positive definite approximation of the inverse of the interior matrix, for conjugate gradients.
class Preconditioner
{
public:
  virtual ~Preconditioner() = default;
  /// Sets it up for the matrix of this system. Collective.
  virtual std::shared_ptr<PreconditionerHandle> build(const TpetraSystem& system) const = 0;
  virtual std::string name() const = 0; ///< of library and method, as in "Ifpack2 RILUK"
};

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
  std::vector<const SolverProblem*> problems; ///< kept dofs are interior ones
  std::vector<const LinearLevel*> levels;     ///< of them
  std::vector<int> kept, keptOnVertices; ///< numbers of the kept dofs among all, and among vertices' (-1: not at one)
};

/// Conjugate gradients on a joined system: b and x have the dofs of this rank's nodes, one body after another, those of
/// unknowns at their places.
class JoinedGradients : public ConjugateGradients
{
public:
  /// From now on. The coarse level stays as it is until setCoarse().
  virtual void follow(const JoinedUnknowns& unknowns) = 0;
  virtual double largestEigenvalue() const = 0; ///< of D^-1 K for the first unknowns
  /// K x of the bodies as if nothing joined them, zero where no dof is free; on the dofs of this rank's nodes.
  virtual Vector multiply(const Vector& x) const = 0;
  /// |K| |x| of the bodies, the same of moduli, in all rows.
  virtual Vector sizes(const Vector& x) const = 0;
  /// problem: that of all vertices. isRead(): called as soon as it is not needed any more, before the coarse level is
  /// set up, which takes much memory.
  virtual void setCoarse(const JoinedRows& rows, const SolverProblem& problem, double decoupledDiagonal,
                         const std::function<void()>& isRead) = 0;
};

/// What Belos, Ifpack2 and MueLu do for us. The implementation is a module of its own (package krylov), because the
/// dynamic linker takes longer for these libraries than a small scene takes. Only this header and those that it
/// includes are common to module and program; the module calls no function of the program but those it is handed.
///
/// The valid lists hold all keys that a library knows, with their defaults.
class KrylovLibrary
{
public:
  virtual ~KrylovLibrary() = default;

  virtual const Teuchos::ParameterList& validBelos() const = 0;   ///< of pseudo-block conjugate gradients
  virtual const Teuchos::ParameterList& validIfpack2() const = 0; ///< of all its methods
  virtual const Teuchos::ParameterList& validMueLu() const = 0;   ///< of its master list

  /// `list`: parameters of the library, conformed to its valid list.
  virtual std::unique_ptr<Preconditioner> ifpack2(const std::string& method,
                                                  const Teuchos::ParameterList& list) const = 0;
  virtual std::unique_ptr<Preconditioner> mueLu(const Teuchos::ParameterList& list) const = 0; ///< algebraic multigrid

  /// Needs MPI running. `decoupledDiagonal`: entry of the rows that stand for fixed and kept dofs. Throws
  /// Teuchos::Exceptions::InvalidParameter when the preconditioner refuses its parameters.
  virtual std::unique_ptr<ConjugateGradients> conjugateGradients(const SolverProblem& problem, const Comm& comm,
                                                                 double decoupledDiagonal,
                                                                 const Preconditioner& preconditioner,
                                                                 const Teuchos::ParameterList& belos) const = 0;

  /// The same, without a copy of the matrix and preconditioned on two levels: Chebyshev's polynomials on all nodes and
  /// `coarse` on the vertices. `level` is not needed any more when this returns.
  virtual std::unique_ptr<ConjugateGradients> twoLevels(const SolverProblem& problem, const LinearLevel& level,
                                                        const Comm& comm, double decoupledDiagonal,
                                                        const Preconditioner& coarse,
                                                        const Teuchos::ParameterList& belos) const = 0;

  /// unknowns: those whose operator has the largest eigenvalue. Needs setCoarse() before it solves.
  virtual std::unique_ptr<JoinedGradients> joined(const JoinedBodies& bodies, const JoinedUnknowns& unknowns,
                                                  const Comm& comm, std::shared_ptr<const Preconditioner> coarse,
                                                  const Teuchos::ParameterList& belos) const = 0;

  /// Ends Kokkos if it was started. Nothing that was made here may be alive.
  virtual void finish() const = 0;
};

} // namespace ndframe
