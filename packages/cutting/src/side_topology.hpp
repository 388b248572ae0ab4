#pragma once

#include <array>
#include <map>
#include <optional>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// A point, or a direction.
using Vector3 = std::array<double, 3>;

inline double innerProduct(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// What of a side of a solid a point lies on: a vertex (its number in the mesh), an edge, a facet (both as the topology
/// numbers them), or nothing.
struct Carrier
{
  enum class Kind
  {
    Nothing,
    Facet,
    Edge,
    Vertex
  };
  Kind kind = Kind::Nothing;
  int number = -1;

  bool operator==(const Carrier& other) const { return kind == other.kind && number == other.number; }
};

/// Vertices, edges and facets of a side of a solid.
class SideTopology
{
public:
  SideTopology(const Mesh& mesh, const std::vector<Facet>& facets);

  const Mesh& mesh() const { return mesh_; }
  int numFacets() const { return int(facets_.size()); }
  const std::vector<Facet>& facets() const { return facets_; }
  Facet facet(int f) const { return facets_[std::size_t(f)]; }
  const std::array<int, 3>& vertices(int f) const { return vertices_[std::size_t(f)]; }
  /// Edge k is opposite to vertex k.
  const std::array<int, 3>& edges(int f) const { return edges_[std::size_t(f)]; }
  const std::array<int, 2>& ends(int edge) const { return ends_[std::size_t(edge)]; }
  Vector3 point(int vertex) const;
  /// Outward.
  const Vector3& normal(int f) const { return normals_[std::size_t(f)]; }
  /// The root of a facet's area; the shortest edge of the side at a vertex; the length of an edge.
  double sizeOfFacet(int f) const { return sizes_[std::size_t(f)]; }
  double sizeAt(int vertex) const { return shortest_.at(vertex); }
  double length(int edge) const { return lengths_[std::size_t(edge)]; }

  /// Whether what carries a point belongs to a facet, its edges and vertices, or to an edge and its ends.
  bool isInFacet(const Carrier& carrier, int f) const;
  bool isInEdge(const Carrier& carrier, int edge) const;
  /// The facets that have it.
  const std::vector<int>& facetsOf(const Carrier& carrier) const;

private:
  const Mesh& mesh_;
  std::vector<Facet> facets_;
  std::vector<std::array<int, 3>> vertices_, edges_;
  std::vector<std::array<int, 2>> ends_;
  std::vector<Vector3> normals_;
  std::vector<double> sizes_, lengths_;
  std::map<int, double> shortest_;
  std::map<int, std::vector<int>> ofVertex_;
  std::vector<std::vector<int>> ofEdge_, ofFacet_;
};

/// Boxes of facets that overlap, grown by `margin` of their size: pairs of places in the two sides.
std::vector<std::array<int, 2>> nearFacets(const SideTopology& first, const SideTopology& second, double margin);

} // namespace ndframe
