#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "averages.hpp"

namespace ndframe
{
namespace
{

std::vector<SparseRow> randomRows(std::mt19937& random, int rows, int columns)
{
  std::uniform_real_distribution<double> coefficient(-1.0, 1.0);
  std::vector<SparseRow> B;
  for (int i = 0; i < rows; ++i) { // one entry that is its own, so that rows are independent; others may be shared
    SparseSum row(columns);
    row.add(i, 2.0 + coefficient(random));
    for (int k = 0; k < 2; ++k)
      row.add(int(random() % unsigned(columns)), coefficient(random));
    B.push_back(row.take());
  }
  return B;
}

TEST(Averages, GiveBackWhatTheRowsCombine)
{
  std::mt19937 random(3);
  for (int scene = 0; scene < 50; ++scene) {
    const int rows = 1 + int(random() % 6), columns = rows + 1 + int(random() % 8);
    const auto B = randomRows(random, rows, columns);
    Vector weights;
    for (int k = 0; k < columns; ++k)
      weights.push_back(std::pow(10.0, double(int(random() % 7) - 3)));
    const Averages averages = averagesOf(B, weights);
    for (std::size_t i = 0; i < B.size(); ++i)
      for (std::size_t j = 0; j < B.size(); ++j) {
        double product = 0.0, size = 0.0;
        for (const auto& [column, share] : averages.rows[i])
          for (const auto& [other, value] : B[j])
            if (column == other) {
              product += share * value;
              size += std::abs(share * value);
            }
        EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-9 * (1.0 + size)) << scene;
      }
  }
}

TEST(Averages, OfTwoEntriesGoByTheirWeights)
{
  const Averages averages = averagesOf({{{0, 1.0}, {1, 1.0}}}, {3.0, 1.0});
  EXPECT_EQ(averages.rows[0], (SparseRow{{0, 0.75}, {1, 0.25}}));
  EXPECT_EQ(averages.gramDiagonal, Vector{4.0});
}

} // namespace
} // namespace ndframe
