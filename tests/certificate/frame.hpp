#pragma once

#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace ndframe::test
{

/// Scenes are drawn in a unit frame (X, Y) and put into space: lengths multiplied, axes turned.
struct Frame
{
  double length = 1.0;
  double degrees = 0.0;

  double cosine() const { return std::cos(degrees * std::acos(-1.0) / 180.0); }
  double sine() const { return std::sin(degrees * std::acos(-1.0) / 180.0); }

  /// Components of the unit frame's vector in space.
  std::array<double, 2> turned(double x, double y) const
  {
    return {cosine() * x - sine() * y, sine() * x + cosine() * y};
  }

  /// An expression in X and Y as one in x and y.
  std::string expression(const std::string& text) const
  {
    const std::string X = fmt::format("(({}*x+{}*y)/{})", cosine(), sine(), length);
    const std::string Y = fmt::format("(({}*y-{}*x)/{})", cosine(), sine(), length);
    std::string result;
    for (const char c : text)
      result += c == 'X' ? X : c == 'Y' ? Y : std::string(1, c);
    return result;
  }
};

} // namespace ndframe::test
