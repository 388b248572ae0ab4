#include "ndframe/mesh/drawn_parts.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "ndframe/mesh/byte_stream.hpp"
#include "ndframe/mesh/mesh_bytes.hpp"

namespace ndframe
{
namespace
{

/// What goes beside the mesh, in one order for both directions.
template <class Stream, class Whole, class Owners, class Halvings>
void walk(Stream& stream, Whole& whole, Owners& owners, Halvings& halvings)
{
  stream.number(halvings);
  stream.number(whole.cells);
  stream.number(whole.counts);
  for (auto& numbers : whole.numbers)
    stream.array(numbers);
  stream.array(whole.ofCells);
  stream.array(owners.order);
  stream.array(owners.ranks);
}

} // namespace

DrawnParts::DrawnParts(const Mesh& drawn, int halvings, const RefinedNumbers& numbers, const DrawnOwners& owners,
                       const std::vector<std::string>& sides, int ranks, bool withHalo)
    : numbers_(numbers), owners_(owners), mesh_(drawn), halvings_(halvings), parts_(drawn), cells_(std::size_t(ranks))
{
  if (withHalo)
    around_.emplace(drawn);
  const std::vector<char> touches = pointsOfSides(drawn, sides);
  for (int cell = 0; cell < drawn.numCells(); ++cell) {
    const int* first = drawn.cell(cell);
    const int* last = first + drawn.dim + 1;
    if (std::any_of(first, last, [&](int point) { return touches[std::size_t(point)] != 0; })) {
      common_.push_back(cell);
      continue;
    }
    for (const int* v = first; v != last; ++v) { // what lies between vertices is one of theirs
      std::vector<int>& cells = cells_[std::size_t(owners.ranks[std::size_t(*v)])];
      if (cells.empty() || cells.back() != cell)
        cells.push_back(cell);
    }
  }
}

std::string DrawnParts::bytesOf(int rank)
{
  const std::vector<int>& own = cells_[std::size_t(rank)];
  std::vector<int> cells;
  std::merge(own.begin(), own.end(), common_.begin(), common_.end(), std::back_inserter(cells));
  if (around_)
    addHalo(rank, cells);
  const std::vector<int> vertices = pointsOfCells(mesh_, cells);
  const Mesh part = parts_.of(cells, vertices);
  DrawnOwners owners;
  for (const int vertex : vertices) {
    owners.order.push_back(owners_.order[std::size_t(vertex)]);
    owners.ranks.push_back(owners_.ranks[std::size_t(vertex)]);
  }
  ByteWriter writer;
  writer.array(toBytes(part));
  const RefinedNumbers::Whole told = numbers_.toldTo(part, vertices, cells);
  walk(writer, told, owners, halvings_);
  return writer.take();
}

/// All cells that have a vertex in common with one that has an own vertex.
void DrawnParts::addHalo(int rank, std::vector<int>& cells) const
{
  std::vector<int> halo;
  for (const int cell : cells) {
    const int* first = mesh_.cell(cell);
    const int* last = first + mesh_.dim + 1;
    if (std::any_of(first, last, [&](int v) { return owners_.ranks[std::size_t(v)] == rank; }))
      for (const int* v = first; v != last; ++v)
        halo.insert(halo.end(), around_->begin(*v), around_->end(*v));
  }
  cells.insert(cells.end(), halo.begin(), halo.end());
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

DrawnPart drawnPartFromBytes(std::string_view bytes)
{
  ByteReader reader(bytes);
  std::string ofMesh;
  reader.array(ofMesh);
  Mesh mesh = meshFromBytes(ofMesh);
  RefinedNumbers::Whole whole;
  DrawnOwners owners;
  int halvings = 0;
  walk(reader, whole, owners, halvings);
  reader.requireEnd();
  RefinedNumbers numbers(mesh, halvings, std::move(whole));
  return {std::move(mesh), std::move(numbers), std::move(owners), halvings};
}

} // namespace ndframe
