#include "ndframe/mesh/refined_numbers.hpp"

#include <algorithm>
#include <limits>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/refine.hpp"

namespace ndframe
{
namespace
{

using Number = RefinedNumbers::Number;
using Vertices = std::array<int, 4>;

constexpr int none = std::numeric_limits<int>::max();

/// n over k; zero where there is no choice.
Number choose(Number n, int k)
{
  if (n < k)
    return 0;
  Number result = 1;
  for (int i = 1; i <= k; ++i)
    result = result * (n - k + i) / i;
  return result;
}

/// How many ways there are to write `sum` as a sum of `parts` positive numbers of which the first is below `first`.
Number withLowerFirst(int parts, Number sum, Number first)
{
  return choose(sum - 1, parts - 1) - choose(sum - first, parts - 1);
}

/// The place of weights among all with their sum, in lexicographic order.
Number lexicographic(const DrawnPlace& place, Number sum)
{
  Number before = 0;
  for (int i = 0; i + 1 < place.count; ++i) {
    const Number weight = place.weights[std::size_t(i)];
    before += withLowerFirst(place.count - i, sum, weight);
    sum -= weight;
  }
  return before;
}

/// How many of those before it have even weights only.
Number evenBefore(const DrawnPlace& place, Number sum)
{
  Number before = 0;
  for (int i = 0; i + 1 < place.count; ++i) {
    const Number weight = place.weights[std::size_t(i)];
    before += withLowerFirst(place.count - i, sum / 2, (weight + 1) / 2);
    if (weight % 2 != 0)
      break;
    sum -= weight;
  }
  return before;
}

} // namespace

std::vector<Vertices> simplicesOf(const Mesh& mesh, int count)
{
  std::vector<Vertices> all;
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    for (unsigned subset = 1; subset < 1U << unsigned(mesh.dim + 1); ++subset) {
      Vertices vertices{none, none, none, none};
      int size = 0;
      for (int v = 0; v <= mesh.dim; ++v)
        if ((subset >> unsigned(v) & 1U) != 0)
          vertices[std::size_t(size++)] = mesh.cell(cell)[v];
      if (size != count)
        continue;
      std::sort(vertices.begin(), vertices.end());
      all.push_back(vertices);
    }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  all.shrink_to_fit();
  return all;
}

int mostVertices(int dim, int halvings)
{
  return halvings == 0 ? 2 : dim + 1;
}

DrawnPlace DrawnPlace::middle(const DrawnPlace& a, const DrawnPlace& b)
{
  DrawnPlace result;
  int i = 0, j = 0;
  while (i < a.count || j < b.count) {
    const int first = i < a.count ? a.vertices[std::size_t(i)] : none;
    const int second = j < b.count ? b.vertices[std::size_t(j)] : none;
    NDFRAME_ASSERT(result.count < 4, "both points lie in one cell");
    const auto next = std::size_t(result.count++);
    result.vertices[next] = std::min(first, second);
    if (first <= second)
      result.weights[next] += a.weights[std::size_t(i++)];
    if (second <= first)
      result.weights[next] += b.weights[std::size_t(j++)];
  }
  return result;
}

RefinedNumbers::RefinedNumbers(const Mesh& drawn, int halvings) : order_(Number(1) << halvings)
{
  listSimplices(drawn, mostVertices(drawn.dim, halvings));
  whole_.cells = drawn.numCells();
  whole_.counts[0] = drawn.numPoints();
  for (std::size_t kind = 1; kind < simplices_.size(); ++kind)
    whole_.counts[kind] = Number(simplices_[kind].size());
  count(drawn.dim, halvings);
}

RefinedNumbers::RefinedNumbers(const Mesh& part, int halvings, Whole whole)
    : order_(Number(1) << halvings), whole_(std::move(whole))
{
  listSimplices(part, mostVertices(part.dim, halvings));
  count(part.dim, halvings);
}

void RefinedNumbers::listSimplices(const Mesh& mesh, int most)
{
  for (int m = 2; m <= most; ++m)
    simplices_[std::size_t(m - 1)] = simplicesOf(mesh, m);
}

void RefinedNumbers::count(int dim, int halvings)
{
  numCells_ = whole_.cells << (dim * halvings);
  for (int m = 1; m <= dim + 1; ++m) {
    const auto kind = std::size_t(m - 1);
    firstPoint_[kind] = numPoints_;
    firstMiddle_[kind] = numMiddles_;
    numPoints_ += whole_.counts[kind] * choose(order_ - 1, m - 1);
    numMiddles_ += whole_.counts[kind] * (choose(2 * order_ - 1, m - 1) - choose(order_ - 1, m - 1));
  }
}

RefinedNumbers::Whole RefinedNumbers::toldTo(const Mesh& part, const std::vector<int>& vertices,
                                             const std::vector<int>& cells) const
{
  Whole told{whole_.cells, whole_.counts, {}, {}};
  for (const int number : cells)
    told.ofCells.push_back(cell(number));
  for (const int vertex : vertices)
    told.numbers[0].push_back(simplex(DrawnPlace::vertex(vertex)));
  for (int m = 2; m <= 4; ++m)
    if (const auto kind = std::size_t(m - 1); !simplices_[kind].empty())
      for (const Vertices& simplexOfPart : simplicesOf(part, m)) {
        DrawnPlace place{{}, {}, m};
        for (std::size_t v = 0; v <= kind; ++v)
          place.vertices[v] = vertices[std::size_t(simplexOfPart[v])];
        told.numbers[kind].push_back(simplex(place));
      }
  return told;
}

void RefinedNumbers::countNodes(const std::vector<int>& order, std::vector<double>& counts) const
{
  for (const int place : order)
    counts[std::size_t(place)] += 1.0;
  for (int m = 2; m <= 4; ++m)
    for (const Vertices& vertices : simplices_[std::size_t(m - 1)]) {
      int first = none;
      for (int v = 0; v < m; ++v)
        first = std::min(first, order[std::size_t(vertices[std::size_t(v)])]);
      counts[std::size_t(first)] += double(choose(2 * order_ - 1, m - 1));
    }
}

Number RefinedNumbers::simplex(const DrawnPlace& place) const
{
  const auto kind = std::size_t(place.count - 1);
  std::size_t number = std::size_t(place.vertices[0]);
  if (kind > 0) {
    Vertices vertices{none, none, none, none};
    std::copy_n(place.vertices.begin(), place.count, vertices.begin());
    const std::vector<Vertices>& all = simplices_[kind];
    const auto found = std::lower_bound(all.begin(), all.end(), vertices);
    NDFRAME_ASSERT(found != all.end() && *found == vertices, "the place lies in a drawn cell");
    number = std::size_t(found - all.begin());
  }
  return whole_.numbers[kind].empty() ? Number(number) : whole_.numbers[kind][number];
}

Number RefinedNumbers::point(const DrawnPlace& place) const
{
  return firstPoint_[std::size_t(place.count - 1)] + simplex(place) * choose(order_ - 1, place.count - 1) +
         lexicographic(place, order_);
}

Number RefinedNumbers::middle(const DrawnPlace& place) const
{
  const Number inSimplex = choose(2 * order_ - 1, place.count - 1) - choose(order_ - 1, place.count - 1);
  return numPoints_ + firstMiddle_[std::size_t(place.count - 1)] + simplex(place) * inSimplex +
         lexicographic(place, 2 * order_) - evenBefore(place, 2 * order_);
}

} // namespace ndframe
