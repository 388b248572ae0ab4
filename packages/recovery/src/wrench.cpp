#include "wrench.hpp"

#include <algorithm>

namespace ndframe
{

Wrench movedWrench(const Wrench& wrench, const Direction& from, double fromLength, const Direction& to, double toLength)
{
  Wrench result = wrench;
  for (std::size_t i = 3; i < 6; ++i)
    result[i] *= fromLength / toLength;
  addCross({from[0] - to[0], from[1] - to[1], from[2] - to[2]}, wrench.data(), 1.0 / toLength, &result[3]);
  return result;
}

DenseMatrix movedWrenches(const DenseMatrix& wrenches, const Direction& from, double fromLength, const Direction& to,
                          double toLength)
{
  DenseMatrix result(wrenches.rows(), wrenches.cols());
  for (int j = 0; j < wrenches.cols(); ++j) {
    Wrench wrench{};
    std::copy_n(wrenches.col(j), wrench.size(), wrench.begin());
    wrench = movedWrench(wrench, from, fromLength, to, toLength);
    std::copy(wrench.begin(), wrench.end(), result.col(j));
  }
  return result;
}

} // namespace ndframe
