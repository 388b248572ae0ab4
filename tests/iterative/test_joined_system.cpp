#include <cmath>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"
#include "ndframe/algebra/joined_system.hpp"
#include "ndframe/algebra/own_field.hpp"

namespace ndframe
{

namespace
{

/// Two equal bodies, clamped at their bottoms, whose tops are joined in some of their nodes: kept dof k of the second
/// one is that of the first where `closed[k]`.
class Pair
{
public:
  Pair()
      : first(test::trussBody({12, 12, 6}, test::comm())), second(test::trussBody({12, 12, 6}, test::comm(), 3.0)),
        problem(first.problem(test::Support::Clamp)), other(second.problem(test::Support::Clamp)),
        solver(test::makeSolver("Multigrid")), factored{solver->factor(problem, test::comm(), ledger),
                                                        solver->factor(other, test::comm(), ledger)},
        fields{field(1), field(2)}, loads{SparseField(fields[0]), SparseField(fields[1])}
  {
    joined = whole(0).join({&whole(0), &whole(1)}, rows(std::vector<char>(numKept(), 0), false));
  }

  std::size_t numKept() const { return problem.kept.size(); }
  bool isVertex(int dof) const
  {
    const auto& ends = problem.edgeNodes.ends[std::size_t(dof / 3)];
    return ends[0] == ends[1];
  }

  JoinedRows rows(const std::vector<char>& closed, bool onVertices) const
  {
    const int n = int(numKept());
    JoinedRows result;
    for (int k = 0; k < 2 * n; ++k) {
      const bool isAbsent = onVertices && !isVertex(problem.kept[std::size_t(k % n)]);
      const bool follows = k >= n && closed[std::size_t(k - n)];
      result.kept.push_back(isAbsent ? SparseRow() : SparseRow{{follows ? k - n : k, 1.0}});
      result.unknowns.push_back(isAbsent || follows ? SparseRow() : SparseRow{{k, 1.0}});
    }
    return result;
  }

  std::vector<const SparseField*> given() const { return {&loads[0], &loads[1]}; }
  const SolverProblem& of(int body) const { return body == 0 ? problem : other; }
  /// The fields at the end, on every rank.
  std::vector<Vector> takeFields()
  {
    std::vector<Vector> result;
    for (NodalField& field : std::move(*joined).takeFields())
      result.push_back(onEveryRank(std::move(field), test::comm()).whole());
    return result;
  }
  bool isFixed(int dof) const { return problem.roles[std::size_t(dof)] == DofRole::Fixed; }

  /// load - K u of a body on the dofs that are not fixed.
  Vector residual(int body, const Vector& u) const
  {
    Vector r = multiply((body == 0 ? first : second).matrix, u, test::comm());
    for (std::size_t dof = 0; dof < r.size(); ++dof)
      r[dof] = isFixed(int(dof)) ? 0.0 : fields[std::size_t(body)].whole()[dof] - r[dof];
    return r;
  }
  /// P^T of it, at the dofs of vertices.
  Vector onVertices(const Vector& r) const
  {
    Vector sums(r.size(), 0.0);
    for (std::size_t dof = 0; dof < r.size(); ++dof)
      for (const int end : problem.edgeNodes.ends[dof / 3])
        if (const std::size_t to = std::size_t(end) * 3 + dof % 3; !isFixed(int(to)))
          sums[to] += 0.5 * r[dof];
    return sums;
  }

  /// What is left of E^T r with these statuses, relative to the loads.
  double left(std::array<Vector, 2> r, const std::vector<char>& closed) const
  {
    for (std::size_t k = 0; k < numKept(); ++k)
      if (const auto dof = std::size_t(problem.kept[k]); closed[k]) {
        r[0][dof] += r[1][dof];
        r[1][dof] = 0.0;
      }
    return std::hypot(norm(r[0]), norm(r[1])) / std::hypot(norm(fields[0].whole()), norm(fields[1].whole()));
  }

  Ledger ledger;
  test::SampleBody first, second;
  SolverProblem problem, other;
  std::unique_ptr<LinearSolver> solver;
  std::array<std::unique_ptr<CondensedBody>, 2> factored;
  std::array<NodalField, 2> fields;
  std::array<SparseField, 2> loads;
  std::unique_ptr<JoinedSystem> joined;

private:
  const WholeSolver& whole(int body) const { return *wholeSolver(*factored[std::size_t(body)]); }
  NodalField field(unsigned seed) const { return atNodes(test::randomVector(problem.roles.size(), seed), 3); }
};

/// Closed where the first coordinate of the node is below `share` of the width.
std::vector<char> closedBelow(const Pair& pair, double share)
{
  std::vector<char> closed;
  for (const int dof : pair.problem.kept)
    closed.push_back(pair.first.points[std::size_t(dof / 3) * 3] < share * 12.0);
  return closed;
}

constexpr double tolerance = 1e-9;

} // namespace

/// Linear between the vertices, equal where closed, and in equilibrium with the loads for all such functions.
TEST(JoinedSystem, SolvesTheEquationsOfLinearFunctions)
{
  Pair pair;
  const std::vector<char> closed = closedBelow(pair, 0.6);
  pair.joined->beginOnVertices(pair.rows(std::vector<char>(closed.size(), 0), true));
  pair.joined->followOnVertices(pair.rows(closed, true), 0.0);
  Vector kept(2 * closed.size(), 0.0);
  const Vector rest = pair.joined->solveOnVertices(pair.given(), kept, tolerance);
  const Vector all = pair.joined->beginFromVertices();
  const std::vector<Vector> u = pair.takeFields();
  EXPECT_GT(pair.ledger.counted("vertex iterations"), 0);
  EXPECT_GT(pair.ledger.counted("vertex products"), pair.ledger.counted("vertex cycles"));
  EXPECT_LE(pair.ledger.counted("fine products"), 20) << "only the largest eigenvalue is sought on all nodes";

  std::array<Vector, 2> r;
  for (int body = 0; body < 2; ++body) {
    const Vector& values = u[std::size_t(body)];
    for (std::size_t dof = 0; dof < values.size(); ++dof) {
      const auto& ends = pair.problem.edgeNodes.ends[dof / 3];
      const double mean =
          0.5 * (values[std::size_t(ends[0]) * 3 + dof % 3] + values[std::size_t(ends[1]) * 3 + dof % 3]);
      if (!pair.isFixed(int(dof))) {
        ASSERT_NEAR(values[dof], mean, 1e-13 * largestEntry(values));
      }
    }
    r[std::size_t(body)] = pair.onVertices(pair.residual(body, values));
  }
  EXPECT_LE(pair.left(r, closed), 10.0 * tolerance);
  const std::size_t n = closed.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto dof = std::size_t(pair.problem.kept[k]);
    for (std::size_t body = 0; body < 2; ++body) {
      EXPECT_EQ(all[body * n + k], u[body][dof]);
      if (pair.isVertex(int(dof))) {
        EXPECT_EQ(kept[body * n + k], u[body][dof]);
        EXPECT_NEAR(rest[body * n + k], r[body][dof], 1e-10 * largestEntry(rest));
      }
    }
    if (closed[k] && pair.isVertex(int(dof))) {
      EXPECT_EQ(kept[k], kept[n + k]);
    }
  }
}

/// The coarse level stays while few statuses change, those that open included: what it knows nothing of is left to the
/// polynomials.
TEST(JoinedSystem, SolvesOnVerticesWithACoarseLevelOfOtherStatuses)
{
  Pair pair;
  pair.joined->beginOnVertices(pair.rows(std::vector<char>(pair.numKept(), 0), true));
  Vector kept(2 * pair.numKept(), 0.0);
  std::vector<char> closed;
  for (const double share : {1.1, 0.9, 1.1, 0.0}) {
    closed = closedBelow(pair, share);
    pair.joined->followOnVertices(pair.rows(closed, true), 0.0);
    for (std::size_t k = 0; k < closed.size(); ++k)
      if (closed[k])
        kept[closed.size() + k] = kept[k];
    pair.joined->solveOnVertices(pair.given(), kept, tolerance);
    EXPECT_EQ(pair.ledger.counted("multigrid set-ups"), share > 0.0 ? 1 : 2) << share;
  }
  EXPECT_LE(pair.ledger.counted("vertex iterations"), 160);
  pair.joined->beginFromVertices();
  const std::vector<Vector> u = pair.takeFields();
  EXPECT_LE(pair.left({pair.onVertices(pair.residual(0, u[0])), pair.onVertices(pair.residual(1, u[1]))}, closed),
            10.0 * tolerance);
}

/// A start takes fewer iterations and changes nothing.
TEST(JoinedSystem, GoesOnFromLinearFunctions)
{
  std::array<std::vector<Vector>, 2> u;
  std::array<std::int64_t, 2> iterations{};
  for (const std::size_t starts : {0, 1}) {
    Pair pair;
    const std::vector<char> closed = closedBelow(pair, 0.6);
    Vector kept(2 * closed.size(), 0.0);
    if (starts == 1) {
      pair.joined->beginOnVertices(pair.rows(std::vector<char>(closed.size(), 0), true));
      pair.joined->followOnVertices(pair.rows(closed, true), 0.0);
      pair.joined->solveOnVertices(pair.given(), kept, 1e-2);
      kept = pair.joined->beginFromVertices();
      for (std::size_t k = 0; k < closed.size(); ++k)
        if (closed[k])
          kept[closed.size() + k] = kept[k];
    }
    pair.joined->follow(pair.rows(closed, false), pair.rows(closed, true), 0.0);
    pair.joined->solve(pair.given(), kept, tolerance);
    EXPECT_EQ(pair.ledger.counted("multigrid set-ups"), 1);
    iterations[starts] = pair.ledger.counted("Krylov iterations");
    u[starts] = pair.takeFields();
    EXPECT_LE(pair.left({pair.residual(0, u[starts][0]), pair.residual(1, u[starts][1])}, closed), 10.0 * tolerance);
  }
  for (std::size_t body = 0; body < 2; ++body)
    EXPECT_LT(test::relativeDifference(u[1][body], u[0][body]), 1e-6);
  EXPECT_LE(iterations[1], iterations[0]);
}

} // namespace ndframe
