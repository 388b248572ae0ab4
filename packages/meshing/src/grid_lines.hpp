#pragma once

#include <vector>

namespace ndframe
{

/// Relative size of the cells along a line: `size[i]` at the increasing coordinates `at[i]`, linear in between and
/// constant outside. Only ratios count. Cells of linearly varying size form a geometric sequence.
struct SizeProfile
{
  std::vector<double> at;
  std::vector<double> size;
};

/// Profile on [lower, upper] whose last of `cells` cells is `ratio` times as long as the first.
SizeProfile geometricProfile(double lower, double upper, int cells, double ratio);

/// cells + 1 increasing coordinates from lower to upper. With h(x) the profile and xi(x) = int_lower^x dt / h(t), the
/// lines are equidistant in xi between neighbouring `breaks`; every break (sorted, inside, at most cells - 1 of them)
/// is exactly one of the lines, and the number of cells between two breaks is the nearest that xi asks for, at least
/// one.
std::vector<double> gridLines(double lower, double upper, int cells, const SizeProfile& profile,
                              const std::vector<double>& breaks);

} // namespace ndframe
