#include "ndframe/adaptivity/edge_exponents.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "creases.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Tubes that became thinner by less teach nothing.
constexpr double clearlyThinner = 0.6;
/// Exponents that differ by round-off are equal: meshes shall not depend on the number of ranks.
constexpr double resolution = 1.0 / 1024;
/// Cracks and stiff punches have 0.5.
constexpr double smallest = 0.5;

using Point = std::array<double, 3>;

Point pointOf(const Mesh& mesh, int vertex)
{
  const double* x = mesh.point(vertex);
  return {x[0], x[1], x[2]};
}

/// Points by where they are, bit by bit.
std::map<Point, int> pointsByPlace(const Mesh& mesh)
{
  std::map<Point, int> points;
  for (int p = 0; p < mesh.numPoints(); ++p)
    points[pointOf(mesh, p)] = p;
  return points;
}

/// Puts the vertices that came between x and y, and y, behind x.
void addPieces(const std::map<Point, int>& points, const Point& x, const Point& y, std::vector<int>& chain)
{
  const auto middle = points.find({0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1]), 0.5 * (x[2] + y[2])});
  if (middle == points.end()) {
    chain.push_back(points.at(y));
    return;
  }
  addPieces(points, x, middle->first, chain);
  addPieces(points, middle->first, y, chain);
}

double distance(const Mesh& mesh, int a, int b)
{
  const Point x = pointOf(mesh, a), y = pointOf(mesh, b);
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

} // namespace

void EdgeExponents::findCreases(const Mesh& mesh)
{
  creases_.emplace_back();
  for (const auto& [a, b] : creasesOf(mesh)) {
    const Point x = pointOf(mesh, a), y = pointOf(mesh, b);
    const double length = distance(mesh, a, b);
    creases_.back().push_back(
        {{x, y}, {}, {(y[0] - x[0]) / length, (y[1] - x[1]) / length, (y[2] - x[2]) / length}, smooth_});
  }
}

void EdgeExponents::observe(const std::vector<const Mesh*>& meshes, const std::vector<Vector>& contributions,
                            bool isCoarse)
{
  if (creases_.empty())
    for (const Mesh* mesh : meshes)
      findCreases(*mesh);
  exponents_.clear();
  directions_.clear();
  for (std::size_t b = 0; b < meshes.size(); ++b) {
    const Mesh& mesh = *meshes[b];
    NDFRAME_ASSERT(contributions[b].size() == std::size_t(mesh.numCells()), "one contribution per cell is needed");
    const std::map<Point, int> points = pointsByPlace(mesh);
    for (Crease& crease : creases_[b]) {
      if (isCoarse) {
        crease.exponent = smooth_;
        crease.tube = {};
      }
      crease.chain = {points.at(crease.ends[0])};
      addPieces(points, crease.ends[0], crease.ends[1], crease.chain);
    }
    const std::vector<Tube> tubes = tubesOf(mesh, contributions[b], creases_[b]);
    for (std::size_t i = 0; i < tubes.size(); ++i)
      if (!isCoarse)
        learn(creases_[b][i], tubes[i]);
    tellVertices(mesh, creases_[b]);
  }
}

std::vector<EdgeExponents::Tube> EdgeExponents::tubesOf(const Mesh& mesh, const Vector& contributions,
                                                        const std::vector<Crease>& creases)
{
  std::map<std::pair<int, int>, std::size_t> pieces;
  std::vector<Tube> tubes(creases.size());
  std::vector<char> isOn(std::size_t(mesh.numPoints()), 0);
  for (std::size_t i = 0; i < creases.size(); ++i) {
    const std::vector<int>& chain = creases[i].chain;
    const std::size_t ends = chain.size() > 3 ? 1 : 0; // pieces at them that are left out
    for (std::size_t k = 1 + ends; k + ends < chain.size(); ++k) {
      pieces[std::minmax(chain[k - 1], chain[k])] = i;
      tubes[i].length += distance(mesh, chain[k - 1], chain[k]);
      isOn[std::size_t(chain[k - 1])] = isOn[std::size_t(chain[k])] = 1;
    }
  }
  for (int c = 0; c < mesh.numCells(); ++c)
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b) {
        const std::pair<int, int> ends = std::minmax(mesh.cell(c)[a], mesh.cell(c)[b]);
        if (!isOn[std::size_t(ends.first)] || !isOn[std::size_t(ends.second)])
          continue;
        if (const auto found = pieces.find(ends); found != pieces.end()) {
          tubes[found->second].squared += contributions[std::size_t(c)] * contributions[std::size_t(c)];
          tubes[found->second].volume += cellMeasure(mesh, c);
        }
      }
  return tubes;
}

void EdgeExponents::learn(Crease& crease, const Tube& now) const
{
  const Tube before = crease.tube;
  if (before.squared <= 0.0 || now.squared <= 0.0) {
    crease.tube = now;
    return;
  }
  const double thinner = now.volume / now.length / (before.volume / before.length);
  const double less = now.squared / now.length / (before.squared / before.length);
  if (thinner > clearlyThinner)
    return;
  const double exponent = resolution * std::round(std::log(less) / std::log(thinner) / resolution);
  crease.exponent = std::clamp(exponent, smallest, smooth_);
  crease.tube = now;
}

bool EdgeExponents::knowsAny() const
{
  return std::any_of(exponents_.begin(), exponents_.end(), [this](const Vector& ofBody) {
    return std::any_of(ofBody.begin(), ofBody.end(), [this](double exponent) { return exponent < smooth_; });
  });
}

void EdgeExponents::tellVertices(const Mesh& mesh, const std::vector<Crease>& creases)
{
  exponents_.emplace_back(std::size_t(mesh.numPoints()), smooth_);
  directions_.emplace_back(std::size_t(mesh.numPoints()), Point{});
  for (const Crease& crease : creases)
    for (const int vertex : crease.chain)
      if (double& exponent = exponents_.back()[std::size_t(vertex)]; crease.exponent < exponent) {
        exponent = crease.exponent;
        directions_.back()[std::size_t(vertex)] = crease.direction;
      }
}

} // namespace ndframe
