#include "piece_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ndframe/algebra/common_numbers.hpp"
#include "ndframe/algebra/exchanged_values.hpp"
#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/algebra/ghosts.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/base/ascending.hpp"
#include "ndframe/mesh/boundary.hpp"
#include "ndframe/mesh/cells_of_points.hpp"

namespace ndframe
{
namespace
{

using Number = BodyPieces::Number;

/// The cells that have one of these points.
NumberedMesh around(const std::vector<Number>& points, const NumberedMesh& part)
{
  std::vector<char> isOne(std::size_t(part.mesh.numPoints()), 0);
  for (const Number number : points)
    if (const int point = placeOf(part.points, number); point >= 0)
      isOne[std::size_t(point)] = 1;
  return part.only([&](int cell) {
    const int* const first = part.mesh.cell(cell);
    return std::any_of(first, first + part.mesh.dim + 1, [&](int v) { return isOne[std::size_t(v)] != 0; });
  });
}

std::vector<Number> ownedOf(const BodyPieces& body, int rank)
{
  std::vector<Number> owned;
  for (std::size_t point = 0; point < body.owners.size(); ++point)
    if (body.owners[point] == rank)
      owned.push_back(body.part.points[point]);
  return owned;
}

/// Finds out who owns the points of the part. owned: numbers of this rank's, ascending. Collective.
void findOwners(BodyPieces& body, const std::vector<Number>& owned, const Comm& comm)
{
  body.owners = ownersOf(body.part.points, IndexMap(body.counts[0], owned), comm);
}

/// The parts that ranks have for each other, as bytes per rank, joined with the own one. Collective.
NumberedMesh joinedWith(const NumberedMesh& own, const std::vector<std::string>& others, const Comm& comm)
{
  std::vector<NumberedMesh> parts{own};
  for (const std::string& bytes : exchangedBytes(others, comm))
    if (!bytes.empty())
      parts.push_back(numberedMeshFromBytes(bytes));
  return joined(parts);
}

/// The diagonal of the box around the parts of all ranks.
double diameterOfAll(const Mesh& mesh, const Comm& comm)
{
  Vector low(std::size_t(mesh.dim), INFINITY), high(std::size_t(mesh.dim), -INFINITY);
  for (int point = 0; point < mesh.numPoints(); ++point)
    for (std::size_t k = 0; k < low.size(); ++k) {
      low[k] = std::min(low[k], mesh.point(point)[k]);
      high[k] = std::max(high[k], mesh.point(point)[k]);
    }
  takeExtremes(low, high, comm);
  double squares = 0.0;
  for (std::size_t k = 0; k < low.size(); ++k)
    squares += (high[k] - low[k]) * (high[k] - low[k]);
  return std::sqrt(squares);
}

/// The first of the vertices nearest to a point.
int nearestVertex(const Mesh& mesh, const std::vector<double>& at)
{
  int nearest = 0;
  double least = INFINITY;
  for (int point = 0; point < mesh.numPoints(); ++point) {
    double squared = 0.0;
    for (std::size_t k = 0; k < at.size(); ++k)
      squared += (mesh.point(point)[k] - at[k]) * (mesh.point(point)[k] - at[k]);
    if (squared < least) {
      least = squared;
      nearest = point;
    }
  }
  return nearest;
}

/// The points that have as many coordinates as the mesh; a mistake is told of others.
std::vector<std::vector<double>> inSpaceOf(const Mesh& mesh, const std::vector<std::vector<double>>& points)
{
  std::vector<std::vector<double>> fit;
  for (const std::vector<double>& point : points)
    if (int(point.size()) == mesh.dim)
      fit.push_back(point);
  return fit;
}

/// Marks the part's cells that points ask of. Collective.
void markAsked(std::vector<char>& isMarked, const Mesh& mesh, const AskedPoints& points, const Comm& comm)
{
  constexpr double wider = 1.0 + 1e-6; // rank 0 decides what is outside
  if (!points.inCells.empty()) {
    const double reach = wider * points.tolerance * diameterOfAll(mesh, comm);
    for (const auto& places : cellsOfPoints(mesh, inSpaceOf(mesh, points.inCells), reach))
      for (const PointInCell& place : places)
        isMarked[std::size_t(place.cell)] = 1;
  }
  if (mesh.numCells() > 0)
    for (const std::vector<double>& point : inSpaceOf(mesh, points.nearVertices)) {
      const auto at = std::find(mesh.cells.begin(), mesh.cells.end(), nearestVertex(mesh, point)) - mesh.cells.begin();
      isMarked[std::size_t(at / (mesh.dim + 1))] = 1;
    }
}

} // namespace

void findTouching(BodyPieces& body, const std::vector<std::string>& sides, const Comm& comm)
{
  const std::vector<char> touches = pointsOfSides(body.part.mesh, sides);
  Vector own;
  for (std::size_t point = 0; point < touches.size(); ++point)
    if (touches[point] != 0 && body.owners[point] == comm.rank())
      own.insert(own.end(), {double(body.part.points[point]), double(comm.rank())});
  const Vector all = gatheredFrom(own, comm);
  std::map<Number, int> owners;
  for (std::size_t i = 0; i < all.size(); i += 2)
    owners[Number(all[i])] = int(all[i + 1]);
  for (const auto& [number, owner] : owners) {
    body.touching.push_back(number);
    body.touchingOwners.push_back(owner);
  }
}

void gatherOuter(BodyPieces& body, const AskedPoints& points, const Comm& comm)
{
  const Mesh& mesh = body.part.mesh;
  std::vector<char> isOuter(std::size_t(mesh.numCells()), 0);
  for (const Facet facet : boundaryFacets(mesh)) { // of the part, whose own boundary is where others go on
    int vertices[3];
    facetVertices(mesh, facet, vertices);
    if (body.owners[std::size_t(*std::min_element(vertices, vertices + mesh.dim))] == comm.rank())
      isOuter[std::size_t(facet.cell)] = 1;
  }
  for (std::size_t kind = 0; kind < mesh.groups.names.size(); ++kind)
    if (const auto first = std::find(mesh.groups.kind.begin(), mesh.groups.kind.end(), int(kind));
        first != mesh.groups.kind.end())
      isOuter[std::size_t(first - mesh.groups.kind.begin())] = 1;
  markAsked(isOuter, mesh, points, comm);
  std::vector<std::string> sent(std::size_t(comm.size()));
  const NumberedMesh outer = joined(
      {body.part.only([&](int cell) { return isOuter[std::size_t(cell)] != 0; }), around(body.touching, body.part)});
  if (comm.rank() != 0)
    sent[0] = toBytes(outer);
  NumberedMesh all = joinedWith(outer, sent, comm);
  if (comm.rank() == 0)
    body.outer = std::move(all);
}

void addCellsAtContact(BodyPieces& body, const Comm& comm)
{
  if (body.touching.empty())
    return;
  const std::vector<Number> owned = ownedOf(body, comm.rank());
  const std::string bytes = fromRankZero(comm, [&] { return toBytes(around(body.touching, body.outer)); });
  body.part = joined({body.part, numberedMeshFromBytes(bytes)});
  findOwners(body, owned, comm);
}

void gatherAroundOwn(BodyPieces& body, const Comm& comm)
{
  std::vector<std::vector<int>> cells(std::size_t(comm.size()));
  for (int cell = 0; cell < body.part.mesh.numCells(); ++cell)
    for (int v = 0; v <= body.part.mesh.dim; ++v) {
      std::vector<int>& ofOwner = cells[std::size_t(body.owners[std::size_t(body.part.mesh.cell(cell)[v])])];
      if (ofOwner.empty() || ofOwner.back() != cell)
        ofOwner.push_back(cell);
    }
  std::vector<std::string> sent(cells.size());
  for (std::size_t rank = 0; rank < cells.size(); ++rank)
    if (int(rank) != comm.rank() && !cells[rank].empty())
      sent[rank] = toBytes(body.part.with(cells[rank]));
  const std::vector<Number> owned = ownedOf(body, comm.rank());
  body.part = joinedWith(body.part.with(cells[std::size_t(comm.rank())]), sent, comm);
  findOwners(body, owned, comm);
}

void addHalo(BodyPieces& body, const Comm& comm)
{
  const std::vector<Number> owned = ownedOf(body, comm.rank());
  const Mesh& mesh = body.part.mesh;
  std::vector<char> isWanted(std::size_t(mesh.numPoints()), 0);
  for (int cell = 0; cell < mesh.numCells(); ++cell) {
    const int* const first = mesh.cell(cell);
    const int* const last = first + mesh.dim + 1;
    if (std::any_of(first, last, [&](int v) { return body.owners[std::size_t(v)] == comm.rank(); }))
      std::for_each(first, last, [&](int v) { isWanted[std::size_t(v)] = 1; });
  }
  std::vector<std::vector<Number>> wanted(std::size_t(comm.size()));
  for (std::size_t point = 0; point < isWanted.size(); ++point)
    if (isWanted[point] != 0 && body.owners[point] != comm.rank())
      wanted[std::size_t(body.owners[point])].push_back(body.part.points[point]);
  std::vector<std::string> sent;
  for (const std::vector<Number>& asked : askedFor(wanted, comm))
    sent.push_back(asked.empty() ? std::string() : toBytes(around(asked, body.part)));
  body.part = joinedWith(body.part, sent, comm);
  findOwners(body, owned, comm);
}

RefinedNumbers::Whole wholeOf(const BodyPieces& body, const Comm& comm)
{
  const NumberedMesh& part = body.part;
  RefinedNumbers::Whole whole{body.cells, body.counts, {}, part.cells};
  whole.numbers[0] = part.points;
  for (int m = 2; m <= mostVertices(part.mesh.dim, body.halvings); ++m) {
    std::vector<CommonKey> keys;
    for (const std::array<int, 4>& simplex : simplicesOf(part.mesh, m)) {
      keys.push_back({-1, -1, -1, -1});
      for (std::size_t v = 0; v < std::size_t(m); ++v)
        keys.back()[v] = part.points[std::size_t(simplex[v])];
    }
    CommonNumbers common = commonNumbers(keys, body.counts[0], comm);
    NDFRAME_ASSERT(common.count == body.counts[std::size_t(m - 1)], "owners have counted each simplex once");
    whole.numbers[std::size_t(m - 1)] = std::move(common.numbers);
  }
  return whole;
}

} // namespace ndframe
