#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ndframe/algebra/linear_solver.hpp"

namespace ndframe::test
{

/// How a sample body is held besides its kept dofs.
enum class Support
{
  None,  ///< floats
  Guide, ///< all components but the last of the nodes with x = 0: free along the last axis
  Clamp  ///< all components of the nodes at the bottom
};

/// A grid of nodes, all pairs of nodes of a cell joined by elastic bars of different stiffness: the simplest matrix
/// with the structure of an elastic body's. Its null space holds exactly the rigid motions.
struct SampleBody
{
  BlockMatrix matrix;
  DenseMatrix rigidMotions;
  std::vector<double> points;
  std::vector<int> cells; ///< per direction

  /// Keeps the last component of the topmost nodes, in descending order; all their components if nothing supports the
  /// body.
  SolverProblem problem(Support support) const;
  /// Keeps nothing.
  SolverProblem problemWithoutKept(Support support) const;
  /// With even numbers of cells every node but those of the grid twice as coarse lies half way between two of these:
  /// as in second-order elements. Else all nodes are vertices.
  EdgeNodes edgeNodes() const;
};

/// `stiffness` and `length` choose the units. Rows are dealt to the ranks in chunks of three nodes.
SampleBody trussBody(std::vector<int> cells, const Comm& comm, double stiffness = 1.0, double length = 1.0);

/// Gives the nodes that `chosen` names axes of their own: the same body in other components.
void turnNodes(SampleBody& body, SolverProblem& problem, const std::vector<int>& chosen);

/// Keeps `kept` of the matrix's dofs, in this order, and fixes `fixed`.
SolverProblem problemWith(const BlockMatrix& matrix, const std::vector<int>& kept, const std::vector<int>& fixed);

/// The linear solver of that type; `xml` holds further entries of the list.
std::unique_ptr<LinearSolver> makeSolver(const std::string& type, const std::string& xml = {});

/// What a user reads when the list is wrong.
std::string complaint(const std::string& type, const std::string& xml);

/// Reference by dense elimination. Only on matrices whose rows are all on this rank.
struct DenseReference
{
  explicit DenseReference(const SolverProblem& problem);
  Vector expand(const Vector& load, const Vector& kept) const;
  Vector reduce(const Vector& load) const;

  DenseMatrix full;
  DenseMatrix schur;

private:
  Vector interiorSolve(Vector rhs) const;
  std::vector<int> interior_, kept_;
  std::unique_ptr<DenseCholesky> factor_;
};

/// Reproducible numbers in (-1, 1).
Vector randomVector(std::size_t size, unsigned seed);

/// |a - b| / |b|
double relativeDifference(const Vector& a, const Vector& b);
double relativeDifference(const DenseMatrix& a, const DenseMatrix& b);

} // namespace ndframe::test
