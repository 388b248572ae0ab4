#pragma once

#include <memory>
#include <vector>

namespace ndframe
{

/// Finds the nearest of some points, in a k-d tree: O(log points) each.
class NearestPoint
{
public:
  /// points: dim coordinates each, of one point at least.
  NearestPoint(int dim, std::vector<double> points);
  /// Of a Mesh or a NodeMap: those with these numbers.
  template <class Points>
  NearestPoint(const Points& all, const std::vector<int>& numbers) : NearestPoint(all.dim, coordinates(all, numbers))
  {}

  /// The point that is nearest to one.
  struct Place
  {
    std::size_t index = 0;        ///< which of the points
    double squaredDistance = 0.0; ///< between the two
  };
  Place find(const double* point) const; ///< point: dim coordinates

private:
  template <class Points>
  static std::vector<double> coordinates(const Points& all, const std::vector<int>& numbers)
  {
    std::vector<double> result;
    for (const int number : numbers) {
      const auto x = all.point(number);
      result.insert(result.end(), &x[0], &x[0] + all.dim);
    }
    return result;
  }

  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

} // namespace ndframe
