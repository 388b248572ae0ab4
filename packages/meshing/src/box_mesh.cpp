#include "box_mesh.hpp"

#include <cmath>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

/// A simplex by the corners of its brick. Bit d of a corner is set at the larger coordinate of direction d; the centre
/// of a crossed brick comes after the corners. In two dimensions the last entry is not used.
using Simplex = std::array<int, 4>;
using Cut = std::vector<Simplex>;

/// How bricks with an even and with an odd sum of indices are cut; neighbours cut their common face alike.
struct Cuts
{
  Cut even;
  Cut odd;
};

const Cut& cutOf(const Cuts& cuts, int indexSum)
{
  return indexSum % 2 == 0 ? cuts.even : cuts.odd;
}

Cuts cutsOf(int dim, BoxPattern pattern)
{
  const Cut rising{{0, 1, 3}, {0, 3, 2}};
  const Cut falling{{0, 1, 2}, {1, 3, 2}};
  const Cut crossed{{0, 1, 4}, {1, 3, 4}, {3, 2, 4}, {2, 0, 4}};
  // Kuhn: one tetrahedron per order of the directions in which a path climbs from corner 0 to corner 7.
  const Cut kuhn{{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
  // Four corners are cut off, leaving the tetrahedron of the other four.
  const Cut cornersEven{{1, 0, 5, 3}, {2, 0, 3, 6}, {4, 0, 6, 5}, {7, 3, 5, 6}, {0, 3, 6, 5}};
  const Cut cornersOdd{{0, 1, 2, 4}, {3, 1, 7, 2}, {5, 1, 4, 7}, {6, 2, 7, 4}, {1, 2, 4, 7}};
  switch (pattern) {
  case BoxPattern::Right:
    return dim == 2 ? Cuts{rising, rising} : Cuts{kuhn, kuhn};
  case BoxPattern::Alternating:
    return dim == 2 ? Cuts{rising, falling} : Cuts{cornersEven, cornersOdd};
  case BoxPattern::Crossed:
    NDFRAME_ASSERT(dim == 2, "the crossed pattern is two-dimensional");
    return {crossed, crossed};
  }
  throw InternalError("unknown box pattern");
}

/// Indices of the bricks; directions beyond the dimension have one layer.
class Bricks
{
public:
  explicit Bricks(const BoxGrid& grid) : dim_(int(grid.lines.size()))
  {
    for (int d = 0; d < dim_; ++d)
      count_[d] = int(grid.lines[d].size()) - 1;
  }

  int dim() const { return dim_; }
  const std::array<int, 3>& counts() const { return count_; }
  int total() const { return count_[0] * count_[1] * count_[2]; }
  int number(const std::array<int, 3>& i) const { return i[0] + count_[0] * (i[1] + count_[1] * i[2]); }
  int corners() const { return 1 << dim_; }

  int point(const std::array<int, 3>& i, int corner) const
  {
    int number = 0;
    for (int d = dim_ - 1; d >= 0; --d)
      number = number * (count_[d] + 1) + i[d] + ((corner >> d) & 1);
    return number;
  }

  /// Calls visit(indices) for the bricks in [low, high), x fastest.
  template <class Visit>
  static void forEach(const std::array<int, 3>& low, const std::array<int, 3>& high, const Visit& visit)
  {
    std::array<int, 3> i{};
    for (i[2] = low[2]; i[2] < high[2]; ++i[2])
      for (i[1] = low[1]; i[1] < high[1]; ++i[1])
        for (i[0] = low[0]; i[0] < high[0]; ++i[0])
          visit(i);
  }

private:
  int dim_;
  std::array<int, 3> count_{1, 1, 1};
};

void addPoints(const BoxGrid& grid, const Bricks& bricks, Mesh& mesh)
{
  std::array<int, 3> high = bricks.counts();
  for (int d = 0; d < mesh.dim; ++d)
    ++high[d];
  Bricks::forEach({0, 0, 0}, high, [&](const std::array<int, 3>& i) {
    for (int d = 0; d < mesh.dim; ++d)
      mesh.points.push_back(grid.lines[d][i[d]]);
  });
  if (grid.pattern == BoxPattern::Crossed)
    Bricks::forEach({0, 0, 0}, bricks.counts(), [&](const std::array<int, 3>& i) {
      for (int d = 0; d < mesh.dim; ++d)
        mesh.points.push_back((grid.lines[d][i[d]] + grid.lines[d][i[d] + 1]) / 2);
    });
}

void addCells(const Bricks& bricks, const Cuts& cuts, Mesh& mesh)
{
  int firstCentre = 1;
  for (int d = 0; d < mesh.dim; ++d)
    firstCentre *= bricks.counts()[d] + 1;
  mesh.cells.reserve(std::size_t(bricks.total()) * cuts.even.size() * std::size_t(mesh.dim + 1));
  Bricks::forEach({0, 0, 0}, bricks.counts(), [&](const std::array<int, 3>& i) {
    const int centre = firstCentre + bricks.number(i);
    for (const Simplex& simplex : cutOf(cuts, i[0] + i[1] + i[2]))
      for (int k = 0; k <= mesh.dim; ++k)
        mesh.cells.push_back(simplex[k] < bricks.corners() ? bricks.point(i, simplex[k]) : centre);
  });
}

/// The facets of a cut brick on one of its faces: cell of the cut and local number.
std::vector<Facet> facetsOnFace(const Cut& cut, int dim, int normal, bool upper)
{
  const auto onFace = [&](int corner) { return corner < (1 << dim) && ((corner >> normal) & 1) == int(upper); };
  std::vector<Facet> facets;
  for (int c = 0; c < int(cut.size()); ++c)
    for (int local = 0; local <= dim; ++local) {
      bool all = true;
      for (int k = 0; k <= dim; ++k)
        all = all && (k == local || onFace(cut[c][k]));
      if (all)
        facets.push_back({c, local});
    }
  return facets;
}

Side sideOf(const BoxPart& part, const Bricks& bricks, const Cuts& cuts)
{
  const std::array<std::vector<Facet>, 2> faces{facetsOnFace(cuts.even, bricks.dim(), part.normal, part.upper),
                                                facetsOnFace(cuts.odd, bricks.dim(), part.normal, part.upper)};
  std::array<int, 3> low{};
  std::array<int, 3> high = bricks.counts();
  for (int d = 0; d < bricks.dim(); ++d)
    if (d != part.normal) {
      low[d] = part.first[std::size_t(d)];
      high[d] = part.last[std::size_t(d)];
    }
  low[part.normal] = part.upper ? high[part.normal] - 1 : 0;
  high[part.normal] = low[part.normal] + 1;
  Side side{part.name, {}};
  Bricks::forEach(low, high, [&](const std::array<int, 3>& i) {
    const int firstCell = bricks.number(i) * int(cuts.even.size());
    for (const Facet& facet : faces[(i[0] + i[1] + i[2]) % 2])
      side.facets.push_back({firstCell + facet.cell, facet.local});
  });
  return side;
}

void addGroups(const BoxGrid& grid, const Bricks& bricks, int cellsPerBrick, Mesh& mesh)
{
  std::vector<std::vector<std::string>> ofBrick(grid.blocks.empty() ? 0 : std::size_t(bricks.total()));
  for (const BoxBlock& block : grid.blocks)
    Bricks::forEach(block.first, block.last,
                    [&](const std::array<int, 3>& i) { ofBrick[std::size_t(bricks.number(i))].push_back(block.name); });
  for (const auto& names : ofBrick)
    mesh.groups.kind.insert(mesh.groups.kind.end(), std::size_t(cellsPerBrick), mesh.groups.findOrAdd(names));
}

void rotate(Mesh& mesh, double degrees)
{
  const double pi = std::acos(-1.0);
  const double c = std::cos(degrees * pi / 180);
  const double s = std::sin(degrees * pi / 180);
  for (int p = 0; p < mesh.numPoints(); ++p) {
    double* x = mesh.points.data() + std::size_t(p) * std::size_t(mesh.dim);
    const double turned = c * x[0] - s * x[1];
    x[1] = s * x[0] + c * x[1];
    x[0] = turned;
  }
}

} // namespace

int simplicesPerBrick(int dim, BoxPattern pattern)
{
  return int(cutsOf(dim, pattern).even.size());
}

Mesh boxMesh(const BoxGrid& grid)
{
  const Bricks bricks(grid);
  const Cuts cuts = cutsOf(bricks.dim(), grid.pattern);
  Mesh mesh;
  mesh.dim = bricks.dim();
  addPoints(grid, bricks, mesh);
  addCells(bricks, cuts, mesh);
  addGroups(grid, bricks, int(cuts.even.size()), mesh);
  for (const BoxPart& part : grid.parts)
    mesh.sides.push_back(sideOf(part, bricks, cuts));
  if (grid.rotation != 0.0)
    rotate(mesh, grid.rotation);
  return mesh;
}

} // namespace ndframe
