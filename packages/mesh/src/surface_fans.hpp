#pragma once

#include <cmath>

#include "ndframe/mesh/surface_normals.hpp"

namespace ndframe
{

using Vector3 = TriangleSurface::Vector3;

inline double dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3 sum(double a, const Vector3& x, double b, const Vector3& y)
{
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}

inline Vector3 cross(const Vector3& a, const Vector3& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double norm(const Vector3& a)
{
  return std::sqrt(dot(a, a));
}

inline Vector3 unit(const Vector3& a)
{
  return sum(1.0 / norm(a), a, 0.0, a);
}

inline double distance(const Vector3& a, const Vector3& b)
{
  return norm(sum(1.0, a, -1.0, b));
}

/// The triangles around a vertex that edges at which the surface does not turn much hold together.
struct Fan
{
  struct Neighbour
  {
    int vertex, fan;
  };
  int vertex = -1;
  std::vector<int> triangles;
  std::vector<Neighbour> neighbours;
  int edges = 0;                                       ///< inside
  bool isFlat = false, isKnown = false, isOwn = false; ///< isOwn: every triangle keeps its own normal
  Vector3 normal{};                                    ///< of length 1
  double length = 1.0;                                 ///< of n

  bool closes() const { return edges == int(triangles.size()); }
};

/// Numbers that are united to sets.
class UnitedSets
{
public:
  explicit UnitedSets(std::size_t numbers); ///< each alone
  int of(int number);                       ///< the set's name: one of its numbers
  void unite(int a, int b) { parent_[std::size_t(of(a))] = of(b); }

private:
  std::vector<int> parent_;
};

/// All fans of a surface.
struct SurfaceFans
{
  std::vector<Fan> fans;       ///< by vertex, triangles and edges
  std::vector<int> ofTriangle; ///< per triangle and vertex, three a triangle
};

/// cornerAngle: in radians.
SurfaceFans makeFans(const TriangleSurface& surface, double cornerAngle);

} // namespace ndframe
