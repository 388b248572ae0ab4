#include "move_vertices.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "ndframe/mesh/vertex_cells.hpp"

namespace ndframe
{
namespace
{

/// A vertex is moved by no more than this part of its shorter facet.
constexpr double near = 0.05;
/// Moves by less are round-off: the vertices are one already.
constexpr double alreadyThere = 1e-9;
/// A move must leave every cell this part of its area.
constexpr double smallestArea = 0.5;

/// The vertices of one body's side on segments that are one line for both sides.
class LooseVertices
{
public:
  LooseVertices(Mesh& mesh, const std::string& side) : mesh_(mesh), cells_(mesh)
  {
    for (const Side& named : mesh.sides) {
      std::map<int, int> uses;
      for (const Facet facet : named.facets) {
        int ends[3];
        facetVertices(mesh, facet, ends);
        for (const int end : {ends[0], ends[1]})
          ++uses[end];
      }
      for (const auto& [vertex, count] : uses)
        if (count != 2)
          fixed_.insert(vertex);
    }
    polygonVertices(side);
  }

  double shortestFacetAt(int vertex) const { return shortest_.at(vertex); }
  void keep(int vertex) { fixed_.insert(vertex); }

  /// Moves a vertex along its side; false where it must stay.
  bool move(int vertex, const double* to)
  {
    if (fixed_.count(vertex) > 0)
      return false;
    double* x = mesh_.points.data() + std::ptrdiff_t(vertex) * 2;
    const std::array<double, 2> from{x[0], x[1]};
    std::vector<double> areas;
    for (const int* cell = cells_.begin(vertex); cell != cells_.end(vertex); ++cell)
      areas.push_back(cellMeasure(mesh_, *cell));
    std::copy_n(to, 2, x);
    const double* area = areas.data();
    for (const int* cell = cells_.begin(vertex); cell != cells_.end(vertex); ++cell)
      if (cellMeasure(mesh_, *cell) < smallestArea * *area++) {
        std::copy(from.begin(), from.end(), x);
        return false;
      }
    return true;
  }

private:
  /// Vertices where the side turns stay.
  void polygonVertices(const std::string& side)
  {
    std::map<int, std::array<double, 2>> normals;
    for (const Facet facet : mesh_.findSide(side)->facets) {
      int ends[3];
      double n[3];
      const double length = facetNormal(mesh_, facet, n);
      facetVertices(mesh_, facet, ends);
      for (const int end : {ends[0], ends[1]}) {
        const auto [known, isNew] = shortest_.insert({end, length});
        known->second = std::min(known->second, length);
        const auto [normal, first] = normals.insert({end, {n[0], n[1]}});
        if (!first && std::abs(normal->second[0] * n[1] - normal->second[1] * n[0]) > alreadyThere)
          fixed_.insert(end);
      }
    }
  }

  Mesh& mesh_;
  VertexCells cells_;
  std::set<int> fixed_;
  std::map<int, double> shortest_; ///< per vertex of the side, its shorter facet
};

int vertexAt(const Mesh& mesh, Facet facet, double place)
{
  int ends[3];
  facetVertices(mesh, facet, ends);
  return place < 0.5 ? ends[0] : ends[1];
}

bool isEnd(double place)
{
  return std::min(std::abs(place), std::abs(1.0 - place)) < alreadyThere;
}

/// Brings vertices of two sides together.
class Meeting
{
public:
  Meeting(Mesh& first, const std::string& firstSide, Mesh& second, const std::string& secondSide)
      : first_(first), second_(second), ours_(first, firstSide), theirs_(second, secondSide)
  {}

  /// Unless they are far from each other, or where they must stay.
  void join(int x, int y)
  {
    const double apart = std::hypot(first_.point(x)[0] - second_.point(y)[0], first_.point(x)[1] - second_.point(y)[1]);
    const double shorter = std::min(ours_.shortestFacetAt(x), theirs_.shortestFacetAt(y));
    if (apart > near * shorter || apart <= alreadyThere * shorter)
      return;
    if (theirs_.move(y, first_.point(x)) || ours_.move(x, second_.point(y))) {
      ours_.keep(x);
      theirs_.keep(y);
      any_ = true;
    }
  }

  bool any() const { return any_; }

private:
  Mesh &first_, &second_;
  LooseVertices ours_, theirs_;
  bool any_ = false;
};

} // namespace

bool moveVertices(const SideMap& map, Mesh& first, const std::string& firstSide, Mesh& second,
                  const std::string& secondSide, const std::vector<FacingPiece>& pieces)
{
  Meeting meeting(first, firstSide, second, secondSide);
  const auto joinWhere = [&](const auto& isMeeting) {
    for (const FacingPiece& piece : pieces)
      if (map.isSameLine(map.segments()[piece.segment]))
        for (const std::size_t end : {0u, 1u})
          if (const auto places = isMeeting(piece, end); places)
            meeting.join(vertexAt(first, piece.first, places->first), vertexAt(second, piece.second, places->second));
  };
  using Places = std::optional<std::pair<double, double>>;
  // a vertex of one side at one end, of the other side at the other end
  joinWhere([](const FacingPiece& piece, std::size_t end) -> Places {
    const std::pair places(piece.onFirst[end], piece.onSecond[1 - end]);
    return isEnd(places.first) && isEnd(places.second) ? Places(places) : std::nullopt;
  });
  // where a side ends inside a facet of the other one, near its vertex
  joinWhere([](const FacingPiece& piece, std::size_t end) -> Places {
    const std::pair places(piece.onFirst[end], piece.onSecond[end]);
    return isEnd(places.first) != isEnd(places.second) ? Places(places) : std::nullopt;
  });
  return meeting.any();
}

} // namespace ndframe
