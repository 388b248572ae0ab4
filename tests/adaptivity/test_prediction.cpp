#include "ndframe/adaptivity/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

using namespace ndframe;

namespace
{

using Cells = std::vector<std::vector<CellDecay>>;

CellDecay smoothCell(double eta, int degree)
{
  return {2.0 * std::log2(eta), degree + 1.0};
}

double total(const Cells& cells)
{
  double squared = 0.0;
  for (const auto& body : cells)
    for (const CellDecay& cell : body)
      squared += std::exp2(cell.logSquared);
  return std::sqrt(squared);
}

/// Smooth cells with contributions over nine orders of magnitude.
Cells roughCells(unsigned seed, int degree)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-9.0, 0.0);
  Cells cells(2);
  for (auto& body : cells)
    for (int c = 0; c < 200; ++c)
      body.push_back(smoothCell(std::pow(10.0, exponent(random)), degree));
  return cells;
}

} // namespace

TEST(Prediction, ReachesItsTargetByItsOwnModelWithoutMuchMore)
{
  for (const int degree : {1, 2})
    for (const double part : {0.5, 0.1, 0.01}) {
      const Cells cells = roughCells(1, degree);
      const double target = part * total(cells);
      const Prediction prediction = predictRefinement(cells, target, {degree, 2});
      double squared = 0.0;
      std::int64_t number = 0;
      for (const auto& body : cells)
        for (const CellDecay& cell : body) {
          const int n = smoothHalvings(cell.logSquared, prediction.level, {degree, 2});
          squared += std::exp2(cell.logSquared - degree * n);
          number += std::int64_t(1) << n;
        }
      EXPECT_LE(std::sqrt(squared), target);
      EXPECT_GT(std::sqrt(squared), 0.7 * target) << "more cells than needed";
      EXPECT_NEAR(prediction.error, std::sqrt(squared), 1e-12 * target);
      EXPECT_EQ(prediction.numCells, number);
    }
}

TEST(Prediction, NewCellsContributeTheSameUpToOneHalving)
{
  const int degree = 2;
  const Cells cells = roughCells(2, degree);
  const Prediction prediction = predictRefinement(cells, 0.01 * total(cells), {degree, 2});
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (const auto& body : cells)
    for (const CellDecay& cell : body) {
      const int n = smoothHalvings(cell.logSquared, prediction.level, {degree, 2});
      const double each = cell.logSquared - (degree + 1) * n;
      largest = std::max(largest, each);
      least = n == 0 ? least : std::min(least, each);
    }
  EXPECT_LE(largest - least, degree + 1 + 1e-9);
}

TEST(Prediction, HalvesEqualCellsEqually)
{
  const Cells equal{std::vector<CellDecay>(7, smoothCell(0.3, 2)), std::vector<CellDecay>(5, smoothCell(0.3, 2))};
  // Two halvings leave 2^(-2 * 2) of the square.
  const Prediction prediction = predictRefinement(equal, total(equal) / 4.0 * (1.0 + 1e-9), {2, 2});
  EXPECT_EQ(smoothHalvings(equal[0][0].logSquared, prediction.level, {2, 2}), 2);
  EXPECT_EQ(prediction.numCells, 48);
}

TEST(Prediction, DoesNotDependOnTheUnitOfEnergy)
{
  const Cells cells = roughCells(3, 2);
  Cells scaled = cells;
  for (auto& body : scaled)
    for (CellDecay& cell : body)
      cell.logSquared += 80.0;
  const double target = 0.03 * total(cells);
  const Prediction prediction = predictRefinement(cells, target, {2, 2});
  const Prediction same = predictRefinement(scaled, target * 0x1p40, {2, 2});
  EXPECT_EQ(prediction.numCells, same.numCells);
  EXPECT_NEAR(prediction.level + 80.0, same.level, 1e-2);
}

TEST(Prediction, AsksForNothingWhereTheTargetIsMetOrNothingContributes)
{
  const Cells cells = roughCells(4, 2);
  EXPECT_EQ(predictRefinement(cells, 1.01 * total(cells), {2, 2}).numCells, 400);
  const Cells silent{std::vector<CellDecay>(3, CellDecay{-std::numeric_limits<double>::infinity(), 3.0})};
  const Prediction none = predictRefinement(silent, 1.0, {2, 2});
  EXPECT_EQ(none.numCells, 3);
  EXPECT_EQ(none.error, 0.0);
}

TEST(Prediction, GradedCellsAtACornerConvergeLikeSmoothOnes)
{
  // Graded towards a corner, the error falls like N^(-p/2) whatever lambda is; only the constant knows it.
  const double lambda = 0.7;
  const int degree = 2;
  const Cells corner{{CellDecay{0.0, lambda}}}, smooth{{CellDecay{0.0, degree + 1.0 - 1e-12}}};
  for (const double target : {1e-2, 1e-3}) {
    const Prediction there = predictRefinement(corner, target, {degree, 2}),
                     elsewhere = predictRefinement(smooth, target, {degree, 2});
    EXPECT_NEAR(double(there.numCells) / double(elsewhere.numCells),
                std::pow((degree + 1.0) / lambda, 1.0 + 1.0 / degree),
                0.02 * double(there.numCells) / double(elsewhere.numCells));
  }
}
