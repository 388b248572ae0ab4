#include <gmock/gmock.h>

#include "ndframe/algebra/linear_program.hpp"

namespace ndframe
{
namespace
{

using testing::DoubleNear;
using testing::Pointwise;

/// x + y <= 4, x + 3 y <= 6, 0 <= x <= 3, 0 <= y.
LinearProgram corner(const Vector& cost)
{
  return {
      cost,      {0.0, 0.0}, {3.0, unbounded}, {{{0, 1.0}, {1, 1.0}}, {{0, 1.0}, {1, 3.0}}}, {-unbounded, -unbounded},
      {4.0, 6.0}};
}

TEST(LinearProgram, IsSolvedAtTheVertexThatItsCostPointsTo)
{
  EXPECT_THAT(*solve(corner({1.0, 2.0})), Pointwise(DoubleNear(1e-12), Vector{3.0, 1.0}));
  EXPECT_THAT(*solve(corner({1.0, 4.0})), Pointwise(DoubleNear(1e-12), Vector{0.0, 2.0}));
  EXPECT_THAT(*solve(corner({-1.0, -1.0})), Pointwise(DoubleNear(1e-12), Vector{0.0, 0.0}));
}

TEST(LinearProgram, TakesRowsFromBothSides)
{
  LinearProgram program = corner({0.0, -1.0});
  program.rowLower = {2.0, 3.0};
  EXPECT_THAT(*solve(program), Pointwise(DoubleNear(1e-12), Vector{3.0, 0.0}));
  program.rowLower[0] = program.rowUpper[0] = 3.5;
  EXPECT_NEAR((*solve(program))[1], 0.5, 1e-12);
}

TEST(LinearProgram, WithoutASolutionHasNone)
{
  LinearProgram program = corner({1.0, 1.0});
  program.rowLower[0] = 5.0; // x + y
  program.rowUpper[0] = unbounded;
  program.rowUpper[1] = 3.0;
  EXPECT_FALSE(solve(program)) << "no x meets the rows";
  EXPECT_FALSE(solve({{1.0}, {0.0}, {unbounded}, {}, {}, {}})) << "no bound";
}

} // namespace
} // namespace ndframe
