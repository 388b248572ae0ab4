#include "flat_pairs.hpp"
#include "loose_flat_vertices.hpp"

namespace ndframe
{
namespace
{

/// A vertex is moved by no more than this part of the shortest edge of its side there.
constexpr double near = 0.2;
/// Moves by less are round-off: the vertices are one already.
constexpr double alreadyThere = 1e-9;

/// Brings the vertices of two sides together.
class FlatMeeting
{
public:
  FlatMeeting(Mesh& first, const std::string& firstSide, Mesh& second, const std::string& secondSide)
      : sides_{SideTopology(first, first.findSide(firstSide)->facets),
               SideTopology(second, second.findSide(secondSide)->facets)},
        loose_{LooseFlatVertices(first, firstSide), LooseFlatVertices(second, secondSide)}
  {}

  std::array<bool, 2> run()
  {
    const auto pairs = overlappingFacets(sides_[0], sides_[1]);
    for (const auto& pair : pairs)
      for (const int v : sides_[0].vertices(pair.first))
        for (const int w : sides_[1].vertices(pair.second))
          join(v, w);
    for (const auto& pair : pairs) {
      for (const int w : sides_[1].vertices(pair.second))
        for (const int edge : sides_[0].edges(pair.first))
          moveOnto(1, w, edge);
      for (const int v : sides_[0].vertices(pair.first))
        for (const int edge : sides_[1].edges(pair.second))
          moveOnto(0, v, edge);
    }
    return moved_;
  }

private:
  void join(int v, int w)
  {
    const Vector3 x = sides_[0].point(v), y = sides_[1].point(w);
    const double apart = norm(minus(x, y)), shorter = std::min(sides_[0].sizeAt(v), sides_[1].sizeAt(w));
    if (apart > near * shorter)
      return;
    if (apart > 0.0) {
      if (loose_[1].move(w, x))
        moved_[1] = true;
      else if (loose_[0].move(v, y))
        moved_[0] = true;
      else if (apart > alreadyThere * shorter)
        return;
    }
    loose_[0].keep(v);
    loose_[1].keep(w);
  }

  /// A vertex of side s onto an edge of the other one.
  void moveOnto(std::size_t s, int vertex, int edge)
  {
    const SideTopology &ours = sides_[s], &theirs = sides_[1 - s];
    const Vector3 x = ours.point(vertex), a = theirs.point(theirs.ends(edge)[0]),
                  along = minus(theirs.point(theirs.ends(edge)[1]), a);
    const double squared = innerProduct(along, along), t = innerProduct(minus(x, a), along) / squared;
    if (t < near || t > 1.0 - near)
      return;
    Vector3 to = a;
    for (std::size_t k = 0; k < 3; ++k)
      to[k] += t * along[k];
    const double apart = norm(minus(to, x)), shorter = std::min(ours.sizeAt(vertex), theirs.length(edge));
    if (apart > near * shorter || apart <= alreadyThere * shorter || !loose_[s].move(vertex, to))
      return;
    moved_[s] = true;
    loose_[s].keep(vertex);
    for (const int end : theirs.ends(edge)) // the edge must stay where it is
      loose_[1 - s].keep(end);
  }

  std::array<SideTopology, 2> sides_;
  std::array<LooseFlatVertices, 2> loose_;
  std::array<bool, 2> moved_{};
};

} // namespace

std::array<bool, 2> moveFlatVertices(Mesh& first, const std::string& firstSide, Mesh& second,
                                     const std::string& secondSide)
{
  return FlatMeeting(first, firstSide, second, secondSide).run();
}

} // namespace ndframe
