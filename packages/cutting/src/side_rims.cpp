#include <algorithm>
#include <tuple>

#include "creases.hpp"
#include "flat_pairs.hpp"
#include "loose_flat_vertices.hpp"
#include "ndframe/cutting/solid_sides.hpp"

namespace ndframe
{
namespace
{

/// A vertex is moved by no more than this part of the shortest edge of its side there.
constexpr double near = 0.5 + 1e-6;
constexpr double alreadyThere = 1e-7;

/// Rims of one side, vertices of another one.
class Rims
{
public:
  Rims(Mesh& mesh, const std::string& side, const Mesh& other, const std::string& otherSide)
      : ours_(mesh, mesh.findSide(side)->facets), theirs_(other, other.findSide(otherSide)->facets), loose_(mesh, side),
        creases_(creases(other))
  {
    for (const auto& [a, b] : creases_) {
      const double *x = other.point(a), *y = other.point(b);
      const Vector3 along{y[0] - x[0], y[1] - x[1], y[2] - x[2]};
      ways_[a].push_back(along);
      ways_[b].push_back({-along[0], -along[1], -along[2]});
    }
  }

  bool align()
  {
    for (const auto& pair : flatPairs(ours_, theirs_))
      for (const int vertex : ours_.vertices(pair[0]))
        for (const int edge : theirs_.edges(pair[1]))
          if (creases_.count(theirs_.ends(edge)) > 0)
            addMoves(vertex, edge);
    std::sort(moves_.begin(), moves_.end());
    bool any = false;
    for (const auto& [onEdge, apart, vertex, to] : moves_)
      if (apart <= alreadyThere * ours_.sizeAt(vertex))
        loose_.keep(vertex);
      else if (loose_.move(vertex, to)) {
        loose_.keep(vertex);
        any = true;
      }
    return any;
  }

private:
  /// To the ends of an edge where the rim turns, and onto the edge.
  void addMoves(int vertex, int edge)
  {
    const Vector3 x = ours_.point(vertex), a = theirs_.point(theirs_.ends(edge)[0]),
                  along = minus(theirs_.point(theirs_.ends(edge)[1]), a);
    const double t = innerProduct(minus(x, a), along) / innerProduct(along, along);
    for (const int end : theirs_.ends(edge))
      if (isCorner(end))
        addMove(false, vertex, theirs_.point(end));
    if (t < 0.0 || t > 1.0)
      return;
    Vector3 to = a;
    for (std::size_t k = 0; k < 3; ++k)
      to[k] += t * along[k];
    addMove(true, vertex, to);
  }

  void addMove(bool onEdge, int vertex, const Vector3& to)
  {
    const double apart = norm(minus(to, ours_.point(vertex)));
    if (apart <= near * ours_.sizeAt(vertex))
      moves_.emplace_back(onEdge, apart, vertex, to);
  }

  /// Whether the creases at a vertex are not two that go straight on.
  bool isCorner(int vertex) const
  {
    const auto found = ways_.find(vertex);
    if (found == ways_.end())
      return false;
    const auto& ways = found->second;
    return ways.size() != 2 || innerProduct(ways[0], ways[1]) > -(1.0 - 1e-9) * norm(ways[0]) * norm(ways[1]);
  }

  SideTopology ours_, theirs_;
  LooseFlatVertices loose_;
  std::set<std::array<int, 2>> creases_;
  std::map<int, std::vector<Vector3>> ways_;                  ///< of the creases at a vertex
  std::vector<std::tuple<bool, double, int, Vector3>> moves_; ///< corners first, near ones first
};

} // namespace

std::array<bool, 2> moveToRims(Mesh& first, const std::string& firstSide, Mesh& second, const std::string& secondSide)
{
  const bool firstMoved = Rims(first, firstSide, second, secondSide).align();
  return {firstMoved, Rims(second, secondSide, first, firstSide).align()};
}

} // namespace ndframe
