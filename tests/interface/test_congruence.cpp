#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "interface/box_bodies.hpp"
#include "ndframe/interface/applied_operator.hpp"
#include "ndframe/interface/congruence.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// Symmetric and positive definite, without zeros.
DenseMatrix fullMatrix(int size)
{
  DenseMatrix S(size, size);
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i)
      S(i, j) = (i == j ? size : 0) + 1.0 / (1.0 + i + j);
  return S;
}

std::shared_ptr<const SymmetricOperator> makeOperator(int size, bool isStored)
{
  if (isStored)
    return makeDenseOperator(fullMatrix(size));
  return appliedOnly(fullMatrix(size), 1e-13);
}

/// Rows of P that determine the unknowns one after the other, in an order at random, each by the ones before.
std::vector<SparseRow> determiningRows(std::mt19937& random, int size)
{
  std::uniform_real_distribution<double> coefficient(0.5, 2.0);
  std::vector<int> order;
  for (int i = 0; i < size; ++i)
    order.push_back(i);
  std::shuffle(order.begin(), order.end(), random);
  std::vector<SparseRow> rows;
  for (std::size_t k = 0; k < order.size(); ++k) {
    SparseRow row{{order[k], coefficient(random)}};
    if (k > 0 && random() % 2 == 0)
      row.emplace_back(order[random() % k], -coefficient(random));
    rows.push_back(row);
  }
  std::shuffle(rows.begin(), rows.end(), random);
  return rows;
}

/// Two parts that share out the rows of one P.
std::vector<CongruencePart> sampleParts(unsigned seed, int size, bool firstStored, bool secondStored)
{
  std::mt19937 random(seed);
  const auto rows = determiningRows(random, size);
  const int first = 1 + int(random() % unsigned(size - 1));
  return {{makeOperator(first, firstStored), {rows.begin(), rows.begin() + first}},
          {makeOperator(size - first, secondStored), {rows.begin() + first, rows.end()}}};
}

/// sum_b P_b^T S_b P_b from its definition.
DenseMatrix sumOf(const std::vector<CongruencePart>& parts, int size)
{
  DenseMatrix sum(size, size);
  for (const CongruencePart& part : parts) {
    DenseMatrix P(int(part.P.size()), size);
    for (int k = 0; k < P.rows(); ++k)
      for (const auto& [i, coefficient] : part.P[std::size_t(k)])
        P(k, i) += coefficient;
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        sum(i, j) += dot(P.column(i), part.S->apply(P.column(j)));
  }
  return sum;
}

void expectSame(const SymmetricOperator& S, const DenseMatrix& expected)
{
  ASSERT_EQ(S.size(), expected.cols());
  for (int j = 0; j < S.size(); ++j) {
    Vector unit(std::size_t(S.size()), 0.0);
    unit[std::size_t(j)] = 1.0;
    EXPECT_LT(relativeDifference(S.apply(unit), expected.column(j)), 1e-13);
  }
}

void expectSameInverse(const SymmetricOperator& S, const DenseMatrix& expected, const std::vector<char>& isFree)
{
  const Vector b = randomVector(isFree.size(), 5);
  const auto dense = makeDenseOperator(expected);
  EXPECT_LT(relativeDifference(S.inverseOn(isFree, 0.0)->solve(b), dense->inverseOn(isFree, 0.0)->solve(b)), 1e-9);
}

} // namespace

TEST(Congruence, IsTheSumOverItsPartsAndHasItsInverses)
{
  for (unsigned seed = 0; seed < 20; ++seed)
    for (const bool firstStored : {true, false})
      for (const bool secondStored : {true, false}) {
        const int size = 2 + int(seed % 7);
        const auto parts = sampleParts(seed, size, firstStored, secondStored);
        const auto S = congruence(parts, size);
        EXPECT_EQ(S->dense() != nullptr, firstStored && secondStored);
        const DenseMatrix expected = sumOf(parts, size);
        expectSame(*S, expected);
        std::mt19937 random(seed + 100);
        for (int set = 0; set < 6; ++set) {
          std::vector<char> isFree;
          for (int i = 0; i < size; ++i)
            isFree.push_back(set == 0 || i == 0 || random() % 2 == 0);
          expectSameInverse(*S, expected, isFree);
        }
      }
}

TEST(Congruence, MovesManyValuesByAMotion)
{
  const int n = 6;
  for (const bool isStored : {true, false}) {
    std::vector<SparseRow> P;
    for (int i = 0; i < n; ++i)
      P.push_back({{i, 1.0}, {n, 1.0}, {n + 1, 0.7 * i - 1.0}}); // a translation and a rotation
    const std::vector<CongruencePart> parts{{makeOperator(n, isStored), P}};
    const auto S = congruence(parts, n + 2, 2);
    const DenseMatrix expected = sumOf(parts, n + 2);
    expectSame(*S, expected);
    std::vector<char> isFree(n + 2, 1);
    isFree[0] = isFree[3] = 0; // else a motion is the same as a displacement of all
    expectSameInverse(*S, expected, isFree);
  }
}

TEST(Congruence, TakesTheCoarsestToleranceOfItsParts)
{
  EXPECT_EQ(toleranceOf(*congruence(sampleParts(1, 5, true, false), 5)), 1e-13);
  EXPECT_EQ(toleranceOf(*congruence(sampleParts(1, 5, true, true), 5)), 0.0);
}

TEST(Congruence, OnePartInItsOwnOrderIsHandedBack)
{
  const auto S = makeOperator(2, true);
  EXPECT_EQ(congruence({{S, {{{0, 1.0}}, {{1, 1.0}}}}}, 2), S);
  EXPECT_NE(congruence({{S, {{{1, 1.0}}, {{0, 1.0}}}}}, 2), S);
  EXPECT_NE(congruence({{S, {{{0, 2.0}}, {{1, 1.0}}}}}, 2), S);
  EXPECT_NE(congruence({{S, {{{0, 1.0}}, {{1, 1.0}}}}}, 3), S);
}
