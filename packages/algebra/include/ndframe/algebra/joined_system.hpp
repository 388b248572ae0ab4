#pragma once

#include <memory>
#include <vector>

#include "ndframe/algebra/rank_problem.hpp"
#include "ndframe/algebra/sparse_field.hpp"
#include "ndframe/algebra/sparse_row.hpp"

namespace ndframe
{

/// How the kept dofs of several bodies, one body after another, follow unknowns y that take the places of some of them:
///
///   kept_k = sum_p E_kp y_p,   y_p = sum_k L_pk kept_k,   L E = 1,   p the places.
struct JoinedRows
{
  std::vector<SparseRow> kept;     ///< E, one row per kept dof
  std::vector<SparseRow> unknowns; ///< L, one row per kept dof, empty where no unknown stands
};

/// How far iterations go: to the tolerance of the deck, or as far as they must where what is left of the residual is
/// made up for.
enum class Exactness
{
  Full,
  Rough ///< 10^3 times the tolerance, but not more than 1e-7 unless the deck asks for no more
};

/// The tolerance that this means.
double toleranceFor(Exactness exactness, double tolerance);

/// The matrices of several bodies as one system on what is free of them and the unknowns that their kept dofs follow:
///
///   E^T (K + springs) E x = E^T (load - K u),   springs a multiple of the diagonal at the unknowns.
///
/// No matrix of the bodies is copied. Collective.
class JoinedSystem
{
public:
  virtual ~JoinedSystem() = default;

  /// From now on. onVertices: the same for linear functions, whose kept dofs are those at vertices (empty rows
  /// elsewhere): what the coarse level goes by, which is set up again only where these differ in many rows. Returns
  /// whether it was.
  virtual bool follow(const JoinedRows& rows, const JoinedRows& onVertices, double springs) = 0;

  /// u is this from now on, per body, in the nodes' own axes, at the nodes that this rank owns of the body's matrix.
  virtual void begin(const std::vector<NodalField>& fields) = 0;

  /// Improves u by E x until the residual of the equations above is at most `tolerance` times the loads and the forces
  /// of the kept dofs on each other as they are at first, or round-off. u is what the last call left, zero at first,
  /// but for the kept dofs of all bodies, whose values are given here and are improved with it. The springs pull
  /// towards the u of the beginning. loads: per body, in the nodes' own axes. Returns load - K u at the kept dofs.
  /// Throws NotConverged and SingularBody.
  virtual Vector solve(const std::vector<const SparseField*>& loads, Vector& kept, double tolerance) = 0;

  /// A start: the same equations for functions that are linear between the vertices, P^T K P, whose kept dofs are those
  /// at vertices. open: E and L where no kept dof follows one of another body. Before the first follow().
  virtual void beginOnVertices(const JoinedRows& open) = 0;
  /// rows: empty elsewhere. Whether a coarse level was set up for them.
  virtual bool followOnVertices(const JoinedRows& rows, double springs) = 0;
  /// As solve(), for a field of its own, zero at first; `kept` elsewhere than at vertices is ignored.
  virtual Vector solveOnVertices(const std::vector<const SparseField*>& loads, Vector& kept, double tolerance) = 0;
  /// u is that field from now on. Returns its values at the kept dofs.
  virtual Vector beginFromVertices() = 0;

  virtual std::vector<NodalField> fields() const = 0; ///< u, what begin() takes
  /// The same. Nothing else can be asked of the system afterwards but its tolerance and its ranks.
  virtual std::vector<NodalField> takeFields() && = 0;

  virtual double tolerance() const = 0; ///< what the deck asks for
  virtual const Comm& comm() const = 0; ///< the ranks that share it
};

/// A body whose matrix is solved by iterations on all its dofs.
class WholeSolver
{
public:
  virtual ~WholeSolver() = default;

  /// K u = load on all dofs that are not fixed but those that hold the body (RankProblem::holding), where u keeps the
  /// values of `start`, as it does on fixed dofs. There too if the load balances. All at the nodes that this rank owns
  /// of the body's matrix. Throws NotConverged, and SingularBody where nothing holds the body.
  virtual NodalField solveFree(const NodalField& load, NodalField start, Exactness exactness) const = 0;

  /// Gives back the memory that solveFree() keeps for the next call, which sets up again what it needs.
  virtual void forget() const = 0;

  /// False where the body is condensed, by a factor or by one of the solvers that cannot do the following.
  virtual bool solvesWhole() const = 0;

  /// These bodies, of which this is one, as one system. open: E and L where no kept dof follows one of another body.
  virtual std::unique_ptr<JoinedSystem> join(const std::vector<const WholeSolver*>& bodies,
                                             const JoinedRows& open) const = 0;

  /// With the kept dofs as interior ones.
  virtual const RankProblem& freedProblem() const = 0;

  /// The largest eigenvalue of D^-1 K that was found for this body together with others: solveFree() takes it, too.
  virtual void setLargestEigenvalue(double /*value*/) const {}

  /// A joined system did not converge: whether the body has another solver and takes that from now on.
  virtual bool givesUp() const { return false; }
};

/// What a body is besides, null where it does not solve whole bodies.
const WholeSolver* wholeSolver(const CondensedBody& body);

} // namespace ndframe
