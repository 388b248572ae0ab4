#pragma once

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ndframe/algebra/block_matrix.hpp"
#include "ndframe/algebra/comm.hpp"
#include "ndframe/algebra/dense.hpp"
#include "ndframe/base/ledger.hpp"
#include "ndframe/base/registry.hpp"

namespace ndframe
{

/// What a dof is to the solver.
enum class DofRole : unsigned char
{
  Interior, ///< eliminated (i)
  Fixed,    ///< prescribed by a support; its row and column are left out
  Kept      ///< interface normal, kept in the condensed system (c)
};

/// Which nodes of second-order elements are vertices and which lie on edges: what interpolates linear functions.
struct EdgeNodes
{
  /// Per node the ends of the edge that it is the middle of; a vertex is both of its ends. Empty: all are vertices.
  std::vector<std::array<int, 2>> ends;
  std::vector<int> turned;  ///< nodes whose components have axes of their own, ascending
  std::vector<double> axes; ///< dim x dim for each of them, row k = axis of component k
};

/// What decides on the solver of a body before there is a matrix.
struct BodyOutline
{
  int dim = 0;               ///< of space, 2 or 3
  std::int64_t dofs = 0;     ///< of all bodies that are solved together with it
  int bodies = 1;            ///< their number
  bool isCondensed = false;  ///< its Schur complement is asked for
  double poissonRatio = 0.0; ///< the largest of the materials, as of isotropic ones
};

/// One body's matrix with the roles of its dofs, all of them on every rank: what direct solvers need. Iterations take a
/// RankProblem of it. The matrix must outlive the factor (it is not copied for products).
struct SolverProblem
{
  const BlockMatrix* matrix = nullptr; ///< K, not owned
  std::vector<DofRole> roles;          ///< one per dof
  std::vector<int> kept;               ///< the Kept dofs, in the order of the condensed system
  DenseMatrix nearNullSpace;           ///< rigid motions in the dofs' own frames, one a column: used by multigrid
  std::vector<double> nodePoints;      ///< coordinates, dim a node: the same
  EdgeNodes edgeNodes;                 ///< the same
  BodyOutline outline;                 ///< used where the solver is chosen
};

struct RankProblem; // rank_problem.hpp

/// A body factored once: K split into interior (i) and kept (c) dofs,
///
///   [ K_ii K_ic ] [u_i]   [f_i]
///   [ K_ci K_cc ] [u_c] = [f_c + r],   S = K_cc - K_ci K_ii^-1 K_ic,   g = f_c - K_ci K_ii^-1 f_i,   S u_c = g + r.
///
/// K_ii must be regular (positive definite); K itself may be singular (a floating body held by its kept dofs only).
/// Vectors are replicated on all ranks. Counts "back-solves" (one per right-hand side) in the ledger.
class CondensedBody
{
public:
  virtual ~CondensedBody() = default;

  /// u with the kept values given: u_c = kept, K_ii u_i = load_i - K_ic u_c; fixed dofs zero.
  /// load: numDofs x m (kept and fixed rows are ignored), kept: n_c x m.
  virtual DenseMatrix expand(const DenseMatrix& load, const DenseMatrix& kept) const = 0;

  /// g = load_c - K_ci K_ii^-1 load_i, n_c x m.
  virtual DenseMatrix reduce(const DenseMatrix& load) const = 0;

  /// S u for one vector of kept values, by one back-solve.
  virtual Vector applySchur(const Vector& kept) const = 0;

  /// The dense Schur complement S, n_c x n_c, both triangles. Direct solvers take it from the factor; Krylov pays n_c
  /// solves.
  virtual DenseMatrix schurComplement() const = 0;

  /// True when schurComplement() comes with the factor.
  virtual bool hasCheapSchur() const = 0;

  /// Forgets what earlier solutions have left to start others from, where it keeps something (SymmetricOperator).
  virtual void forgetSolutions() const {}

  virtual std::string description() const = 0; ///< e.g. "Cholmod, METIS nested dissection, 1.3e6 nonzeros"
};

/// A way to factor a body. Counts "factorisations" in the ledger and times the stages "order" and "factor".
class LinearSolver
{
public:
  virtual ~LinearSolver() = default;
  /// Throws SingularBody when K_ii is not positive definite (conjugate gradients may find out in a solve only),
  /// InputError when the solver cannot treat the problem (memory, ranks, nothing free). The ledger must outlive the
  /// factor. Collective.
  virtual std::unique_ptr<CondensedBody> factor(SolverProblem problem, const Comm& comm, Ledger& ledger) const = 0;
  /// The same of a body that no rank has as a whole: it is joined to others (WholeSolver). Null where the solver needs
  /// whole bodies. Collective.
  virtual std::unique_ptr<CondensedBody> share(RankProblem problem, const Comm& comm, Ledger& ledger) const;
  /// The solver that factors bodies on so many ranks, where it does not depend on the body.
  virtual std::string name(int ranks) const = 0;
  /// The solver that factors this body.
  virtual std::string name(const BodyOutline& /*body*/, int ranks) const { return name(ranks); }
  /// True when it calls MPI on so many ranks; a single process starts MPI for nothing else.
  virtual bool needsMpi(int ranks) const = 0;
  /// True when threads may factor bodies at the same time.
  virtual bool allowsThreads(int /*ranks*/) const { return false; }
};

/// K_ii is singular or not positive definite: the body has a free rigid motion, or the material is not positive
/// definite.
class SingularBody : public std::runtime_error
{
public:
  /// what: the message; singularDof: as `dof`.
  SingularBody(const std::string& what, int singularDof) : std::runtime_error(what), dof(singularDof) {}
  int dof; ///< -1 when the solver cannot tell
};

} // namespace ndframe
