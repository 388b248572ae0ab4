#include "ndframe/mesh/surface_normals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "small_least_squares.hpp"
#include "surface_fans.hpp"

namespace ndframe
{
namespace
{

/// Normals that differ by less are one: coordinates in files have some digits only.
constexpr double straightOn = 1e-6;
/// The least cosine between n and the normals of its triangles.
constexpr double leastCosine = 0.5;
/// Steps towards the frame in which n itself is the axis, at most; they end where it turns by less.
constexpr int frameSteps = 20;
constexpr double settled = 1e-15;

/// Two directions across an axis of length 1.
std::array<Vector3, 2> across(const Vector3& axis)
{
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
    least = std::abs(axis[k]) < std::abs(axis[least]) ? k : least;
  Vector3 first{};
  first[least] = 1.0;
  first = unit(sum(1.0, first, -dot(first, axis), axis));
  return {first, cross(axis, first)};
}

class SurfaceNormals
{
public:
  SurfaceNormals(const TriangleSurface& surface, double cornerAngle) : surface_(surface)
  {
    auto made = makeFans(surface, cornerAngle * std::acos(-1.0) / 180.0);
    fans_ = std::move(made.fans);
    fanOf_ = std::move(made.ofTriangle);
    for (Fan& fan : fans_)
      start(fan);
    for (Fan& fan : fans_)
      if (fan.isFlat ? !isBesideBends(fan) : fan.closes()) {
        fan.isOwn = fan.isFlat;
        fan.isKnown = fan.isFlat || fit(fan, false);
      }
    while (follow() || fitRest(false) || fitRest(true))
      continue;
    for (Fan& fan : fans_)
      fan.isOwn = fan.isOwn || !fan.isKnown;
    findLengths();
  }

  std::vector<std::array<Vector3, 3>> ofTriangles() const
  {
    std::vector<std::array<Vector3, 3>> result;
    bool turns = false;
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      std::array<Vector3, 3> values{};
      bool ofThis = false;
      for (std::size_t i = 0; i < 3; ++i) {
        values[i] = valueAt(fans_[std::size_t(fanOf_[3 * t + i])], t);
        ofThis = ofThis || distance(values[i], surface_.normals[t]) > straightOn;
      }
      result.push_back(ofThis ? values : std::array<Vector3, 3>{});
      turns = turns || ofThis;
    }
    return turns ? result : std::vector<std::array<Vector3, 3>>();
  }

private:
  const Vector3& point(int vertex) const { return surface_.points[std::size_t(vertex)]; }
  const Vector3& normalOf(int triangle) const { return surface_.normals[std::size_t(triangle)]; }
  Vector3 chord(const Fan& fan, int vertex) const { return sum(1.0, point(vertex), -1.0, point(fan.vertex)); }

  void start(Fan& fan) const;
  bool isBesideBends(const Fan& fan) const;
  bool accept(Fan& fan, const Vector3& normal) const;
  bool fit(Fan& fan, bool always) const;
  bool fitRest(bool always);
  bool follow();
  bool followNeighbours(Fan& fan) const;
  void findLengths();
  Vector3 valueAt(const Fan& fan, std::size_t triangle) const;

  const TriangleSurface& surface_;
  std::vector<Fan> fans_;
  std::vector<int> fanOf_; ///< per triangle and vertex
};

/// Neighbours, and the mean of the normals with weights that are right on spheres (Max 1999).
void SurfaceNormals::start(Fan& fan) const
{
  Vector3 mean{};
  fan.isFlat = true;
  for (const int t : fan.triangles) {
    const auto& vertices = surface_.triangles[std::size_t(t)];
    fan.isFlat = fan.isFlat && distance(normalOf(t), normalOf(fan.triangles.front())) <= straightOn;
    std::array<Vector3, 2> chords{};
    for (std::size_t i = 0, count = 0; i < 3; ++i)
      if (vertices[i] != fan.vertex) {
        chords[count++] = chord(fan, vertices[i]);
        if (std::none_of(fan.neighbours.begin(), fan.neighbours.end(),
                         [&](const auto& known) { return known.vertex == vertices[i]; }))
          fan.neighbours.push_back({vertices[i], fanOf_[3 * std::size_t(t) + i]});
      }
    const double lengths = dot(chords[0], chords[0]) * dot(chords[1], chords[1]);
    mean = sum(1.0, mean, norm(cross(chords[0], chords[1])) / lengths, normalOf(t));
  }
  fan.normal = norm(mean) > 0.0 ? unit(mean) : normalOf(fan.triangles.front());
}

/// Whether a flat fan is open and each of its triangles turns at another vertex: the end of a curved part, not of a
/// flat one.
bool SurfaceNormals::isBesideBends(const Fan& fan) const
{
  return !fan.closes() && std::all_of(fan.triangles.begin(), fan.triangles.end(), [&](int t) {
    const auto first = fanOf_.begin() + 3 * std::ptrdiff_t(t);
    return std::any_of(first, first + 3, [&](int other) { return !fans_[std::size_t(other)].isFlat; });
  });
}

bool SurfaceNormals::accept(Fan& fan, const Vector3& normal) const
{
  for (const int t : fan.triangles)
    if (!(dot(normal, normalOf(t)) >= leastCosine))
      return false;
  fan.normal = normal;
  return true;
}

/// The normal of z = a x + b y + L x^2 / 2 + M x y + N y^2 / 2 + K z^2 / 2 through the neighbours, K the larger
/// principal curvature: right on spheres and cylinders. False where a and b are not determined, unless `always`.
bool SurfaceNormals::fit(Fan& fan, bool always) const
{
  Vector3 normal = fan.normal;
  double size = 0.0, K = 0.0;
  for (const auto& neighbour : fan.neighbours)
    size += norm(chord(fan, neighbour.vertex)) / double(fan.neighbours.size());
  for (int step = 0; step < frameSteps; ++step) {
    const auto [u, v] = across(normal);
    SmallLeastSquares<5> fitted;
    for (const auto& neighbour : fan.neighbours) {
      const Vector3 e = chord(fan, neighbour.vertex);
      const double x = dot(e, u) / size, y = dot(e, v) / size, z = dot(e, normal) / size;
      fitted.add({x, y, 0.5 * x * x, x * y, 0.5 * y * y}, z - 0.5 * K * z * z, size / norm(e));
    }
    if (step == 0 && !always && !(fitted.determines(0) && fitted.determines(1)))
      return false;
    const auto shape = fitted.solution();
    const double mean = 0.5 * (shape[2] + shape[4]);
    K = mean + std::copysign(std::hypot(0.5 * (shape[2] - shape[4]), shape[3]), mean);
    normal = unit(sum(1.0, sum(1.0, normal, -shape[0], u), -shape[1], v));
    if (std::abs(shape[0]) + std::abs(shape[1]) < settled)
      break;
  }
  if (!accept(fan, normal) && !accept(fan, fan.normal))
    fan.isOwn = true;
  return true;
}

/// Fans that no neighbour decides: by themselves, unless they are flat. Returns whether one was decided.
bool SurfaceNormals::fitRest(bool always)
{
  bool some = false;
  for (Fan& fan : fans_)
    if (!fan.isKnown && !fan.isFlat) {
      fan.isKnown = fit(fan, always);
      some = some || fan.isKnown;
    }
  return some;
}

/// Fans whose known neighbours decide. Returns whether one was.
bool SurfaceNormals::follow()
{
  std::vector<Fan*> decided; // known only when all have asked: their order does not matter
  for (Fan& fan : fans_)
    if (!fan.isKnown && followNeighbours(fan))
      decided.push_back(&fan);
  for (Fan* fan : decided)
    fan->isKnown = true;
  return !decided.empty();
}

bool SurfaceNormals::followNeighbours(Fan& fan) const
{
  constexpr double apart = 0.05; // of the chords, so that they decide both directions
  Vector3 normal = fan.normal;
  for (int step = 0; step < frameSteps; ++step) {
    const auto [u, v] = across(normal);
    double uu = 0.0, uv = 0.0, vv = 0.0, ru = 0.0, rv = 0.0;
    for (const auto& neighbour : fan.neighbours) {
      const Fan& other = fans_[std::size_t(neighbour.fan)];
      if (!other.isKnown || (other.isOwn && !other.isFlat))
        continue;
      const Vector3 e = unit(chord(fan, neighbour.vertex));
      const double x = dot(e, u), y = dot(e, v), r = -dot(e, sum(1.0, other.normal, 1.0, normal));
      uu += x * x, uv += x * y, vv += y * y, ru += r * x, rv += r * y;
    }
    const double det = uu * vv - uv * uv;
    if (!(det > apart * (uu + vv) * (uu + vv)))
      return false;
    normal = unit(sum(1.0, sum(1.0, normal, (vv * ru - uv * rv) / det, u), (uu * rv - uv * ru) / det, v));
  }
  return accept(fan, normal);
}

/// One for all fans of a part that turns without an edge: what turns on a sphere or a cylinder must find n . (w x x) =
/// 0 on every triangle.
void SurfaceNormals::findLengths()
{
  UnitedSets parts(fans_.size());
  for (std::size_t corner = 0; corner < fanOf_.size(); ++corner)
    for (const std::size_t other : {corner / 3 * 3, corner / 3 * 3 + 1})
      if (!fans_[std::size_t(fanOf_[corner])].isOwn && !fans_[std::size_t(fanOf_[other])].isOwn)
        parts.unite(fanOf_[corner], fanOf_[other]);
  std::vector<double> along(fans_.size(), 0.0), count(fans_.size(), 0.0);
  for (std::size_t f = 0; f < fans_.size(); ++f)
    for (const int t : fans_[f].triangles) {
      along[std::size_t(parts.of(int(f)))] += dot(normalOf(t), fans_[f].normal);
      count[std::size_t(parts.of(int(f)))] += 1.0;
    }
  for (std::size_t f = 0; f < fans_.size(); ++f)
    fans_[f].length = count[std::size_t(parts.of(int(f)))] / along[std::size_t(parts.of(int(f)))];
}

Vector3 SurfaceNormals::valueAt(const Fan& fan, std::size_t triangle) const
{
  return fan.isOwn ? surface_.normals[triangle] : sum(fan.length, fan.normal, 0.0, fan.normal);
}

} // namespace

std::vector<std::array<Vector3, 3>> turningNormals(const TriangleSurface& surface, double cornerAngle)
{
  return SurfaceNormals(surface, cornerAngle).ofTriangles();
}

} // namespace ndframe
