#pragma once

#include <cmath>
#include <vector>

namespace ndframe
{

/// A force in the plane.
struct Force
{
  double x = 0.0, y = 0.0;
};

inline Force operator+(Force a, Force b)
{
  return {a.x + b.x, a.y + b.y};
}
inline Force operator-(Force a, Force b)
{
  return {a.x - b.x, a.y - b.y};
}
inline Force operator*(double s, Force a)
{
  return {s * a.x, s * a.y};
}
inline double dot(Force a, Force b)
{
  return a.x * b.x + a.y * b.y;
}
inline double norm(Force a)
{
  return std::hypot(a.x, a.y);
}

/// Forces that are handed on from cell to cell around a vertex:  d_k = d_(k-1) + steps[k-1], k = 1..m,  in a closed fan
/// d_m = d_0; some components are known at the ends of an open one. Among those the flows of least
/// sum_k weights[k] |d_k|^2.
struct Circulation
{
  struct Known
  {
    Force direction; ///< unit
    double value;    ///< d . direction
  };

  bool closed = false;
  std::vector<Force> steps;
  std::vector<double> weights; ///< of d_0, .., d_m; of a closed fan without d_m
  std::vector<Known> atFirst, atLast;
};

struct Flows
{
  std::vector<Force> flow; ///< d_0, .., d_m
  double defect = 0.0;     ///< force by which steps and known components contradict each other
};

/// A contradiction in a closed fan is divided equally among the steps; at the ends of an open one it is left there.
Flows leastFlows(const Circulation& problem);

} // namespace ndframe
