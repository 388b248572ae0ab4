#include <algorithm>
#include <cmath>

#include "batched_fan.hpp"
#include "batched_kernels.hpp"
#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/equilibrium/row_reduction.hpp"

namespace ndframe
{
namespace
{

/// Moments along a direction of the traction with wrench w and modes s on a spoke (StarTables), one per mode.
void tractionAlong(const FanEnd& end, double arm, int degree, int direction, const double* x, double* moments)
{
  const auto [dx, dy] = end.spoke;
  const auto& e = end.direction[std::size_t(direction)];
  const double *w = x, *s = x + 3, along = dx * e[0] + dy * e[1], across = dx * e[1] - dy * e[0];
  const double turn = (w[2] - 0.5 * (dx * w[1] - dy * w[0])) / (arm * (dx * dx + dy * dy));
  moments[0] = w[0] * e[0] + w[1] * e[1];
  moments[1] = s[0] * along + turn * across;
  for (int k = 2; k <= degree; ++k)
    moments[k] = s[2 * k - 3] * along + s[2 * k - 2] * across;
}

/// The conditions  T . e = sign * given - T(offset) . e  on one end, in unknowns scaled to forces.
class EndConditions
{
public:
  EndConditions(const FanProblem& fan, const FanEnd& end, const Vector& scale, DenseMatrix& rows, int firstRow)
      : fan_(fan), end_(end), scale_(scale), rows_(rows), row_(firstRow)
  {}

  /// firstMode: column of the end's own modes.
  void add(int firstMode, double sign, const DenseMatrix* offset)
  {
    const int modes = fan_.degree + 1, n = cellUnknowns(fan_.degree), fields = fan_.gradient.cols();
    for (int direction = 0; direction < end_.freeDirections; ++direction, row_ += modes) {
      for (int j = 0; j < 3 + spokeModes(fan_.degree); ++j) {
        const int column = j < 3 ? j : firstMode + j - 3;
        evaluate(direction, j, scale_[std::size_t(column)], column);
      }
      for (int k = 0; k < fields; ++k) {
        for (int i = 0; offset != nullptr && i < 3; ++i)
          evaluate(direction, i, -(*offset)(i, k), n + k);
        const double* given = end_.given.data() + std::ptrdiff_t(2) * k * modes;
        const auto& e = end_.direction[std::size_t(direction)];
        for (int mode = 0; mode < modes; ++mode)
          rows_(row_ + mode, n + k) +=
              sign * (given[std::ptrdiff_t(2) * mode] * e[0] + given[std::ptrdiff_t(2) * mode + 1] * e[1]);
      }
    }
  }

private:
  /// Adds the traction of unknown j set to `value` to a column.
  void evaluate(int direction, int j, double value, int column)
  {
    double x[maxEndUnknowns] = {}, moments[maxModes];
    x[j] = value;
    tractionAlong(end_, fan_.arm, fan_.degree, direction, x, moments);
    for (int mode = 0; mode <= fan_.degree; ++mode)
      rows_(row_ + mode, column) += moments[mode];
  }

  static constexpr int maxEndUnknowns = 3 + spokeModes(3), maxModes = 4;
  const FanProblem& fan_;
  const FanEnd& end_;
  const Vector& scale_;
  DenseMatrix& rows_;
  int row_;
};

/// Factors that make all unknowns forces.
Vector unknownScales(const FanProblem& fan)
{
  const auto length = [](const FanEnd& end) { return std::hypot(end.spoke[0], end.spoke[1]); };
  const auto modes = std::size_t(spokeModes(fan.degree));
  Vector scale{1.0, 1.0, length(fan.first)};
  scale.insert(scale.end(), modes, 1.0 / length(fan.first));
  scale.insert(scale.end(), modes, 1.0 / length(fan.last));
  return scale;
}

/// x = particular + kernel z satisfies the conditions.
struct AllUnknowns
{
  DenseMatrix particular, kernel;
};

AllUnknowns unknownsOf(const RowReduction& reduced, int n, int fields)
{
  std::vector<int> rowOf(std::size_t(n), -1), free;
  for (std::size_t row = 0; row < reduced.pivot.size(); ++row)
    if (reduced.pivot[row] >= 0)
      rowOf[std::size_t(reduced.pivot[row])] = int(row);
  for (int j = 0; j < n; ++j)
    if (rowOf[std::size_t(j)] < 0)
      free.push_back(j);
  AllUnknowns all{DenseMatrix(n, fields), DenseMatrix(n, int(free.size()))};
  for (int z = 0; z < int(free.size()); ++z)
    all.kernel(free[std::size_t(z)], z) = 1.0;
  for (int j = 0; j < n; ++j) {
    const int row = rowOf[std::size_t(j)];
    if (row < 0)
      continue;
    for (int k = 0; k < fields; ++k)
      all.particular(j, k) = reduced.matrix(row, n + k);
    for (int z = 0; z < int(free.size()); ++z)
      all.kernel(j, z) = -reduced.matrix(row, free[std::size_t(z)]);
  }
  return all;
}

/// Moves x along the kernel to the least of  x^T A x / 2 + g^T x.
void minimise(const DenseMatrix& A, const DenseMatrix& gradient, AllUnknowns& all)
{
  if (all.kernel.cols() == 0)
    return;
  const DenseCholesky factor(multiplyTransposed(all.kernel, multiply(A, all.kernel)), 0.0);
  DenseMatrix slope = multiply(A, all.particular);
  for (int k = 0; k < slope.cols(); ++k) {
    for (int i = 0; i < slope.rows(); ++i)
      slope(i, k) += gradient(i, k);
    const Vector z = factor.solve(multiplyTransposed(all.kernel, DenseMatrix(slope.column(k))).column(0));
    const Vector step = multiply(all.kernel, z);
    for (int i = 0; i < slope.rows(); ++i)
      all.particular(i, k) -= step[std::size_t(i)];
  }
}

} // namespace

FanSolution solveFan(const FanProblem& fan)
{
  const int n = cellUnknowns(fan.degree), fields = fan.gradient.cols(), modes = fan.degree + 1;
  const Vector scale = unknownScales(fan);
  DenseMatrix rows((fan.first.freeDirections + fan.last.freeDirections) * modes, n + fields);
  EndConditions(fan, fan.first, scale, rows, 0).add(3, -1.0, nullptr);
  EndConditions(fan, fan.last, scale, rows, fan.first.freeDirections * modes)
      .add(3 + spokeModes(fan.degree), 1.0, &fan.offset);
  const RowReduction reduced = reduceRows(std::move(rows), n, rigidTolerance);

  FanSolution solution{DenseMatrix(n, fields), Vector(std::size_t(fields), 0.0)};
  for (int row = 0; row < reduced.matrix.rows(); ++row)
    for (int k = 0; k < fields && reduced.pivot[std::size_t(row)] < 0; ++k)
      solution.defect[std::size_t(k)] = std::max(solution.defect[std::size_t(k)], std::abs(reduced.matrix(row, n + k)));
  AllUnknowns all = unknownsOf(reduced, n, fields);
  DenseMatrix A(n, n), gradient(n, fields);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      A(i, j) = scale[std::size_t(i)] * fan.energy(i, j) * scale[std::size_t(j)];
  for (int k = 0; k < fields; ++k)
    for (int i = 0; i < n; ++i)
      gradient(i, k) = scale[std::size_t(i)] * fan.gradient(i, k);
  minimise(A, gradient, all);
  for (int k = 0; k < fields; ++k)
    for (int i = 0; i < n; ++i)
      solution.x(i, k) = scale[std::size_t(i)] * all.particular(i, k);
  return solution;
}

} // namespace ndframe
