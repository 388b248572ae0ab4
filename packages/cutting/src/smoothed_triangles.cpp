#include "smoothed_triangles.hpp"

#include <algorithm>

#include "ndframe/mesh/shape.hpp"

namespace ndframe
{
namespace
{

constexpr int sweeps = 8;
/// Triangles with a better shape are left alone.
constexpr double goodEnough = 0.6;
/// A move must better the worst shape by this factor.
constexpr double gain = 1.02;
/// Lengths of moves that are tried, relative to the shortest edge at a point, in as many directions.
constexpr std::array<double, 3> steps{0.5, 0.2, 0.05};
constexpr int directions = 8;

class Smoothing
{
public:
  Smoothing(std::vector<Flat>& points, const std::vector<Freedom>& freedoms,
            const std::vector<std::array<int, 3>>& triangles, const std::vector<char>& counts)
      : points_(points), first_(points), freedoms_(freedoms), triangles_(triangles), counts_(counts),
        around_(points.size())
  {
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const int p : triangles[t])
        around_[std::size_t(p)].push_back(t);
  }

  /// Whether anything was moved.
  bool sweep()
  {
    bool any = false;
    for (std::size_t p = 0; p < points_.size(); ++p)
      if (freedoms_[p].kind != Freedom::Kind::Fixed)
        any = improve(p) || any;
    return any;
  }

private:
  /// Of the triangles around a point; negative where one is turned over.
  double worstShape(std::size_t p) const
  {
    double worst = 1.0;
    for (const std::size_t t : around_[p]) {
      const auto& corners = triangles_[t];
      const auto at = [&](std::size_t k) { return points_[std::size_t(corners[k])].data(); };
      const double shape = triangleShape(at(0), at(1), at(2));
      if (counts_[t] != 0 || shape <= 0.0)
        worst = std::min(worst, shape);
    }
    return worst;
  }

  double shortestEdge(std::size_t p) const
  {
    double shortest = HUGE_VAL;
    for (const std::size_t t : around_[p])
      for (const int q : triangles_[t])
        if (std::size_t(q) != p)
          shortest = std::min(shortest, std::hypot(points_[std::size_t(q)][0] - points_[p][0],
                                                   points_[std::size_t(q)][1] - points_[p][1]));
    return shortest;
  }

  bool improve(std::size_t p)
  {
    double best = worstShape(p);
    if (around_[p].empty() || best > goodEnough)
      return false;
    const double length = shortestEdge(p);
    const Flat start = points_[p];
    Flat place = start;
    for (const double step : steps)
      for (int k = 0; k < directions; ++k) {
        const double angle = 2.0 * M_PI * k / directions;
        const auto to =
            allowed(p, {start[0] + step * length * std::cos(angle), start[1] + step * length * std::sin(angle)});
        points_[p] = to;
        if (const double shape = worstShape(p); shape > gain * std::max(best, 0.0) && shape > best) {
          best = shape;
          place = to;
        }
      }
    points_[p] = place;
    return place != start;
  }

  /// The place that is allowed nearest to one that is wanted.
  Flat allowed(std::size_t p, Flat to) const
  {
    const Freedom& freedom = freedoms_[p];
    const Flat& from = first_[p];
    if (freedom.kind == Freedom::Kind::OnLine) {
      const double t = ((to[0] - from[0]) * freedom.way[0] + (to[1] - from[1]) * freedom.way[1]) /
                       (freedom.way[0] * freedom.way[0] + freedom.way[1] * freedom.way[1]);
      to = {from[0] + t * freedom.way[0], from[1] + t * freedom.way[1]};
    }
    const double far = std::hypot(to[0] - from[0], to[1] - from[1]);
    if (far > freedom.most)
      for (std::size_t k = 0; k < 2; ++k)
        to[k] = from[k] + freedom.most / far * (to[k] - from[k]);
    return to;
  }

  std::vector<Flat>& points_;
  const std::vector<Flat> first_;
  const std::vector<Freedom>& freedoms_;
  const std::vector<std::array<int, 3>>& triangles_;
  const std::vector<char>& counts_;
  std::vector<std::vector<std::size_t>> around_; ///< per point its triangles
};

} // namespace

void smoothTriangles(std::vector<Flat>& points, const std::vector<Freedom>& freedoms,
                     const std::vector<std::array<int, 3>>& triangles, const std::vector<char>& counts)
{
  Smoothing smoothing(points, freedoms, triangles, counts);
  for (int s = 0; s < sweeps && smoothing.sweep(); ++s) {
  }
}

} // namespace ndframe
