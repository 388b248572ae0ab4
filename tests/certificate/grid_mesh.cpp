#include "certificate/grid_mesh.hpp"

#include <algorithm>

namespace ndframe::test
{
namespace
{

/// Cells of a grid, two triangles each.
class Triangulation
{
public:
  Triangulation(const Rectangle& rectangle, Draw& draw)
      : rectangle_(rectangle), nx_(int(rectangle.x.size()) - 1), ny_(int(rectangle.y.size()) - 1)
  {
    mesh_.dim = 2;
    for (int j = 0; j < ny_; ++j)
      for (int i = 0; i < nx_; ++i)
        addCell(point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1), draw.chance(0.5));
    addSides();
  }

  void addPoints(double jitter, const std::function<double(double)>& lift, const Frame& frame, Draw& draw)
  {
    const auto& [x, y] = std::tie(rectangle_.x, rectangle_.y);
    for (std::size_t j = 0; j < y.size(); ++j)
      for (std::size_t i = 0; i < x.size(); ++i) {
        double px = x[i], py = y[j];
        if (i > 0 && j > 0 && i + 1 < x.size() && j + 1 < y.size()) {
          px += jitter * draw.uniform(-1.0, 1.0) * std::min(x[i] - x[i - 1], x[i + 1] - x[i]);
          py += jitter * draw.uniform(-1.0, 1.0) * std::min(y[j] - y[j - 1], y[j + 1] - y[j]);
        }
        const auto p = frame.turned(frame.length * px, frame.length * (py + lift(px)));
        mesh_.points.insert(mesh_.points.end(), p.begin(), p.end());
      }
  }

  Mesh take() { return std::move(mesh_); }

private:
  int point(int i, int j) const { return j * (nx_ + 1) + i; }

  void addCell(int a, int b, int c, int d, bool rising)
  {
    const std::array<int, 6> cells = rising ? std::array{a, b, c, a, c, d} : std::array{a, b, d, b, c, d};
    mesh_.cells.insert(mesh_.cells.end(), cells.begin(), cells.end());
  }

  /// The facet between two points.
  Facet facet(int a, int b) const
  {
    for (int c = 0; c < mesh_.numCells(); ++c)
      for (int k = 0; k < 3; ++k) {
        const int p = mesh_.cell(c)[(k + 1) % 3], q = mesh_.cell(c)[(k + 2) % 3];
        if (std::minmax(p, q) == std::minmax(a, b))
          return {c, k};
      }
    return {-1, -1};
  }

  void addSides()
  {
    mesh_.sides = {{"left", {}}, {"right", {}}, {"bottom", {}}, {"top", {}}};
    for (int j = 0; j < ny_; ++j) {
      mesh_.sides[0].facets.push_back(facet(point(0, j), point(0, j + 1)));
      mesh_.sides[1].facets.push_back(facet(point(nx_, j), point(nx_, j + 1)));
    }
    for (int i = 0; i < nx_; ++i) {
      mesh_.sides[2].facets.push_back(facet(point(i, 0), point(i + 1, 0)));
      mesh_.sides[3].facets.push_back(facet(point(i, ny_), point(i + 1, ny_)));
    }
    if (rectangle_.split.empty())
      return;
    Side first{rectangle_.first, {}}, second{rectangle_.second, {}};
    const Side& whole = *mesh_.findSide(rectangle_.split);
    for (std::size_t i = 0; i < whole.facets.size(); ++i)
      (rectangle_.x[i + 1] <= rectangle_.at * (1.0 + 1e-12) ? first : second).facets.push_back(whole.facets[i]);
    mesh_.sides.push_back(first);
    mesh_.sides.push_back(second);
  }

  const Rectangle& rectangle_;
  int nx_, ny_;
  Mesh mesh_;
};

} // namespace

std::vector<double> gridLines(double from, double to, int cells)
{
  std::vector<double> lines;
  for (int i = 0; i <= cells; ++i)
    lines.push_back(i == cells ? to : from + (to - from) * i / cells);
  return lines;
}

std::vector<double> shaken(std::vector<double> lines, Draw& draw)
{
  const std::vector<double> old = lines;
  for (std::size_t i = 1; i + 1 < lines.size(); ++i)
    lines[i] += draw.uniform(-0.33, 0.33) * std::min(old[i] - old[i - 1], old[i + 1] - old[i]);
  return lines;
}

Mesh randomMesh(const Rectangle& rectangle, double jitter, const std::function<double(double)>& lift,
                const Frame& frame, Draw& draw)
{
  Triangulation triangulation(rectangle, draw);
  triangulation.addPoints(jitter, lift, frame, draw);
  return triangulation.take();
}

} // namespace ndframe::test
