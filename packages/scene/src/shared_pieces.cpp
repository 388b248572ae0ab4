#include "piece_parts.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "ndframe/algebra/common_numbers.hpp"
#include "ndframe/algebra/exchanged_values.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/base/ascending.hpp"
#include "ndframe/base/joined_numbers.hpp"
#include "ndframe/mesh/boundary.hpp"

namespace ndframe
{
namespace
{

using Number = BodyPieces::Number;

bool isOnAll(bool isSo, const Comm& comm)
{
  return comm.sum(std::int64_t(isSo)) == comm.size();
}

/// A solid that can be numbered, and of which there is nothing to be noted that is not of a part alone.
bool isPlain(const NumberedMesh& part)
{
  const auto isNegative = [](Number number) { return number < 0; };
  return part.mesh.dim == 3 && part.mesh.notes.empty() &&
         std::none_of(part.points.begin(), part.points.end(), isNegative) &&
         std::none_of(part.cells.begin(), part.cells.end(), isNegative);
}

using Names = std::vector<std::string>;

/// The lists of names, none of them empty, that any rank has, each once, on all ranks.
std::vector<Names> listsOfAll(const std::vector<Names>& lists, const Comm& comm)
{
  std::string own; // an empty name ends a list
  for (const Names& list : lists) {
    for (const std::string& name : list)
      own += name + '\0';
    own += '\0';
  }
  std::vector<Names> all;
  Names list;
  for (const std::string& text : exchangedBytes(Names(std::size_t(comm.size()), own), comm))
    for (std::size_t first = 0, last = 0; first < text.size(); first = last + 1) {
      last = text.find('\0', first);
      if (last > first) {
        list.push_back(text.substr(first, last - first));
        continue;
      }
      if (std::find(all.begin(), all.end(), list) == all.end())
        all.push_back(list);
      list.clear();
    }
  return all;
}

/// Gives the mesh of each rank the sides of all.
void takeAllSides(Mesh& mesh, const Comm& comm)
{
  std::vector<Names> names;
  for (const Side& side : mesh.sides)
    names.push_back({side.name});
  std::vector<Side> all;
  for (const Names& name : listsOfAll(names, comm)) {
    const Side* const known = mesh.findSide(name.front());
    all.push_back(known != nullptr ? *known : Side{name.front(), {}});
  }
  mesh.sides = std::move(all);
}

/// Gives the mesh of each rank the kinds of cells of all.
void takeAllKinds(Mesh& mesh, const Comm& comm)
{
  CellGroups groups;
  groups.names = listsOfAll(mesh.groups.names, comm);
  for (const int kind : mesh.groups.kind)
    groups.kind.push_back(groups.findOrAdd(mesh.groups.names[std::size_t(kind)]));
  mesh.groups = std::move(groups);
}

/// Leaves out sides that have no facets anywhere; whether there were none.
bool dropEmptySides(std::vector<Side>& sides, const Comm& comm)
{
  Vector counts;
  for (const Side& side : sides)
    counts.push_back(double(side.facets.size()));
  comm.sum(counts);
  std::vector<Side> left;
  for (std::size_t s = 0; s < sides.size(); ++s)
    if (counts[s] > 0.0)
      left.push_back(std::move(sides[s]));
  sides = std::move(left);
  return sides.size() == counts.size();
}

void dropRoundOffOfAll(std::vector<double>& coordinates, const Comm& comm)
{
  Vector low{INFINITY}, high{-INFINITY};
  for (const double coordinate : coordinates) {
    low[0] = std::min(low[0], coordinate);
    high[0] = std::max(high[0], coordinate);
  }
  takeExtremes(low, high, comm);
  dropRoundOff(coordinates, high[0] - low[0]);
}

/// Numbers of the whole, from 0 on, instead of those of the files.
CommonNumbers renumber(std::vector<Number>& ids, const Comm& comm)
{
  Vector largest{0.0};
  std::vector<CommonKey> keys;
  for (const Number id : ids) {
    keys.push_back({id, 0, 0, 0});
    largest[0] = std::max(largest[0], double(id));
  }
  takeLargest(largest, comm);
  CommonNumbers common = commonNumbers(keys, Number(largest[0]) + 1, comm);
  ids = common.numbers;
  return common;
}

/// Whether all ranks have the same coordinates of what they share.
bool agree(const BodyPieces& body, const Comm& comm)
{
  const Mesh& mesh = body.part.mesh;
  Vector values = mesh.points;
  const auto local = [&](Number number) { return placeOf(body.part.points, number); };
  const auto width = std::size_t(mesh.dim);
  sharedByOwners(body.part.points, body.owners, local, comm)
      .fetch(
          [width](int point) {
            return SharedValues::Place{std::size_t(point) * width, width};
          },
          values);
  return isOnAll(values == mesh.points, comm);
}

/// Per cell the owner of its lowest vertex, who is the cell's.
std::vector<int> cellOwners(const BodyPieces& body)
{
  const Mesh& mesh = body.part.mesh;
  std::vector<int> owners;
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    owners.push_back(body.owners[std::size_t(*std::min_element(mesh.cell(cell), mesh.cell(cell) + mesh.dim + 1))]);
  return owners;
}

/// What is counted and summed up by the owners of lowest vertices.
void measure(BodyPieces& body, const Comm& comm)
{
  const Mesh& mesh = body.part.mesh;
  Vector sums(5, 0.0), ofKinds(mesh.groups.names.size(), 0.0); // the volume; of so many vertices from two on, simplices
  const std::vector<int> owners = cellOwners(body);
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    if (owners[std::size_t(cell)] == comm.rank()) {
      sums[0] += cellMeasure(mesh, cell);
      if (!ofKinds.empty())
        ofKinds[std::size_t(mesh.groups.kind[std::size_t(cell)])] += 1.0;
    }
  for (int m = 2; m <= mostVertices(mesh.dim, body.halvings); ++m)
    for (const std::array<int, 4>& simplex : simplicesOf(mesh, m))
      sums[std::size_t(m)] += body.owners[std::size_t(simplex[0])] == comm.rank() ? 1.0 : 0.0;
  comm.sum(sums);
  comm.sum(ofKinds);
  body.cellsOfKinds = {ofKinds.begin(), ofKinds.end()};
  body.measure = sums[0];
  for (int m = 2; m <= mesh.dim + 1; ++m)
    body.counts[std::size_t(m - 1)] = Number(sums[std::size_t(m)]);
}

/// Whether all cells are joined by facets.
bool isOnePart(const BodyPieces& body, const Comm& comm)
{
  int count = 0;
  const std::vector<int> parts = connectedParts(body.part.mesh, count);
  const auto [first, all] = beforeAndAll(count, comm);
  Vector numbers;
  for (const int part : parts)
    numbers.push_back(double(first + part));
  const Vector mine = numbers;
  sharedByOwners(
      body.part.cells, cellOwners(body), [&](Number cell) { return placeOf(body.part.cells, cell); }, comm)
      .fetch(
          [](int cell) {
            return SharedValues::Place{std::size_t(cell), 1};
          },
          numbers);
  std::set<std::pair<double, double>> same;
  for (std::size_t cell = 0; cell < mine.size(); ++cell)
    same.insert({mine[cell], numbers[cell]});
  Vector pairs;
  for (const auto& [a, b] : same)
    pairs.insert(pairs.end(), {a, b});
  pairs = gatheredFrom(pairs, comm);
  JoinedNumbers joinedParts{int(all)};
  for (std::size_t i = 0; i < pairs.size(); i += 2)
    joinedParts.join(int(pairs[i]), int(pairs[i + 1]));
  std::move(joinedParts).numbered(count);
  return count == 1;
}

} // namespace

std::optional<BodyPieces> sharedPieces(std::optional<NumberedMesh> own, const PieceSettings& settings, const Comm& comm)
{
  if (!isOnAll(own && isPlain(*own), comm))
    return std::nullopt;
  BodyPieces body;
  body.part = std::move(*own);
  body.halvings = settings.halvings;
  Mesh& mesh = body.part.mesh;
  takeAllSides(mesh, comm);
  if (!dropEmptySides(mesh.sides, comm) && !settings.choosesBlocks) // a note says so where they are read as a whole
    return std::nullopt;
  takeAllKinds(mesh, comm);
  const std::vector<std::string>& contactSides = settings.contactSides;
  const bool areThere = std::all_of(contactSides.begin(), contactSides.end(),
                                    [&](const std::string& side) { return mesh.findSide(side) != nullptr; });
  if (!areThere)
    return std::nullopt;
  dropRoundOffOfAll(mesh.points, comm);
  body.cells = renumber(body.part.cells, comm).count;
  CommonNumbers points = renumber(body.part.points, comm);
  body.counts[0] = points.count;
  body.owners = std::move(points.owners);
  if (comm.sum(std::int64_t(body.part.cells.size())) != body.cells || !agree(body, comm))
    return std::nullopt;
  gatherAroundOwn(body, comm);
  if (!isOnAll(mesh.numCells() == 0 || checkMesh(mesh).empty(), comm) || !isOnePart(body, comm))
    return std::nullopt;
  measure(body, comm);
  findTouching(body, contactSides, comm);
  gatherOuter(body, settings.points, comm);
  return body;
}

} // namespace ndframe
