#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "ndframe/interface/normal_field.hpp"
#include "ndframe/interface/side_map.hpp"
#include "rays.hpp"

namespace ndframe
{
namespace
{

/// Vertices that are this near to the line through others, relative to its length, are on it.
constexpr double onLine = 1e-9;
/// A facet lies on an edge when its ends do, relative to its length.
constexpr double onEdge = 1e-6;

Direction pointAt(const Mesh& mesh, int vertex)
{
  return {mesh.point(vertex)[0], mesh.point(vertex)[1], 0.0};
}

/// An edge with the vertices at its ends.
struct Piece
{
  SideEdge edge;
  std::array<int, 2> vertices;
};

/// The facets of a side as edges, each with the body to its left.
std::vector<Piece> facetEdges(const Mesh& mesh, const std::vector<Facet>& facets, double cornerAngle)
{
  const InterfaceMesh side = sideAlone(mesh, facets, cornerAngle);
  std::vector<Piece> pieces;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const Direction& own = side.facetNormals[f];
    const std::array<int, 2> local{side.facets[2 * f], side.facets[2 * f + 1]};
    Piece piece{{}, {side.sides[0].nodes[std::size_t(local[0])], side.sides[0].nodes[std::size_t(local[1])]}};
    piece.edge = {{pointAt(mesh, piece.vertices[0]), pointAt(mesh, piece.vertices[1])}, {own, own}};
    if (!side.endNormals.empty() && dotProduct(side.endNormals[f][0], side.endNormals[f][0]) > 0.0) {
      piece.edge.normals = {side.endNormals[f][0], side.endNormals[f][1]};
      piece.edge.turns = true;
    }
    if (cross(difference(piece.edge.ends[1], piece.edge.ends[0]), own) > 0.0) { // the normal must be to the right
      std::swap(piece.edge.ends[0], piece.edge.ends[1]);
      std::swap(piece.edge.normals[0], piece.edge.normals[1]);
      std::swap(piece.vertices[0], piece.vertices[1]);
    }
    if (piece.edge.turns) { // kappa L^2 / 8 with kappa L the change of n along the edge
      const double spread = dotProduct(difference(piece.edge.normals[1], piece.edge.normals[0]),
                                       difference(piece.edge.ends[1], piece.edge.ends[0])) /
                            8.0;
      piece.edge.bulge = {spread * own[0], spread * own[1], 0.0};
    }
    pieces.push_back(piece);
  }
  return pieces;
}

bool goesOn(const SideEdge& a, const SideEdge& b)
{
  const Direction whole = difference(b.ends[1], a.ends[0]), part = difference(a.ends[1], a.ends[0]);
  const double squared = dotProduct(whole, whole);
  return !a.turns && !b.turns && dotProduct(whole, part) > 0.0 && std::abs(cross(whole, part)) <= onLine * squared;
}

/// Where curvature changes the bulge of one edge alone says little.
void setUnsure(std::vector<Piece>& pieces, const std::map<int, std::size_t>& startingAt)
{
  constexpr double ofBulge = 0.25;
  const auto unsure = [](const SideEdge& edge) { return ofBulge * std::sqrt(dotProduct(edge.bulge, edge.bulge)); };
  for (Piece& piece : pieces) {
    piece.edge.unsure = std::max(piece.edge.unsure, unsure(piece.edge));
    if (const auto next = startingAt.find(piece.vertices[1]); next != startingAt.end()) {
      SideEdge& other = pieces[next->second].edge;
      piece.edge.unsure = std::max(piece.edge.unsure, unsure(other));
      other.unsure = std::max(other.unsure, unsure(piece.edge));
    }
  }
}

} // namespace

Direction SideEdge::at(double place) const
{
  return {(1.0 - place) * ends[0][0] + place * ends[1][0], (1.0 - place) * ends[0][1] + place * ends[1][1], 0.0};
}

Direction SideEdge::onCurve(double place) const
{
  const Direction chord = at(place);
  const double share = 4.0 * place * (1.0 - place);
  return {chord[0] + share * bulge[0], chord[1] + share * bulge[1], 0.0};
}

double SideEdge::length() const
{
  const Direction along = difference(ends[1], ends[0]);
  return std::sqrt(dotProduct(along, along));
}

SidePolygon::SidePolygon(const Mesh& mesh, const std::vector<Facet>& facets, double cornerAngle)
{
  std::vector<Piece> pieces = facetEdges(mesh, facets, cornerAngle);
  std::map<int, std::size_t> startingAt;
  std::vector<char> follows(pieces.size(), 0), done(pieces.size(), 0);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    startingAt[pieces[i].vertices[0]] = i;
  setUnsure(pieces, startingAt);
  for (const Piece& piece : pieces)
    if (const auto next = startingAt.find(piece.vertices[1]); next != startingAt.end())
      follows[next->second] = goesOn(piece.edge, pieces[next->second].edge) ? 1 : 0;
  for (std::size_t start = 0; start < pieces.size(); ++start) {
    if (follows[start] || done[start])
      continue;
    SideEdge edge = pieces[start].edge;
    done[start] = 1;
    for (auto next = startingAt.find(pieces[start].vertices[1]);
         next != startingAt.end() && follows[next->second] && goesOn(edge, pieces[next->second].edge);
         next = startingAt.find(pieces[next->second].vertices[1]))
    {
      edge.ends[1] = pieces[next->second].edge.ends[1];
      done[next->second] = 1;
    }
    edges_.push_back(edge);
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) // those that a run left out when it drifted off its line
    if (!done[i])
      edges_.push_back(pieces[i].edge);
}

Stretch SidePolygon::locate(const Mesh& mesh, Facet facet) const
{
  int vertices[3];
  facetVertices(mesh, facet, vertices);
  const Direction a = pointAt(mesh, vertices[0]), b = pointAt(mesh, vertices[1]), length = difference(b, a);
  const double tolerance = onEdge * std::sqrt(dotProduct(length, length));
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Direction along = difference(edges_[e].ends[1], edges_[e].ends[0]);
    const double squared = dotProduct(along, along), size = std::sqrt(squared);
    const auto place = [&](const Direction& x) {
      return dotProduct(difference(x, edges_[e].ends[0]), along) / squared;
    };
    const auto isOff = [&](const Direction& x) {
      return std::abs(cross(along, difference(x, edges_[e].ends[0]))) > tolerance * size ||
             place(x) * size < -tolerance || (place(x) - 1.0) * size > tolerance;
    };
    if (!isOff(a) && !isOff(b))
      return {int(e), place(a), place(b)};
  }
  return {};
}

} // namespace ndframe
