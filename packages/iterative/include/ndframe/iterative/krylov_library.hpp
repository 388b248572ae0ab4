#pragma once

#include <memory>
#include <string>

#include <Teuchos_ParameterList.hpp>

#include "ndframe/iterative/joined_gradients.hpp"

namespace ndframe
{

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
  virtual std::unique_ptr<ConjugateGradients> conjugateGradients(const RankProblem& problem, const Comm& comm,
                                                                 double decoupledDiagonal,
                                                                 const Preconditioner& preconditioner,
                                                                 const Teuchos::ParameterList& belos) const = 0;

  /// The same, without a copy of the matrix and preconditioned on two levels: Chebyshev's polynomials on all nodes and
  /// `coarse` on the vertices. `level` is not needed any more when this returns.
  virtual std::unique_ptr<ConjugateGradients> twoLevels(const RankProblem& problem, const LinearLevel& level,
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
