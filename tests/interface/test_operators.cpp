#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "interface/box_bodies.hpp"
#include "ndframe/interface/applied_operator.hpp"
#include "ndframe/interface/composed_operator.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// A box held at its left side, with the vertical displacement of its bottom (but for the held corner) as trace.
struct HeldBox
{
  explicit HeldBox(int order)
      : model(boxBody("body", box("0, 0", "2, 1", "4, 2"), order,
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

DenseMatrix randomSymmetric(int n, unsigned seed)
{
  DenseMatrix A(n, n);
  const Vector values = randomVector(std::size_t(n * n), seed);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      A(i, j) = values[std::size_t(i * n + j)] + values[std::size_t(j * n + i)];
  return A;
}

/// Two parts with sums of two unknowns, unused entries and another order.
std::vector<OperatorPart> sampleParts(bool firstStored, bool secondStored)
{
  const auto make = [](DenseMatrix A, bool stored) -> std::shared_ptr<const SymmetricOperator> {
    if (stored)
      return makeDenseOperator(std::move(A));
    return appliedOnly(std::move(A), 1e-9);
  };
  return {{make(randomSymmetric(3, 1), firstStored), {{2, -1}, {0, 4}, {1, 3}}},
          {make(randomSymmetric(2, 2), secondStored), {{-1, 4}, {3, -1}}}};
}

/// sum_b P_b^T S_b P_b from its definition.
DenseMatrix sampleSum()
{
  DenseMatrix sum(5, 5);
  for (const auto& part : sampleParts(true, true)) {
    DenseMatrix P(int(part.inputs.size()), 5);
    for (int k = 0; k < P.rows(); ++k)
      for (const int i : part.inputs[std::size_t(k)])
        if (i >= 0)
          P(k, i) += 1.0;
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j)
        sum(i, j) += dot(P.column(i), part.S->apply(P.column(j)));
  }
  return sum;
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

TEST(InterfaceOperators, MatrixFreePaysOneBackSolveAProduct)
{
  HeldBox box(1);
  const auto S = makeInterfaceOperator("Matrix Free")->represent(*box.body.condensed, box.size());
  EXPECT_EQ(S->dense(), nullptr);
  const auto before = box.body.ledger.counted("back-solves");
  S->apply(Vector(std::size_t(box.size()), 1.0));
  EXPECT_EQ(box.body.ledger.counted("back-solves"), before + 1);
}

TEST(ComposedOperator, IsTheSumOverItsParts)
{
  for (const bool firstStored : {true, false})
    for (const bool secondStored : {true, false}) {
      const auto sum = composeOperators(sampleParts(firstStored, secondStored), 5);
      EXPECT_EQ(sum->size(), 5);
      EXPECT_EQ(sum->dense() != nullptr, firstStored && secondStored);
      EXPECT_LT(relativeDifference(columnsOf(*sum), sampleSum()), 1e-15);
    }
}

TEST(ComposedOperator, TakesTheCoarsestToleranceOfItsParts)
{
  EXPECT_EQ(toleranceOf(*composeOperators(sampleParts(true, false), 5)), 1e-9);
  EXPECT_EQ(toleranceOf(*composeOperators(sampleParts(true, true), 5)), 0.0);
}

TEST(ComposedOperator, OnePartInItsOwnOrderIsHandedBack)
{
  const std::shared_ptr<const SymmetricOperator> S = makeDenseOperator(randomSymmetric(2, 7));
  EXPECT_EQ(composeOperators({{S, {{0, -1}, {1, -1}}}}, 2), S);
  EXPECT_NE(composeOperators({{S, {{1, -1}, {0, -1}}}}, 2), S);
  EXPECT_NE(composeOperators({{S, {{0, -1}, {1, -1}}}}, 3), S);
}
