#include "simplex_piece.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

constexpr double touching = 1e-13; ///< of f's terms, as in enclosures

using Values = std::array<double, 4>;

double valueAt(const AffineFunction& f, const Region::Point& x)
{
  const double value = f[0] + f[1] * x[0] + f[2] * x[1] + f[3] * x[2];
  const double terms = std::abs(f[0]) + std::abs(f[1] * x[0]) + std::abs(f[2] * x[1]) + std::abs(f[3] * x[2]);
  return std::abs(value) <= touching * terms ? 0.0 : value;
}

/// An edge whose ends have different signs.
bool findChange(const Values& values, int dim, std::size_t& negative, std::size_t& positive)
{
  for (std::size_t a = 0; a <= std::size_t(dim); ++a)
    for (std::size_t b = 0; b <= std::size_t(dim); ++b)
      if (values[a] < 0.0 && values[b] > 0.0) {
        negative = a, positive = b;
        return true;
      }
  return false;
}

} // namespace

SimplexGeometry::SimplexGeometry(int dim, int space, const DataSampler::Vertices& vertices)
    : dim_(dim), space_(space), vertices_(vertices)
{
  for (std::size_t k = 0; k < std::size_t(space); ++k)
    isShared_[k] = std::all_of(vertices.begin(), vertices.begin() + dim + 1,
                               [&](const double* vertex) { return vertex[k] == vertices[0][k]; });
}

Samples::Piece SimplexGeometry::whole() const
{
  Samples::Piece piece;
  for (int corner = 0; corner <= dim_; ++corner)
    piece.corners[std::size_t(corner) * std::size_t(dim_ + 2)] = 1.0;
  return piece;
}

void SimplexGeometry::locate(const Samples::Piece& piece, const double* local, double* lambda) const
{
  for (int k = 0; k <= dim_; ++k) {
    lambda[k] = 0.0;
    for (int corner = 0; corner <= dim_; ++corner)
      lambda[k] += local[corner] * piece.corners[std::size_t(corner) * std::size_t(dim_ + 1) + std::size_t(k)];
  }
}

Region::Point SimplexGeometry::place(const double* lambda) const
{
  Region::Point x{};
  for (std::size_t k = 0; k < std::size_t(space_); ++k) {
    for (std::size_t v = 0; v <= std::size_t(dim_); ++v)
      x[k] += lambda[v] * vertices_[v][k];
    if (isShared_[k])
      x[k] = vertices_[0][k];
  }
  return x;
}

void SimplexGeometry::place(const QuadratureRule& rule, double* points) const
{
  const auto space = std::size_t(space_), corners = std::size_t(dim_) + 1, count = std::size_t(rule.size());
  std::fill_n(points, 3 * count, 0.0);
  for (std::size_t k = 0; k < space; ++k)
    for (std::size_t q = 0; q < count; ++q) {
      double x = 0.0;
      for (std::size_t v = 0; v < corners; ++v)
        x += rule.lambda[q * corners + v] * vertices_[v][k];
      points[3 * q + k] = isShared_[k] ? vertices_[0][k] : x;
    }
}

Region::Point SimplexGeometry::centroid() const
{
  const double share = 1.0 / (dim_ + 1), lambda[4] = {share, share, share, share};
  return place(lambda);
}

void SimplexGeometry::extent(Region::Point& middle, double& radius) const
{
  middle = centroid();
  radius = 0.0;
  for (std::size_t v = 0; v <= std::size_t(dim_); ++v)
    for (std::size_t k = 0; k < std::size_t(space_); ++k)
      radius = std::max(radius, std::abs(vertices_[v][k] - middle[k]));
}

std::vector<Region::Point> SimplexGeometry::corners(const Samples::Piece& piece) const
{
  std::vector<Region::Point> all;
  for (int corner = 0; corner <= dim_; ++corner)
    all.push_back(place(piece.corners.data() + std::ptrdiff_t(corner) * (dim_ + 1)));
  return all;
}

/// The piece with a corner moved to (1 - share) corner + share other.
Samples::Piece SimplexGeometry::replaced(const Samples::Piece& piece, int corner, int other, double share) const
{
  Samples::Piece moved = piece;
  for (int k = 0; k <= dim_; ++k) {
    double& lambda = moved.corners[std::size_t(corner) * std::size_t(dim_ + 1) + std::size_t(k)];
    lambda += share * (piece.corners[std::size_t(other) * std::size_t(dim_ + 1) + std::size_t(k)] - lambda);
  }
  moved.fraction *= 1.0 - share;
  return moved;
}

std::vector<Samples::Piece> SimplexGeometry::bisect(const Samples::Piece& piece) const
{
  const auto x = corners(piece);
  int first = 0, second = 1;
  double longest = -1.0;
  for (int a = 0; a <= dim_; ++a)
    for (int b = a + 1; b <= dim_; ++b) {
      double square = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
        square += std::pow(x[std::size_t(a)][k] - x[std::size_t(b)][k], 2);
      if (square > longest)
        longest = square, first = a, second = b;
    }
  return {replaced(piece, second, first, 0.5), replaced(piece, first, second, 0.5)};
}

/// One edge after the other is cut where f vanishes; the new corner takes part in no further change of sign.
std::vector<Samples::Piece> SimplexGeometry::cut(const Samples::Piece& piece, const AffineFunction& f) const
{
  Values start{};
  const auto x = corners(piece);
  for (std::size_t corner = 0; corner < x.size(); ++corner)
    start[corner] = valueAt(f, x[corner]);
  std::vector<std::pair<Samples::Piece, Values>> open{{piece, start}};
  std::vector<Samples::Piece> done;
  while (!open.empty()) {
    const auto [part, values] = open.back();
    open.pop_back();
    std::size_t a = 0, b = 0;
    if (!findChange(values, dim_, a, b)) {
      done.push_back(part);
      continue;
    }
    const double share = values[a] / (values[a] - values[b]); // from a to b
    open.emplace_back(replaced(part, int(b), int(a), 1.0 - share), values).second[b] = 0.0;
    open.emplace_back(replaced(part, int(a), int(b), share), values).second[a] = 0.0;
  }
  return done;
}

} // namespace ndframe
