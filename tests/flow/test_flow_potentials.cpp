// Flows in a star: every cell gets what it needs, whatever its supports take.

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "ndframe/flow/flow_potentials.hpp"

namespace ndframe
{

namespace
{

constexpr int cells = 4;

Vector randomWrench(unsigned seed)
{
  std::mt19937 random(seed);
  Vector wrench(6);
  std::generate(wrench.begin(), wrench.end(),
                [&] { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); });
  return wrench;
}

/// A ring of cells, held by supports at some of them.
std::vector<FlowLink> ring(const std::vector<FlowLink>& supports)
{
  std::vector<FlowLink> links = supports;
  for (int cell = 0; cell < cells; ++cell)
    links.push_back({{cell, (cell + 1) % cells}, 0.5 + cell, {}});
  return links;
}

/// What a support takes: so many directions, not orthogonal.
DenseMatrix directions(int count)
{
  DenseMatrix through(6, count);
  for (int k = 0; k < count; ++k) {
    const Vector column = randomWrench(unsigned(k));
    std::copy(column.begin(), column.end(), through.col(k));
  }
  return through;
}

/// What flows out of every cell.
DenseMatrix outflow(const std::vector<FlowLink>& links, const DenseMatrix& potentials)
{
  DenseMatrix sum(6, cells);
  for (const FlowLink& link : links) {
    Vector flow = potentials.column(link.cell[0]);
    if (link.cell[1] >= 0)
      flow = difference(flow, potentials.column(link.cell[1]));
    else
      flow = multiply(link.through, multiplyTransposed(link.through, flow));
    for (int i = 0; i < 6; ++i) {
      sum(i, link.cell[0]) += link.conductance * flow[std::size_t(i)];
      if (link.cell[1] >= 0)
        sum(i, link.cell[1]) -= link.conductance * flow[std::size_t(i)];
    }
  }
  return sum;
}

/// Anything, but that all together do not work on the free motions.
DenseMatrix needs(const DenseMatrix& free)
{
  DenseMatrix needed(6, cells);
  Vector total(6, 0.0);
  for (int cell = 0; cell < cells; ++cell)
    for (int i = 0; i < 6; ++i)
      total[std::size_t(i)] += needed(i, cell) = randomWrench(10 + unsigned(cell))[std::size_t(i)];
  const Vector left = multiply(free, multiplyTransposed(free, total));
  for (int i = 0; i < 6; ++i)
    needed(i, 0) -= left[std::size_t(i)];
  return needed;
}

} // namespace

TEST(FlowPotentials, BringEveryCellWhatItNeeds)
{
  for (const int held : {0, 1, 3, 6}) {
    std::vector<FlowLink> supports;
    if (held > 0)
      supports = {{{1, -1}, 2.0, directions(held)}, {{3, -1}, 0.3, directions(1)}};
    const std::vector<FlowLink> links = ring(supports);
    const DenseMatrix free = freeMotions(links);
    ASSERT_EQ(free.cols(), 6 - held);
    const DenseMatrix needed = needs(free), found = outflow(links, potentials(links, free, needed));
    for (int cell = 0; cell < cells; ++cell)
      EXPECT_LT(largestEntry(difference(found.column(cell), needed.column(cell))), 1e-12) << held;
  }
}

TEST(FlowPotentials, FreeMotionsAreThoseThatNoSupportResists)
{
  const DenseMatrix through = directions(2), free = freeMotions(ring({{{0, -1}, 1.0, through}}));
  EXPECT_EQ(free.cols(), 4);
  const DenseMatrix resisted = multiplyTransposed(through, free), products = multiplyTransposed(free, free);
  for (int j = 0; j < free.cols(); ++j) {
    EXPECT_LT(largestEntry(resisted.column(j)), 1e-13);
    for (int i = 0; i < free.cols(); ++i)
      EXPECT_NEAR(products(i, j), i == j ? 1.0 : 0.0, 1e-14);
  }
}

} // namespace ndframe
