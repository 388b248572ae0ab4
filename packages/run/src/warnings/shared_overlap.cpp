#include "shared_overlap.hpp"

#include <algorithm>
#include <limits>

#include "ndframe/algebra/exchanged_values.hpp"
#include "ndframe/algebra/shared_values.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t boxSize = 6;   ///< numbers of a box: three lower coordinates, three upper
constexpr std::size_t pointSize = 6; ///< of a point: three coordinates, three of its normal
constexpr std::size_t standingSize = 3;

/// Per rank the box around its cells of a body, empty (upside down) where it has none.
Vector boxesOf(const BoundaryView& view, const Comm& comm)
{
  constexpr double none = std::numeric_limits<double>::max();
  const Mesh& mesh = *view.mesh;
  const double third = mesh.dim == 3 ? none : 0.0;
  Vector box{none, none, third, -none, -none, -third};
  for (int c = 0; c < view.lookedAt(); ++c)
    for (int v = 0; v <= mesh.dim; ++v)
      for (int k = 0; k < mesh.dim; ++k) {
        const double x = mesh.point(mesh.cell(c)[v])[k];
        box[std::size_t(k)] = std::min(box[std::size_t(k)], x);
        box[3 + std::size_t(k)] = std::max(box[3 + std::size_t(k)], x);
      }
  return gatheredFrom(box, comm);
}

bool holds(const double* box, const BoundaryPoint& point, int dim, double reach)
{
  for (std::size_t k = 0; k < std::size_t(dim); ++k)
    if (point.x[k] < box[k] - reach || point.x[k] > box[3 + k] + reach)
      return false;
  return true;
}

/// Per rank and point that was sent here, how it stands to this rank's cells.
std::vector<Vector> answersTo(const std::vector<Vector>& sent, const BoundaryView& body, double reach)
{
  std::vector<BoundaryPoint> points;
  for (const Vector& of : sent)
    for (auto next = of.begin(); next != of.end(); next += pointSize) {
      BoundaryPoint& point = points.emplace_back();
      std::copy_n(next, 3, point.x.begin());
      std::copy_n(next + 3, 3, point.normal.begin());
    }
  const std::vector<Standing> standings = standingsOf(points, body, reach);
  auto standing = standings.begin();
  std::vector<Vector> answers(sent.size());
  for (std::size_t rank = 0; rank < sent.size(); ++rank)
    for (std::size_t i = 0; i < sent[rank].size(); i += pointSize, ++standing)
      answers[rank].insert(answers[rank].end(),
                           {standing->inside ? 1.0 : 0.0, standing->touches ? 1.0 : 0.0, standing->depth});
  return answers;
}

/// How points of this rank stand to the cells of all. boxes: of these.
std::vector<Standing> standingsAmong(const std::vector<BoundaryPoint>& points, const BoundaryView& body,
                                     const Vector& boxes, double reach, const Comm& comm)
{
  std::vector<Vector> sent(std::size_t(comm.size()));
  std::vector<std::vector<std::size_t>> places(sent.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t rank = 0; rank < sent.size(); ++rank)
      if (holds(boxes.data() + rank * boxSize, points[i], body.mesh->dim, reach)) {
        sent[rank].insert(sent[rank].end(), points[i].x.begin(), points[i].x.end());
        sent[rank].insert(sent[rank].end(), points[i].normal.begin(), points[i].normal.end());
        places[rank].push_back(i);
      }
  const auto answers = exchangedValues(answersTo(exchangedValues(sent, comm), body, reach), comm);
  std::vector<Standing> standings(points.size());
  for (std::size_t rank = 0; rank < places.size(); ++rank)
    for (std::size_t i = 0; i < places[rank].size(); ++i) {
      const double* const answer = answers[rank].data() + i * standingSize;
      standings[places[rank][i]].add({answer[0] != 0.0, answer[1] != 0.0, answer[2]});
    }
  return standings;
}

/// The diameter of all boxes together.
double diameterOf(const Vector& boxes)
{
  Mesh mesh;
  mesh.dim = 3;
  for (std::size_t at = 0; at < boxes.size(); at += boxSize)
    if (boxes[at] <= boxes[at + 3]) {
      mesh.points.insert(mesh.points.end(), boxes.begin() + std::ptrdiff_t(at), boxes.begin() + std::ptrdiff_t(at + 6));
    }
  return diameter(mesh);
}

/// The deepest of what ranks have found, and whether any touches.
Encounter ofAllRanks(const Encounter& own, const Comm& comm)
{
  constexpr std::size_t size = 8;
  const std::array<double, 3> touching = own.touching.value_or(std::array<double, 3>{});
  const Vector all = gatheredFrom({own.depth, own.deepest[0], own.deepest[1], own.deepest[2], own.touching ? 1.0 : 0.0,
                                   touching[0], touching[1], touching[2]},
                                  comm);
  Encounter result;
  for (std::size_t at = 0; at < all.size(); at += size) {
    const auto point = [&](std::size_t first) {
      return std::array<double, 3>{all[at + first], all[at + first + 1], all[at + first + 2]};
    };
    if (all[at] > 0.0 && (all[at] > result.depth || (all[at] == result.depth && point(1) < result.deepest))) {
      result.depth = all[at];
      result.deepest = point(1);
    }
    if (all[at + 4] != 0.0 && (!result.touching || point(5) < *result.touching))
      result.touching = point(5);
  }
  return result;
}

} // namespace

Encounter encounterOfShares(const BoundaryView& a, const BoundaryView& b, const Comm& comm)
{
  const Vector boxesA = boxesOf(a, comm), boxesB = boxesOf(b, comm);
  const double reach = reachOf(diameterOf(boxesA), diameterOf(boxesB));
  const auto oneWay = [&](const BoundaryView& first, const BoundaryView& second, const Vector& boxes) {
    const std::vector<BoundaryPoint> points = pointsOf(first);
    return encounterAt(points, standingsAmong(points, second, boxes, reach, comm));
  };
  return ofAllRanks(deeperOf(oneWay(a, b, boxesB), oneWay(b, a, boxesA)), comm);
}

std::vector<Mesh> boxesOfShares(const std::vector<BoundaryView>& views, const Comm& comm)
{
  std::vector<Mesh> meshes;
  for (const BoundaryView& view : views) {
    Mesh& mesh = meshes.emplace_back();
    mesh.dim = view.mesh->dim;
    const Vector boxes = boxesOf(view, comm);
    for (std::size_t at = 0; at < boxes.size(); at += 3)
      if (const std::size_t box = at / boxSize * boxSize; boxes[box] <= boxes[box + 3])
        mesh.points.insert(mesh.points.end(), boxes.begin() + std::ptrdiff_t(at),
                           boxes.begin() + std::ptrdiff_t(at) + mesh.dim);
  }
  return meshes;
}

} // namespace ndframe
