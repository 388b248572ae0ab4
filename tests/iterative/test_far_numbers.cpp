// Bodies whose nodes have numbers beyond 2^31, as those of a scene that fits into no rank's int have.

#include <array>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"
#include "joined_krylov.hpp"
#include "krylov_module.hpp"
#include "ndframe/algebra/joined_system.hpp"
#include "ndframe/algebra/own_field.hpp"
#include "ndframe/algebra/shared_rows.hpp"
#include "ndframe/algebra/solver_problem.hpp"
#include "ndframe/iterative/linear_level.hpp"
#include "own_dofs.hpp"
#include "preconditioner_registry.hpp"
#include "rank_problem.hpp"

namespace ndframe
{

namespace
{

using Global = IndexMap::Global;

constexpr Global beyond = 3'000'000'000;

/// The same map whose numbers are `by` larger.
IndexMap moved(const IndexMap& map, Global by)
{
  std::vector<Global> owned, ghosts;
  for (int i = 0; i < map.size(); ++i)
    (map.owns(i) ? owned : ghosts).push_back(map.global(i) + by);
  return {map.globalSize() + by, std::move(owned), std::move(ghosts)};
}

/// A body that numbers beyond 2^31 were given; the matrix is its own.
struct FarBody
{
  FarBody(const BlockMatrix& given, RankProblem ofThem, Global by) : matrix(given), problem(std::move(ofThem))
  {
    matrix.nodes = moved(matrix.nodes, by);
    problem.matrix = &matrix;
    for (Global& dof : problem.kept)
      dof += by * matrix.dim;
    for (auto& ends : problem.keptEnds)
      for (Global& end : ends)
        end += by;
  }
  FarBody(const FarBody&) = delete;

  BlockMatrix matrix;
  RankProblem problem;
};

Vector ownRandom(const BlockMatrix& own, std::size_t size, unsigned seed)
{
  return ownPart(own, test::randomVector(size, seed));
}

double relativeTo(const Vector& a, const Vector& b)
{
  Vector squares{0.0, dot(b, b)};
  for (std::size_t i = 0; i < a.size(); ++i)
    squares[0] += (a[i] - b[i]) * (a[i] - b[i]);
  test::comm().sum(squares);
  return std::sqrt(squares[0] / squares[1]);
}

ConjugateGradients::Result solved(const RankProblem& problem, const Vector& load)
{
  startMpi();
  const LinearLevel level(problem, test::comm());
  const auto coarse = makeVertexMueLu({});
  return krylovLibrary()
      .twoLevels(problem, level, test::comm(), meanDiagonal(*problem.matrix, test::comm()), *coarse,
                 Teuchos::ParameterList())
      ->solve(load, 1e-12, 200, [](int, double) {});
}

/// Two bodies, the second one stiffer, whose tops are joined where the first coordinate is small.
class FarPair
{
public:
  explicit FarPair(Global by)
      : first(test::trussBody({8, 8, 4}, test::comm())), second(test::trussBody({8, 8, 4}, test::comm(), 3.0)),
        one(first.matrix, freed(first), by), other(second.matrix, freed(second), by)
  {
    for (const int dof : first.problem(test::Support::Clamp).kept)
      closed.push_back(first.points[std::size_t(dof / 3) * 3] < 4.5);
  }

  std::vector<Vector> solve(int& iterations)
  {
    startMpi();
    Ledger ledger;
    double largest = 0.0;
    const std::shared_ptr<const Preconditioner> coarse = makeVertexMueLu({});
    const auto joined = makeJoinedKrylov(
        {&one.problem, &other.problem}, rows({}, false), test::comm(), ledger, {1e-12, 500},
        [coarse](const JoinedBodies& bodies, const JoinedUnknowns& unknowns, const Comm& ranks) {
          return krylovLibrary().joined(bodies, unknowns, ranks, coarse, Teuchos::ParameterList());
        },
        largest);
    const std::array<SparseField, 2> fields{load(one, first, 1), load(other, second, 2)};
    const std::vector<const SparseField*> loads{&fields[0], &fields[1]};
    Vector kept(2 * closed.size(), 0.0);
    joined->beginOnVertices(rows({}, true));
    joined->followOnVertices(rows(closed, true), 0.0);
    joined->solveOnVertices(loads, kept, 1e-2);
    kept = joined->beginFromVertices();
    for (std::size_t k = 0; k < closed.size(); ++k)
      if (closed[k])
        kept[closed.size() + k] = kept[k];
    joined->follow(rows(closed, false), rows(closed, true), 0.0);
    joined->solve(loads, kept, 1e-12);
    iterations = int(ledger.counted("Krylov iterations"));
    std::vector<Vector> result;
    for (const NodalField& field : std::move(*joined).takeFields())
      result.emplace_back(field.begin(), field.end());
    return result;
  }

  const FarBody& firstBody() const { return one; }

private:
  static RankProblem freed(const test::SampleBody& body)
  {
    RankProblem problem = heldPart(body.problem(test::Support::Clamp), true);
    for (DofRole& role : problem.roles)
      role = role == DofRole::Kept ? DofRole::Interior : role;
    return problem;
  }

  static SparseField load(const FarBody& body, const test::SampleBody& near, unsigned seed)
  {
    return SparseField::ofOwn(
        NodalField(body.matrix.nodes.withoutGhosts(), 3, ownRandom(near.matrix, near.points.size(), seed)));
  }

  /// No statuses: all are open.
  JoinedRows rows(const std::vector<char>& statuses, bool onVertices) const
  {
    JoinedRows result;
    const int n = int(closed.size());
    for (int k = 0; k < 2 * n; ++k) {
      const auto& [a, b] = one.problem.keptEnds[std::size_t(k % n)];
      const bool isAbsent = onVertices && a != b;
      const bool follows = k >= n && !statuses.empty() && statuses[std::size_t(k - n)];
      result.kept.push_back(isAbsent ? SparseRow() : SparseRow{{follows ? k - n : k, 1.0}});
      result.unknowns.push_back(isAbsent || follows ? SparseRow() : SparseRow{{k, 1.0}});
    }
    return result;
  }

  test::SampleBody first, second;
  FarBody one, other;
  std::vector<char> closed;
};

} // namespace

/// Rows of own vertices' middles come with columns that this rank may know nothing of.
TEST(FarNumbers, RowsAreHandedOn)
{
  const test::SampleBody body = test::trussBody({8, 6, 4}, test::comm()),
                         all = test::trussBody({8, 6, 4}, Comm::single());
  BlockMatrix K = body.matrix;
  K.nodes = moved(K.nodes, beyond);
  const auto next = [&](int row) { // node n's row is for the rank of n + 1
    const Global node = K.nodes.global(row) + 1;
    return std::vector<Global>{std::min(node, K.nodes.globalSize() - 1)};
  };
  const BlockMatrix rows = receivedRows(K, next, test::comm());
  Vector count{double(rows.numRows())};
  test::comm().sum(count);
  EXPECT_EQ(count.front() > 0.0, test::comm().size() > 1);
  for (int r = 0; r < rows.numRows(); ++r) {
    EXPECT_LT(K.rowOf(rows.nodes.global(r)), 0);
    EXPECT_GE(K.rowOf(rows.nodes.global(r) + 1), 0);
    for (auto b = rows.rowPtr[std::size_t(r)]; b < rows.rowPtr[std::size_t(r) + 1]; ++b) {
      const double* expected = all.matrix.block(int(rows.nodes.global(r) - beyond),
                                                int(rows.nodes.global(rows.cols[std::size_t(b)]) - beyond));
      ASSERT_NE(expected, nullptr);
      EXPECT_TRUE(std::equal(expected, expected + 9, rows.values.data() + 9 * b));
    }
  }
}

TEST(FarNumbers, MultigridSolvesTheSame)
{
  test::SampleBody body = test::trussBody({8, 6, 4}, test::comm()), all = test::trussBody({8, 6, 4}, Comm::single());
  SolverProblem problem = body.problem(test::Support::Guide), wholeProblem = all.problem(test::Support::Guide);
  std::vector<int> chosen;
  for (int node = 0; node < body.matrix.numNodes(); node += 5)
    chosen.push_back(node);
  test::turnNodes(body, problem, chosen);
  test::turnNodes(all, wholeProblem, chosen);
  const FarBody far(body.matrix, heldPart(problem, true), beyond);
  ASSERT_GT(far.matrix.nodes.global(0), INT32_MAX);
  Vector load = test::randomVector(problem.roles.size(), 4);
  for (std::size_t dof = 0; dof < load.size(); ++dof)
    load[dof] = problem.roles[dof] == DofRole::Interior ? load[dof] : 0.0;
  const auto [u, iterations] = solved(far.problem, ownPart(body.matrix, load));
  const Vector exact = test::DenseReference(wholeProblem).expand(load, Vector(problem.kept.size(), 0.0));
  Vector own = u;
  for (std::size_t dof = 0; dof < own.size(); ++dof)
    own[dof] = far.problem.roles[dof] == DofRole::Interior ? own[dof] : 0.0;
  EXPECT_LT(relativeTo(own, ownPart(body.matrix, exact)), 1e-9);
  EXPECT_NEAR(iterations, solved(heldPart(problem, true), ownPart(body.matrix, load)).iterations, 2);
}

/// A body in shares by itself, its kept dofs freed: held by its supports, or floating and held by some of its kept
/// dofs, under a load that balances.
TEST(FarNumbers, FreedBodiesMoveTheSame)
{
  for (const test::Support support : {test::Support::Clamp, test::Support::Guide, test::Support::None}) {
    const test::SampleBody body = test::trussBody({8, 6, 4}, test::comm());
    const SolverProblem problem = body.problem(support);
    Vector load = test::randomVector(problem.roles.size(), 4);
    if (support == test::Support::Clamp)
      for (std::size_t dof = 0; dof < load.size(); ++dof)
        load[dof] = problem.roles[dof] == DofRole::Fixed ? 0.0 : load[dof];
    else // what some displacement makes of it
      load = multiply(body.matrix, load, test::comm());
    RankProblem held = heldPart(problem, true);
    held.holding = freeMotions(problem, test::comm()).held;
    const FarBody far(body.matrix, held, beyond);
    Ledger ledger;
    const auto solver = test::makeSolver("Multigrid", R"(<Parameter name="Tolerance" type="double" value="1e-12"/>)");
    const auto shared = solver->share(far.problem, test::comm(), ledger);
    const IndexMap nodes = far.matrix.nodes.withoutGhosts();
    const NodalField given(nodes, 3, ownPart(body.matrix, load));
    const NodalField u = wholeSolver(*shared)->solveFree(given, NodalField(nodes, 3), Exactness::Full);
    EXPECT_EQ(ledger.counted("multigrid set-ups"), 1);
    EXPECT_LE(ledger.counted("Krylov iterations"), 40);

    const NodalField expected =
        wholeSolver(*solver->factor(problem, test::comm(), ledger))
            ->solveFree(NodalField(body.matrix.nodes.withoutGhosts(), 3, ownPart(body.matrix, load)),
                        NodalField(body.matrix.nodes.withoutGhosts(), 3), Exactness::Full);
    EXPECT_LT(relativeTo({u.begin(), u.end()}, {expected.begin(), expected.end()}), 1e-9);
    Vector left = multiply(body.matrix, onEveryRank(expected, test::comm()).whole(), test::comm());
    for (std::size_t dof = 0; dof < left.size(); ++dof)
      left[dof] = problem.roles[dof] == DofRole::Fixed ? 0.0 : left[dof] - load[dof];
    EXPECT_LT(largestEntry(left), 1e-10 * largestEntry(load)) << "there too where the body is held";
  }
}

TEST(FarNumbers, ABodyThatNothingHoldsIsNotSolved)
{
  const test::SampleBody body = test::trussBody({8, 6, 4}, test::comm());
  RankProblem problem = heldPart(body.problem(test::Support::None), true);
  problem.isHeld = false;
  Ledger ledger;
  const auto shared = test::makeSolver("Multigrid")->share(problem, test::comm(), ledger);
  const NodalField zero(body.matrix.nodes.withoutGhosts(), 3);
  EXPECT_THROW(wholeSolver(*shared)->solveFree(zero, zero, Exactness::Full), SingularBody);
}

TEST(FarNumbers, JoinedBodiesMoveTheSame)
{
  int iterations = 0, expectedIterations = 0;
  FarPair far(beyond), near(0);
  const std::vector<Vector> u = far.solve(iterations), expected = near.solve(expectedIterations);
  for (std::size_t body = 0; body < 2; ++body) {
    EXPECT_GT(norm(expected[body]), 0.0);
    EXPECT_LT(relativeTo(u[body], expected[body]), 1e-9);
  }
  EXPECT_NEAR(iterations, expectedIterations, 2);
  EXPECT_GT(far.firstBody().problem.kept.front(), INT32_MAX);
}

} // namespace ndframe
