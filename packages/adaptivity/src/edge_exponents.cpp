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

Point minus(const Point& a, const Point& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// From one vertex to another: a unit vector and how far.
std::pair<Point, double> wayBetween(const Mesh& mesh, int a, int b)
{
  const Point way = minus(pointOf(mesh, b), pointOf(mesh, a));
  const double length = std::hypot(way[0], way[1], way[2]);
  return {{way[0] / length, way[1] / length, way[2] / length}, length};
}

double distance(const Mesh& mesh, int a, int b)
{
  return wayBetween(mesh, a, b).second;
}

/// An edge of another mesh belongs to one of the first mesh if its middle is as near to it in parts of that one's
/// length, and the cosine of the angle between them is no less. Chords of one curve are turned from each other.
constexpr double besides = 0.15, along = 0.9;

} // namespace

void EdgeExponents::findCreases(const Mesh& mesh)
{
  creases_.emplace_back();
  for (const auto& [a, b] : creasesOf(mesh)) {
    creases_.back().push_back(
        {{pointOf(mesh, a), pointOf(mesh, b)}, wayBetween(mesh, a, b).first, smooth_, int(creases_.back().size())});
  }
  if (kind_ == Meshes::MadeAnew)
    findRows(creases_.back());
}

void EdgeExponents::findRows(std::vector<Crease>& creases)
{
  std::map<Point, std::vector<std::size_t>> around;
  for (std::size_t i = 0; i < creases.size(); ++i)
    for (const Point& end : creases[i].ends)
      around[end].push_back(i);
  for (std::size_t i = 0; i < creases.size(); ++i) {
    std::vector<std::size_t> reached{i};
    while (!reached.empty()) {
      const Crease& here = creases[reached.back()];
      reached.pop_back();
      for (const Point& end : here.ends)
        for (const std::size_t other : around.at(end))
          if (creases[other].row > creases[i].row && std::abs(dot(here.direction, creases[other].direction)) > along) {
            creases[other].row = creases[i].row;
            reached.push_back(other);
          }
    }
  }
}

void EdgeExponents::addInRows(const std::vector<Crease>& creases, std::vector<Tube>& tubes)
{
  std::map<int, Tube> sums;
  for (std::size_t i = 0; i < creases.size(); ++i) {
    Tube& sum = sums[creases[i].row];
    sum.squared += tubes[i].squared;
    sum.volume += tubes[i].volume;
    sum.length += tubes[i].length;
  }
  for (std::size_t i = 0; i < creases.size(); ++i)
    tubes[i] = sums.at(creases[i].row);
}

void EdgeExponents::findHalves(const Mesh& mesh, std::vector<Crease>& creases)
{
  const std::map<Point, int> points = pointsByPlace(mesh);
  for (Crease& crease : creases) {
    std::vector<int> chain{points.at(crease.ends[0])};
    addPieces(points, crease.ends[0], crease.ends[1], chain);
    crease.pieces.clear();
    for (std::size_t k = 1; k < chain.size(); ++k)
      crease.pieces.push_back({{chain[k - 1], chain[k]}, crease.direction});
  }
}

void EdgeExponents::findPieces(const Mesh& mesh, std::vector<Crease>& creases)
{
  std::vector<std::vector<std::pair<double, Piece>>> found(creases.size()); // with the places along the crease
  for (const auto& [a, b] : creasesOf(mesh)) {
    const Point x = pointOf(mesh, a), y = pointOf(mesh, b);
    const Point middle{0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1]), 0.5 * (x[2] + y[2])};
    const Point direction = wayBetween(mesh, a, b).first;
    double least = besides, place = 0.0;
    std::size_t nearest = creases.size();
    for (std::size_t i = 0; i < creases.size(); ++i) {
      const auto& [first, last] = creases[i].ends;
      const Point way = minus(last, first), here = minus(middle, first);
      const double length = std::sqrt(dot(way, way)), at = dot(here, creases[i].direction) / length;
      const Point foot = minus(here, {at * way[0], at * way[1], at * way[2]});
      const double apart = std::sqrt(dot(foot, foot)) / length + std::max({0.0, -at, at - 1.0});
      if (apart < least && std::abs(dot(direction, creases[i].direction)) > along) {
        least = apart;
        nearest = i;
        place = at;
      }
    }
    if (nearest < creases.size())
      found[nearest].push_back({place, {{a, b}, direction}});
  }
  const auto before = [](const auto& one, const auto& other) { return one.first < other.first; };
  for (std::size_t i = 0; i < creases.size(); ++i) {
    std::stable_sort(found[i].begin(), found[i].end(), before);
    creases[i].pieces.clear();
    for (const auto& [at, piece] : found[i])
      creases[i].pieces.push_back(piece);
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
    if (isCoarse)
      for (Crease& crease : creases_[b]) {
        crease.exponent = smooth_;
        crease.tube = {};
      }
    (kind_ == Meshes::Halved ? findHalves : findPieces)(mesh, creases_[b]);
    std::vector<Tube> tubes = tubesOf(mesh, contributions[b], creases_[b]);
    if (kind_ == Meshes::MadeAnew)
      addInRows(creases_[b], tubes);
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
    const std::vector<Piece>& all = creases[i].pieces;
    const std::size_t ends = all.size() > 2 ? 1 : 0; // pieces at them that are left out
    for (std::size_t k = ends; k + ends < all.size(); ++k) {
      const auto [a, b] = all[k].ends;
      pieces[std::minmax(a, b)] = i;
      tubes[i].length += distance(mesh, a, b);
      isOn[std::size_t(a)] = isOn[std::size_t(b)] = 1;
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
  if (now.length == 0.0)
    return; // a mesh made anew may have none of its edges there
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
    for (const Piece& piece : crease.pieces)
      for (const int vertex : piece.ends)
        if (double& exponent = exponents_.back()[std::size_t(vertex)]; crease.exponent < exponent) {
          exponent = crease.exponent;
          directions_.back()[std::size_t(vertex)] = piece.direction;
        }
}

} // namespace ndframe
