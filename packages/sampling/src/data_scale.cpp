#include "data_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ndframe
{
namespace
{

constexpr int mostSearched = 4000; ///< pieces looked at for the largest value

/// The largest absolute value of functions at points, many at a time; values that are not finite do not count.
class LargestValue
{
public:
  explicit LargestValue(const std::vector<SampledFunction>& functions) : functions_(functions) {}

  void add(const Region::Point& x)
  {
    points_.insert(points_.end(), x.begin(), x.end());
    if (points_.size() == 3 * values_.size())
      evaluate();
  }
  double found()
  {
    evaluate();
    return found_;
  }

private:
  void evaluate()
  {
    const std::size_t count = points_.size() / 3;
    for (const auto& function : functions_) {
      function.tree->values(points_.data(), int(count), values_.data());
      for (std::size_t i = 0; i < count; ++i)
        if (std::isfinite(values_[i]))
          found_ = std::max(found_, std::abs(values_[i]));
    }
    points_.clear();
  }

  const std::vector<SampledFunction>& functions_;
  std::vector<double> points_;
  std::array<double, 64> values_{};
  double found_ = 0.0;
};

/// The box around points, by its corners.
class Surroundings
{
public:
  void add(const double* x, int space)
  {
    for (std::size_t k = 0; k < std::size_t(space); ++k) {
      low_[k] = std::min(low_[k], x[k]);
      high_[k] = std::max(high_[k], x[k]);
    }
  }
  std::vector<Region::Point> corners(int space) const
  {
    std::vector<Region::Point> all(std::size_t(1) << space);
    for (std::size_t corner = 0; corner < all.size(); ++corner)
      for (std::size_t k = 0; k < std::size_t(space); ++k)
        all[corner][k] = (corner >> k) % 2 == 0 ? low_[k] : high_[k];
    return all;
  }
  bool areEmpty() const { return !(low_[0] <= high_[0]); }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Region::Point low_{infinity, infinity, infinity}, high_{-infinity, -infinity, -infinity};
};

/// All of a few simplices, few of many.
bool isLookedAtFirst(int number)
{
  return number < 256 || number % 64 == 0;
}

using Candidates = std::vector<std::pair<SimplexGeometry, Samples::Piece>>;

/// Branch and bound: the piece with the largest bound is split until no bound is above twice the largest value found.
double searched(const std::vector<SampledFunction>& functions, const DataEnclosures& data, Candidates candidates,
                double found)
{
  using Entry = std::pair<double, std::size_t>;
  std::vector<Entry> open;
  LargestValue largest(functions);
  for (std::size_t i = 0; i < candidates.size(); ++i)
    open.emplace_back(data.largestBetween(candidates[i].first.corners(candidates[i].second)), i);
  std::make_heap(open.begin(), open.end());
  for (int step = 0; step < mostSearched && !open.empty() && open.front().first > 2.0 * found; ++step) {
    std::pop_heap(open.begin(), open.end());
    const auto [simplex, piece] = candidates[open.back().second];
    open.pop_back();
    for (const auto& half : simplex.bisect(piece)) {
      Region::Point middle{};
      for (const auto& corner : simplex.corners(half))
        for (std::size_t k = 0; k < 3; ++k)
          middle[k] += corner[k] / (simplex.dim() + 1);
      largest.add(middle);
      found = std::max(found, largest.found());
      candidates.emplace_back(simplex, half);
      open.emplace_back(data.largestBetween(simplex.corners(half)), candidates.size() - 1);
      std::push_heap(open.begin(), open.end());
    }
  }
  return found;
}

} // namespace

double findScale(const std::vector<SampledFunction>& functions, DataEnclosures& data, int space,
                 const std::function<void(const DataSampler::Visit&)>& visit)
{
  LargestValue largest(functions);
  Surroundings box;
  int number = 0;
  visit([&](int dim, const DataSampler::Vertices& vertices) {
    if (isLookedAtFirst(number++))
      largest.add(SimplexGeometry(dim, space, vertices).centroid());
    for (int v = 0; v <= dim; ++v)
      box.add(vertices[std::size_t(v)], space);
  });
  if (box.areEmpty())
    return 0.0;
  const double most = data.largestBetween(box.corners(space));
  if (most <= 2.0 * largest.found())
    return largest.found();
  visit([&](int dim, const DataSampler::Vertices& vertices) {
    largest.add(SimplexGeometry(dim, space, vertices).centroid());
  });
  const double found = largest.found();
  Candidates candidates;
  if (!data.arePolynomials() && most > 2.0 * found)
    visit([&](int dim, const DataSampler::Vertices& vertices) {
      const SimplexGeometry simplex(dim, space, vertices);
      if (data.largestAround(simplex) > 2.0 * found)
        candidates.emplace_back(simplex, simplex.whole());
    });
  return searched(functions, data, std::move(candidates), found);
}

} // namespace ndframe
