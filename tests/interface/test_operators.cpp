#include <algorithm>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "interface/box_bodies.hpp"
#include "ndframe/interface/applied_operator.hpp"
#include "ndframe/interface/congruence.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// A box held at its left side, with the vertical displacement of its bottom (but for the held corner) as trace.
struct HeldBox
{
  explicit HeldBox(int order, const std::string& cells = "4, 2")
      : model(boxBody("body", box("0, 0", "2, 1", cells), order,
                      list("wall", text("Type", "Clamp") + text("Side", "left")))),
        traces(bottom()), body(model, traces)
  {}

  std::vector<TraceNormal> bottom() const
  {
    std::vector<TraceNormal> result;
    for (const int node : sideNodes(model.nodes, *model.side("bottom")))
      if (model.nodes.point(node)[0] > 0.0)
        result.push_back({node, {0.0, -1.0, 0.0}});
    return result;
  }
  int size() const { return int(traces.size()); }

  BodyModel model;
  std::vector<TraceNormal> traces;
  CondensedBox body;
};

DenseMatrix columnsOf(const SymmetricOperator& S)
{
  DenseMatrix all(S.size(), S.size());
  for (int j = 0; j < S.size(); ++j) {
    Vector e(std::size_t(S.size()), 0.0);
    e[std::size_t(j)] = 1.0;
    const Vector column = S.apply(e);
    std::copy(column.begin(), column.end(), all.col(j));
  }
  return all;
}

} // namespace

TEST(InterfaceOperators, AreTheSchurComplementOfTheAssembledBody)
{
  for (const int order : {1, 2}) {
    const HeldBox box(order);
    const DenseMatrix reference = DenseReference(box.body.problem).schur;
    for (const char* type : {"Automatic", "Condensed", "Matrix Free"}) {
      const auto S = makeInterfaceOperator(type)->represent(*box.body.condensed, box.size());
      ASSERT_EQ(S->size(), box.size());
      EXPECT_LT(relativeDifference(columnsOf(*S), reference), 1e-12) << type << ", order " << order;
    }
  }
}

TEST(InterfaceOperators, MatrixFreeInverseIsTheCondensedOne)
{
  const HeldBox box(2);
  const auto condensed = makeInterfaceOperator("Condensed")->represent(*box.body.condensed, box.size());
  const auto matrixFree = makeInterfaceOperator("Matrix Free")->represent(*box.body.condensed, box.size());
  std::vector<char> isFree(std::size_t(box.size()), 1);
  isFree[1] = isFree[4] = 0;
  const Vector b = randomVector(isFree.size(), 5);
  EXPECT_LT(
      relativeDifference(matrixFree->inverseOn(isFree, 0.0)->solve(b), condensed->inverseOn(isFree, 0.0)->solve(b)),
      1e-10);
}

TEST(InterfaceOperators, AutomaticStoresSmallOperatorsOnly)
{
  const HeldBox box(1);
  const auto represent = [&](const std::string& largest) {
    const std::string entry = "<Parameter name=\"Largest Condensed\" type=\"int\" value=\"" + largest + "\"/>\n";
    return makeInterfaceOperator("Automatic", entry)->represent(*box.body.condensed, box.size());
  };
  EXPECT_NE(represent("4")->dense(), nullptr);
  EXPECT_EQ(represent("3")->dense(), nullptr);
}

TEST(InterfaceOperators, MatrixFreePaysOneKeptSolveAProductAndOneForItsNeumannProblem)
{
  HeldBox box(1);
  const auto S = makeInterfaceOperator("Matrix Free")->represent(*box.body.condensed, box.size());
  EXPECT_EQ(S->dense(), nullptr);
  const Vector u = randomVector(std::size_t(box.size()), 6), force = S->apply(u);
  EXPECT_EQ(box.body.ledger.counted("kept solves"), 1);
  EXPECT_LT(relativeDifference(S->inverseOn(std::vector<char>(u.size(), 1), 0.0)->solve(force), u), 1e-12);
  EXPECT_EQ(box.body.ledger.counted("kept solves"), 2);
  EXPECT_EQ(box.body.ledger.counted("back-solves"), 0);
}

/// The inverse on a part of the interface is preconditioned by the Neumann problem: no more iterations on finer meshes.
TEST(InterfaceOperators, MatrixFreeInverseNeedsFewIterationsOnEveryMesh)
{
  for (const char* cells : {"8, 4", "64, 32"}) {
    HeldBox box(2, cells);
    const auto S = makeInterfaceOperator("Matrix Free")->represent(*box.body.condensed, box.size());
    std::vector<char> isFree(std::size_t(box.size()), 0);
    std::fill(isFree.begin() + box.size() / 3, isFree.end(), char(1));
    const Vector b = randomVector(isFree.size(), 5);
    Vector x = S->inverseOn(isFree, 0.0)->solve(b), reached;
    EXPECT_LT(box.body.ledger.counted("kept solves"), 80) << cells;
    reached = S->apply(x);
    for (std::size_t i = 0; i < b.size(); ++i)
      reached[i] = isFree[i] ? reached[i] : b[i];
    EXPECT_LT(relativeDifference(reached, b), 1e-11) << cells;
  }
}

namespace
{

/// Inverses on a set are the same, whether the parts are stored or applied.
void expectSameInverse(const HeldBox& box, const std::vector<std::vector<SparseRow>>& inputs, int size)
{
  const auto compose = [&](const char* type) {
    std::vector<CongruencePart> parts;
    for (const auto& input : inputs)
      parts.push_back({makeInterfaceOperator(type)->represent(*box.body.condensed, box.size()), input});
    return congruence(std::move(parts), size);
  };
  const auto stored = compose("Condensed"), applied = compose("Matrix Free");
  std::vector<char> isFree(std::size_t(size), 1);
  isFree[1] = isFree[std::size_t(size) - 2] = 0;
  const Vector b = randomVector(isFree.size(), 5);
  EXPECT_LT(relativeDifference(applied->inverseOn(isFree, 0.0)->solve(b), stored->inverseOn(isFree, 0.0)->solve(b)),
            1e-9);
}

} // namespace

TEST(Congruence, InverseOfSeparateBodiesIsTheirs)
{
  const HeldBox box(1);
  std::vector<SparseRow> first, second;
  for (int k = 0; k < box.size(); ++k) {
    first.push_back({{2 * k, 1.0}});
    second.push_back({{2 * k + 1, 1.0}});
  }
  expectSameInverse(box, {first, second}, 2 * box.size());
}

/// Unknowns w = u1 - u2 and d = u2, as all bodies in one system have them.
TEST(Congruence, InverseOfBodiesThatShareUnknownsIsPreconditionedByTheirs)
{
  const HeldBox box(2, "32, 16");
  const int n = box.size();
  std::vector<SparseRow> first, second;
  for (int k = 0; k < n; ++k) {
    first.push_back({{n + k, 1.0}, {k, 1.0}});
    second.push_back({{n + k, 1.0}});
  }
  const auto before = box.body.ledger.counted("kept solves");
  expectSameInverse(box, {first, second}, 2 * n);
  EXPECT_LT(box.body.ledger.counted("kept solves") - before, 100);
}
