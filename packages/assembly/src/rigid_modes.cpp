#include "ndframe/assembly/rigid_modes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

namespace ndframe
{
namespace
{

constexpr double pure = 1e-6; ///< parts of a unit motion below this are round-off

/// What is left of `candidate` after removing its part in the orthonormal `basis`.
Vector remainder(Vector candidate, const std::vector<Vector>& basis)
{
  for (const auto& b : basis) {
    const double along = dot(b, candidate);
    for (std::size_t i = 0; i < candidate.size(); ++i)
      candidate[i] -= along * b[i];
  }
  return candidate;
}

/// The part of a motion that is not in `named`, of unit length and joined to it; nothing when it is round-off.
std::optional<Vector> takeNew(const Vector& motion, std::vector<Vector>& named)
{
  Vector rest = remainder(motion, named);
  const double size = norm(rest);
  if (size < pure)
    return std::nullopt;
  for (double& value : rest)
    value /= size;
  named.push_back(rest);
  return rest;
}

std::vector<Vector> columns(const DenseMatrix& matrix)
{
  std::vector<Vector> all;
  for (int j = 0; j < matrix.cols(); ++j)
    all.push_back(matrix.column(j));
  return all;
}

/// Orthonormal basis of the motions among `motions` (orthonormal columns) that do not turn the body.
std::vector<Vector> translationsAmong(const RigidBasis& basis, const DenseMatrix& motions)
{
  DenseMatrix turning(basis.size() - basis.dim, motions.cols());
  for (int i = 0; i < turning.rows(); ++i)
    for (int j = 0; j < turning.cols(); ++j)
      turning(i, j) = std::abs(motions(basis.dim + i, j)) < pure ? 0.0 : motions(basis.dim + i, j);
  std::vector<Vector> translations;
  for (const auto& combination : columns(nullSpace(turning, pure)))
    translations.push_back(multiply(motions, combination));
  return translations;
}

/// "(0.5, 1)"; entries that are round-off against `scale` are zero.
std::string tuple(const Vector& values, double scale)
{
  std::vector<std::string> texts;
  for (const double value : values)
    texts.push_back(fmt::format("{:.3g}", std::abs(value) < pure * scale ? 0.0 : value));
  return fmt::format("({})", fmt::join(texts, ", "));
}

/// Turns a unit vector so that its largest entry is positive.
Vector positive(Vector direction)
{
  const auto largest = *std::max_element(direction.begin(), direction.end(),
                                         [](double a, double b) { return std::abs(a) + pure < std::abs(b); });
  if (largest < 0.0)
    for (double& value : direction)
      value = -value;
  return direction;
}

std::string describeTranslation(const RigidBasis& basis, const Vector& c)
{
  constexpr std::array<const char*, 3> axis{"x", "y", "z"};
  const Vector direction = positive(Vector(c.begin(), c.begin() + basis.dim));
  for (std::size_t k = 0; k < direction.size(); ++k)
    if (direction[k] > 1.0 - pure)
      return fmt::format("translation along {}", axis.at(std::size_t(k)));
  return fmt::format("translation along {}", tuple(direction, 1.0));
}

Vector unit(Vector direction)
{
  const double size = norm(direction);
  for (double& value : direction)
    value /= size;
  return direction;
}

/// Where a plane motion leaves the body: t + w/L e_z x (x - x_c) = 0.
std::string centreOfRotation(const RigidBasis& basis, const Vector& c)
{
  const double rate = c[2] / basis.length;
  return tuple({basis.centre[0] - c[1] / rate, basis.centre[1] + c[0] / rate}, basis.length);
}

std::string describeRotation(const RigidBasis& basis, const Vector& c)
{
  if (basis.dim == 3)
    return fmt::format("rotation about the axis {}", tuple(positive(unit(Vector(c.begin() + 3, c.end()))), 1.0));
  return fmt::format("rotation about {}", centreOfRotation(basis, c));
}

} // namespace

Direction RigidBasis::displacement(int mode, const double* point) const
{
  Direction u{};
  if (mode < dim) {
    u[std::size_t(mode)] = 1.0;
    return u;
  }
  Direction x{};
  for (int k = 0; k < dim; ++k)
    x[std::size_t(k)] = (point[k] - centre[std::size_t(k)]) / length;
  const int axis = dim == 2 ? 2 : mode - 3;
  const auto next = std::size_t((axis + 1) % 3), afterNext = std::size_t((axis + 2) % 3);
  u[next] = -x[afterNext];
  u[afterNext] = x[next];
  return u;
}

RigidBasis rigidBasis(const Mesh& mesh)
{
  RigidBasis basis{mesh.dim, {}, diameter(mesh)};
  for (int k = 0; k < mesh.dim && mesh.numPoints() > 0; ++k) { // a rank may have nothing of a body
    double low = mesh.point(0)[k], high = low;
    for (int p = 1; p < mesh.numPoints(); ++p) {
      low = std::min(low, mesh.point(p)[k]);
      high = std::max(high, mesh.point(p)[k]);
    }
    basis.centre[std::size_t(k)] = 0.5 * (low + high);
  }
  return basis;
}

DenseMatrix rigidModes(const RigidBasis& basis, const NodeMap& nodes, const Frames& frames)
{
  DenseMatrix modes(nodes.numNodes() * nodes.dim, basis.size());
  for (int m = 0; m < basis.size(); ++m) {
    Vector mode(std::size_t(modes.rows()));
    for (int node = 0; node < nodes.numNodes(); ++node) {
      const Direction u = basis.displacement(m, nodes.point(node).data());
      std::copy_n(u.begin(), nodes.dim, mode.begin() + std::ptrdiff_t(node) * nodes.dim);
    }
    const NodalField local = frames.toLocal(mode);
    std::copy(local.begin(), local.end(), modes.col(m));
  }
  return modes;
}

DenseMatrix supportRows(const RigidBasis& basis, const NodeMap& nodes, const ConstraintSet& constraints)
{
  int rows = 0;
  for (const auto& entry : constraints.nodes())
    rows += entry.second.count;
  DenseMatrix matrix(rows, basis.size());
  int row = 0;
  for (const auto& [node, fixed] : constraints.nodes())
    for (int k = 0; k < fixed.count; ++k, ++row)
      for (int m = 0; m < basis.size(); ++m)
        matrix(row, m) = dotProduct(fixed.direction[std::size_t(k)], basis.displacement(m, nodes.point(node).data()));
  return matrix;
}

std::string describeMotion(const RigidBasis& basis, const Vector& motion)
{
  constexpr std::array<char, 3> axis{'x', 'y', 'z'};
  const Vector turning(motion.begin() + basis.dim, motion.end());
  if (largestEntry(turning) > pure * norm(motion))
    return basis.dim == 3 ? fmt::format("turning about the axis {}", tuple(unit(turning), 1.0))
                          : fmt::format("turning {} about {}", turning[0] > 0.0 ? "counterclockwise" : "clockwise",
                                        centreOfRotation(basis, motion));
  const Vector direction = unit(Vector(motion.begin(), motion.begin() + basis.dim));
  for (std::size_t k = 0; k < direction.size(); ++k)
    if (std::abs(direction[k]) > 1.0 - pure)
      return fmt::format("along {}{}", direction[k] > 0.0 ? '+' : '-', axis.at(k));
  return "along " + tuple(direction, 1.0);
}

std::vector<std::string> describeMotions(const RigidBasis& basis, const DenseMatrix& motions)
{
  const auto translations = translationsAmong(basis, motions);
  std::vector<std::string> names;
  std::vector<Vector> named;
  for (int m = 0; m < basis.dim; ++m) {
    Vector unit(std::size_t(basis.size()), 0.0);
    unit[std::size_t(m)] = 1.0;
    if (norm(remainder(unit, translations)) < pure)
      names.push_back(describeTranslation(basis, *takeNew(unit, named)));
  }
  for (const auto& translation : translations)
    if (const auto rest = takeNew(translation, named))
      names.push_back(describeTranslation(basis, *rest));
  for (const auto& motion : columns(motions))
    if (const auto rest = takeNew(motion, named))
      names.push_back(describeRotation(basis, *rest));
  return names;
}

} // namespace ndframe
