#include "ndframe/mesh/cells_of_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr double roundOff = 1e-9; ///< of a barycentric coordinate

double dot3(const double* a, const double* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The barycentric coordinates of a simplex as affine functions: lambda_v (x) = gradient_v . (x - x_0) + (v == 0).
struct Barycentric
{
  Barycentric(const Mesh& mesh, int cell) : dim(mesh.dim)
  {
    for (int v = 0; v <= dim; ++v)
      for (int k = 0; k < dim; ++k)
        x[v][k] = mesh.point(mesh.cell(cell)[v])[k];
    if (dim == 2)
      invertPlane();
    else
      invertSpace();
    for (int v = 1; v <= dim; ++v)
      for (int k = 0; k < dim; ++k)
        gradient[0][k] -= gradient[v][k];
  }

  std::array<double, 4> at(const double* point) const
  {
    std::array<double, 4> lambda{};
    double d[3] = {};
    for (int k = 0; k < dim; ++k)
      d[k] = point[k] - x[0][k];
    lambda[0] = 1.0;
    for (int v = 1; v <= dim; ++v) {
      lambda[std::size_t(v)] = dot3(gradient[v], d);
      lambda[0] -= lambda[std::size_t(v)];
    }
    return lambda;
  }

  /// The largest distance from the plane of a face, on its outer side; negative inside.
  double outside(const std::array<double, 4>& lambda) const
  {
    double largest = -std::numeric_limits<double>::infinity();
    for (int v = 0; v <= dim; ++v)
      largest = std::max(largest, -lambda[std::size_t(v)] / std::sqrt(dot3(gradient[v], gradient[v])));
    return largest;
  }

  int dim;
  double x[4][3] = {}, gradient[4][3] = {};

private:
  void invertPlane()
  {
    const double a[2] = {x[1][0] - x[0][0], x[1][1] - x[0][1]}, b[2] = {x[2][0] - x[0][0], x[2][1] - x[0][1]};
    const double area = a[0] * b[1] - a[1] * b[0];
    gradient[1][0] = b[1] / area;
    gradient[1][1] = -b[0] / area;
    gradient[2][0] = -a[1] / area;
    gradient[2][1] = a[0] / area;
  }

  void invertSpace()
  {
    double e[3][3];
    for (int v = 0; v < 3; ++v)
      for (int k = 0; k < 3; ++k)
        e[v][k] = x[v + 1][k] - x[0][k];
    for (int v = 0; v < 3; ++v) {
      const double *a = e[(v + 1) % 3], *b = e[(v + 2) % 3];
      const double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
      for (int k = 0; k < 3; ++k)
        gradient[v + 1][k] = cross[k] / dot3(cross, e[v]);
    }
  }
};

/// Points in the order of x, which every cell is compared with.
class PointSearch
{
public:
  PointSearch(const Mesh& mesh, const std::vector<std::vector<double>>& points, double tolerance)
      : mesh_(mesh), points_(points), tolerance_(tolerance), order_(points.size()), nearest_(points.size()),
        least_(points.size(), std::numeric_limits<double>::infinity()), found_(points.size())
  {
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](int a, int b) { return x(a) < x(b); });
  }

  void look(int cell)
  {
    const Barycentric coordinates(mesh_, cell);
    double lower[3], upper[3], room = tolerance_;
    for (int k = 0; k < mesh_.dim; ++k) {
      lower[k] = upper[k] = coordinates.x[0][k];
      for (int v = 1; v <= mesh_.dim; ++v) {
        lower[k] = std::min(lower[k], coordinates.x[v][k]);
        upper[k] = std::max(upper[k], coordinates.x[v][k]);
      }
      room += roundOff * (upper[k] - lower[k]);
    }
    auto point = std::lower_bound(order_.begin(), order_.end(), lower[0] - room,
                                  [&](int a, double value) { return x(a) < value; });
    for (; point != order_.end() && x(*point) <= upper[0] + room; ++point)
      if (isNear(*point, lower, upper, room))
        compare(cell, coordinates, std::size_t(*point));
  }

  std::vector<std::vector<PointInCell>> result() &&
  {
    for (std::size_t i = 0; i < found_.size(); ++i)
      if (found_[i].empty() && least_[i] <= tolerance_)
        found_[i] = {nearest_[i]};
    return std::move(found_);
  }

private:
  double x(int point) const { return points_[std::size_t(point)][0]; }

  bool isNear(int point, const double* lower, const double* upper, double room) const
  {
    for (int k = 1; k < mesh_.dim; ++k) {
      const double value = points_[std::size_t(point)][std::size_t(k)];
      if (value < lower[k] - room || value > upper[k] + room)
        return false;
    }
    return true;
  }

  void compare(int cell, const Barycentric& coordinates, std::size_t point)
  {
    const auto lambda = coordinates.at(points_[point].data());
    const double smallest = *std::min_element(lambda.begin(), lambda.begin() + mesh_.dim + 1);
    if (smallest >= -roundOff)
      found_[point].push_back({cell, lambda});
    const double outside = coordinates.outside(lambda);
    if (outside < least_[point]) {
      least_[point] = outside;
      nearest_[point] = {cell, lambda, outside};
    }
  }

  const Mesh& mesh_;
  const std::vector<std::vector<double>>& points_;
  const double tolerance_;
  std::vector<int> order_;
  std::vector<PointInCell> nearest_; ///< per point
  std::vector<double> least_;        ///< the same
  std::vector<std::vector<PointInCell>> found_;
};

} // namespace

std::vector<std::vector<PointInCell>> cellsOfPoints(const Mesh& mesh, const std::vector<std::vector<double>>& points,
                                                    double tolerance, int numCells)
{
  for (const auto& point : points)
    NDFRAME_ASSERT(int(point.size()) == mesh.dim, "a point has dim coordinates");
  PointSearch search(mesh, points, tolerance);
  for (int cell = 0; cell < (numCells < 0 ? mesh.numCells() : numCells); ++cell)
    search.look(cell);
  return std::move(search).result();
}

std::vector<double> pointAt(const Mesh& mesh, const PointInCell& place)
{
  std::vector<double> point(std::size_t(mesh.dim), 0.0);
  for (int v = 0; v <= mesh.dim; ++v)
    for (std::size_t k = 0; k < point.size(); ++k)
      point[k] += place.lambda[std::size_t(v)] * mesh.point(mesh.cell(place.cell)[v])[k];
  return point;
}

} // namespace ndframe
