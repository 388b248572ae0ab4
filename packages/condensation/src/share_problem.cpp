#include "share_problem.hpp"

#include <algorithm>

#include "ndframe/algebra/pivot_rows.hpp"
#include "ndframe/assembly/rigid_modes.hpp"

namespace ndframe
{
namespace
{

DenseMatrix rowsOf(const DenseMatrix& A, const std::vector<int>& rows)
{
  DenseMatrix result(int(rows.size()), A.cols());
  for (int j = 0; j < A.cols(); ++j)
    for (std::size_t i = 0; i < rows.size(); ++i)
      result(int(i), j) = A(rows[i], j);
  return result;
}

/// The parts of a problem by what the matrix holds, from those of the body's part.
class PartProblem
{
public:
  PartProblem(const BodyModel& body, const BodySystem& system)
      : nodes_(body.nodes), system_(system), heldOf_(std::size_t(body.nodes.numNodes()), -1)
  {
    for (std::size_t held = 0; held < system.partNodes.size(); ++held)
      heldOf_[std::size_t(system.partNodes[held])] = int(held);
  }

  void addRoles(RankProblem& problem) const
  {
    for (const int node : system_.partNodes) {
      const auto first = system_.dofs.roles.begin() + std::ptrdiff_t(node) * nodes_.dim;
      problem.roles.insert(problem.roles.end(), first, first + nodes_.dim);
    }
  }

  void addKept(RankProblem& problem) const
  {
    const std::vector<RankProblem::Global>& numbers = system_.share->numbers();
    for (const int dof : system_.dofs.keptDofs()) {
      const auto [a, b] = nodes_.ends(dof / nodes_.dim);
      problem.kept.push_back(numbers[std::size_t(dof / nodes_.dim)] * nodes_.dim + dof % nodes_.dim);
      problem.keptEnds.push_back({numbers[std::size_t(a)], numbers[std::size_t(b)]});
    }
  }

  void addEdges(RankProblem& problem) const
  {
    const Frames& frames = system_.dofs.frames;
    std::vector<char> isNear(system_.partNodes.size(), 0);
    for (int r = 0; r < system_.K.numRows(); ++r) {
      const auto [a, b] = nodes_.ends(system_.partNodes[std::size_t(r)]);
      problem.ends.push_back({heldOf_[std::size_t(a)], heldOf_[std::size_t(b)]});
      for (const int near : {r, problem.ends.back()[0], problem.ends.back()[1]})
        isNear[std::size_t(near)] = 1;
    }
    for (std::size_t held = 0; held < isNear.size(); ++held)
      if (const int node = system_.partNodes[held]; isNear[held] != 0 && frames.isTurned(node)) {
        problem.turned.push_back(int(held));
        problem.axes.insert(problem.axes.end(), frames.axes(node),
                            frames.axes(node) + std::ptrdiff_t(nodes_.dim) * nodes_.dim);
      }
  }

  /// modes: of the part. free: combinations of them that the supports leave.
  void addHolding(const DenseMatrix& modes, const DenseMatrix& free, RankProblem& problem) const
  {
    const DenseMatrix motions = multiply(rowsOf(modes, system_.dofs.keptDofs()), free);
    problem.isHeld = nullSpace(motions, rigidTolerance).cols() == 0;
    problem.holding = pivotRows(motions);
  }

  void addVertices(const DenseMatrix& modes, RankProblem& problem) const
  {
    std::vector<int> dofs;
    for (int r = 0; r < system_.K.numRows(); ++r)
      if (const int node = system_.partNodes[std::size_t(r)]; node < nodes_.numVertices())
        for (int i = 0; i < nodes_.dim; ++i) {
          dofs.push_back(node * nodes_.dim + i);
          problem.nodePoints.push_back(nodes_.coordinate(node, i));
        }
    problem.nearNullSpace = rowsOf(modes, dofs);
  }

private:
  const NodeMap& nodes_;
  const BodySystem& system_;
  std::vector<int> heldOf_; ///< per node of the part, -1: no row has it
};

} // namespace

RankProblem shareProblem(const Model& model, int number, const BodySystem& system)
{
  RankProblem problem;
  problem.matrix = &system.K;
  problem.outline = model.outline(number);
  const BodyModel& body = model.bodies[std::size_t(number)];
  const PartProblem part(body, system);
  part.addRoles(problem);
  part.addKept(problem);
  part.addEdges(problem);
  const DenseMatrix modes = rigidModes(model.rigid[std::size_t(number)], body.nodes, system.dofs.frames);
  part.addVertices(modes, problem);
  part.addHolding(modes, model.freeMotions[std::size_t(number)], problem);
  return problem;
}

} // namespace ndframe
