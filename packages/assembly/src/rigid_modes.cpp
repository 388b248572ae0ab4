#include "ndframe/assembly/rigid_modes.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ndframe
{
namespace
{

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

std::string describeRotation(const RigidBasis& basis, const Vector& c)
{
  if (basis.dim == 3) {
    const double size = std::sqrt(c[3] * c[3] + c[4] * c[4] + c[5] * c[5]);
    return fmt::format("rotation about the axis ({:.3g}, {:.3g}, {:.3g})", c[3] / size + 0.0, c[4] / size + 0.0,
                       c[5] / size + 0.0);
  }
  // t + w/L e_z x (x - x_c) = 0 at the centre of rotation.
  const double rate = c[2] / basis.length;
  return fmt::format("rotation about ({:.3g}, {:.3g})", basis.centre[0] - c[1] / rate + 0.0,
                     basis.centre[1] + c[0] / rate + 0.0);
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
  for (int k = 0; k < mesh.dim; ++k) {
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
      const Direction u = basis.displacement(m, nodes.point(node));
      std::copy_n(u.begin(), nodes.dim, mode.begin() + node * nodes.dim);
    }
    const Vector local = frames.toLocal(mode);
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
        matrix(row, m) = dotProduct(fixed.direction[std::size_t(k)], basis.displacement(m, nodes.point(node)));
  return matrix;
}

std::vector<std::string> describeMotions(const RigidBasis& basis, const DenseMatrix& coefficients)
{
  constexpr double pure = 1e-6;
  constexpr const char* axis[3] = {"x", "y", "z"};
  std::vector<Vector> span;
  for (int j = 0; j < coefficients.cols(); ++j)
    span.push_back(coefficients.column(j));
  std::vector<std::string> names;
  std::vector<Vector> named;
  for (int m = 0; m < basis.dim; ++m) {
    Vector unit(std::size_t(basis.size()), 0.0);
    unit[std::size_t(m)] = 1.0;
    if (norm(remainder(unit, span)) < pure) {
      names.push_back(fmt::format("translation along {}", axis[m]));
      named.push_back(unit);
    }
  }
  for (const auto& motion : span) {
    Vector rest = remainder(motion, named);
    const double size = norm(rest);
    if (size < pure)
      continue;
    for (double& value : rest)
      value /= size;
    double turning = 0.0;
    for (std::size_t m = std::size_t(basis.dim); m < rest.size(); ++m)
      turning = std::max(turning, std::abs(rest[m]));
    names.push_back(turning > pure ? describeRotation(basis, rest)
                                   : fmt::format("translation along ({:.3g}, {:.3g}, {:.3g})", rest[0], rest[1],
                                                 basis.dim == 3 ? rest[2] : 0.0));
    named.push_back(rest);
  }
  return names;
}

} // namespace ndframe
