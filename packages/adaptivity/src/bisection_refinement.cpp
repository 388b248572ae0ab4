#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>

#include "ndframe/mesh/bisection.hpp"
#include "ndframe/mesh/tetrahedron_bisection.hpp"
#include "refinements.hpp"

namespace ndframe
{
namespace
{

/// Edges stay longer than this share of a cell's largest coordinate: their middle is then rounded by a thousandth of
/// them.
constexpr double finest = 0x1p-42;

/// How often a cell can be halved until its edges are the finest.
int halvingsLeft(const Mesh& mesh, int cell)
{
  double square = 0.0, largest = 0.0;
  for (int a = 0; a <= mesh.dim; ++a) {
    const double* x = mesh.point(mesh.cell(cell)[a]);
    largest = std::accumulate(x, x + mesh.dim, largest, [](double m, double k) { return std::max(m, std::abs(k)); });
    for (int b = 0; b < a; ++b) {
      const double* y = mesh.point(mesh.cell(cell)[b]);
      square = std::max(square, std::inner_product(x, x + mesh.dim, y, 0.0, std::plus<>(),
                                                   [](double s, double t) { return (s - t) * (s - t); }));
    }
  }
  return int(std::clamp(mesh.dim * std::log2(std::sqrt(square) / (finest * largest)), 0.0, 1e6));
}

/// Halvings that the cells of a mesh still need. Where the parts of a cell differ, those get one at a time.
std::vector<int> halvingsOf(const Mesh& mesh, const std::vector<int>& ancestors, const std::vector<CellSize>& sizes)
{
  std::vector<int> halvings;
  for (int c = 0; c < mesh.numCells(); ++c) {
    const CellSize& size = sizes[std::size_t(ancestors[std::size_t(c)])];
    const int wanted = halvingsTo(size, mesh, c);
    const int wantedNow = size.isEven() ? wanted : std::min(1, wanted);
    halvings.push_back(wantedNow > 0 ? std::min(wantedNow, halvingsLeft(mesh, c)) : 0);
  }
  return halvings;
}

/// Where a point is on Morton's curve through coordinates (x, x + y, 2x + y + z) in 2^21 steps of the mesh. All edges
/// of cells that come from halving Kuhn's tetrahedra in cubes go up, or not down, in all three, or down in all three.
std::vector<std::uint64_t> placesOnCurve(const Mesh& mesh)
{
  std::vector<std::array<double, 3>> points;
  std::array<double, 3> lowest{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  double extent = 0.0;
  for (int p = 0; p < mesh.numPoints(); ++p) {
    const double* x = mesh.point(p);
    points.push_back({x[0], x[0] + x[1], 2.0 * x[0] + x[1] + x[2]});
    for (std::size_t k = 0; k < 3; ++k)
      lowest[k] = std::min(lowest[k], points.back()[k]);
  }
  for (const auto& point : points)
    for (std::size_t k = 0; k < 3; ++k)
      extent = std::max(extent, point[k] - lowest[k]);
  std::vector<std::uint64_t> places;
  for (const auto& point : points) {
    std::uint64_t place = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto steps = std::uint64_t(std::llround((point[k] - lowest[k]) / extent * 0x1FFFFF));
      for (std::size_t bit = 0; bit < 21; ++bit)
        place |= (steps >> bit & 1) << (3 * bit + k);
    }
    places.push_back(place);
  }
  return places;
}

/// Numbers the points along a curve: neighbours are near each other in memory, and cells that differ by place and size
/// alone have their vertices in the same order, which makes them one class (CellClasses).
void numberAlongCurve(Mesh& mesh)
{
  const std::vector<std::uint64_t> places = placesOnCurve(mesh);
  std::vector<int> order(places.size()), numbers(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return places[std::size_t(a)] < places[std::size_t(b)]; });
  const std::vector<double> points = mesh.points;
  for (std::size_t p = 0; p < order.size(); ++p) {
    numbers[std::size_t(order[p])] = int(p);
    std::copy_n(points.begin() + 3 * std::ptrdiff_t(order[p]), 3, mesh.points.begin() + 3 * std::ptrdiff_t(p));
  }
  for (int& vertex : mesh.cells)
    vertex = numbers[std::size_t(vertex)];
}

/// Halving: Bisection or TetrahedronBisection. The first meshes are as given; points of later ones have numbers of
/// their own in space.
template <class Halving>
class BisectedMeshes final : public RefinedMeshes
{
public:
  BisectedMeshes(std::vector<Mesh> meshes, const std::vector<FacetTwin>& twins)
      : bisection_(std::move(meshes), twins), ancestors_(ownAncestors(bisection_.meshes()))
  {}

  const std::vector<Mesh>& meshes() const override { return numbered_.empty() ? bisection_.meshes() : numbered_; }
  const std::vector<std::vector<int>>& ancestors() const override { return ancestors_; }

  std::unique_ptr<RefinedMeshes> refined(const SizeField& sizes) const override
  {
    auto next = std::make_unique<BisectedMeshes>(*this);
    next->ancestors_ = ownAncestors(meshes());
    while (next->halve(sizes)) {
    }
    if (meshes().front().dim == 3) {
      next->numbered_ = next->bisection_.meshes();
      std::for_each(next->numbered_.begin(), next->numbered_.end(), numberAlongCurve);
    }
    return next;
  }

  bool areNested() const override { return meshes().front().dim == 3; } // inner edges of triangles are flipped
  double slack() const override { return meshes().front().dim == 2 ? 0.01 : 0.04; }

private:
  /// False when nothing is left to be halved.
  bool halve(const SizeField& sizes)
  {
    std::vector<std::vector<int>> halvings;
    bool wanted = false;
    for (std::size_t b = 0; b < sizes.size(); ++b) {
      halvings.push_back(halvingsOf(bisection_.meshes()[b], ancestors_[b], sizes[b]));
      wanted = wanted || std::any_of(halvings[b].begin(), halvings[b].end(), [](int n) { return n > 0; });
    }
    if (!wanted)
      return false;
    bisection_.refine(halvings);
    for (std::size_t b = 0; b < sizes.size(); ++b) {
      std::vector<int> inherited;
      for (const int parent : bisection_.parents()[b])
        inherited.push_back(ancestors_[b][std::size_t(parent)]);
      ancestors_[b] = std::move(inherited);
    }
    return true;
  }

  Halving bisection_;
  std::vector<Mesh> numbered_; ///< its meshes; empty: as they are
  std::vector<std::vector<int>> ancestors_;
};

class BisectionRefinement final : public Refinement
{
public:
  std::unique_ptr<RefinedMeshes> begin(FirstMeshes first, const Comm&) const override
  {
    return bisectedMeshes(std::move(first.meshes), first.twins);
  }
};

} // namespace

std::vector<std::vector<int>> ownAncestors(const std::vector<Mesh>& meshes)
{
  std::vector<std::vector<int>> ancestors;
  for (const Mesh& mesh : meshes) {
    ancestors.emplace_back(std::size_t(mesh.numCells()));
    std::iota(ancestors.back().begin(), ancestors.back().end(), 0);
  }
  return ancestors;
}

bool RefinedMeshes::areUnchanged() const
{
  return ancestors() == ownAncestors(meshes());
}

std::unique_ptr<RefinedMeshes> bisectedMeshes(std::vector<Mesh> meshes, const std::vector<FacetTwin>& twins)
{
  if (meshes.front().dim == 3)
    return std::make_unique<BisectedMeshes<TetrahedronBisection>>(std::move(meshes), twins);
  return std::make_unique<BisectedMeshes<Bisection>>(std::move(meshes), twins);
}

void registerBisection(Registry<Refinement>& registry)
{
  registry.add("Bisection",
               "Triangles or tetrahedra are bisected repeatedly, all bodies as one mesh, so that matching sides still "
               "match. Works from any mesh; curved sides stay the polygons of the first mesh.",
               {}, [](const Params&) { return std::make_unique<BisectionRefinement>(); });
}

} // namespace ndframe
