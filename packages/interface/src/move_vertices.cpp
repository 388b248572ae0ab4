#include "move_vertices.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "ndframe/mesh/loose_vertices.hpp"

namespace ndframe
{
namespace
{

/// A vertex is moved by no more than this part of its shorter facet.
constexpr double near = 0.05;
/// Moves by less are round-off: the vertices are one already.
constexpr double alreadyThere = 1e-9;

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
