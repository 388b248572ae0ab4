#include "ndframe/algebra/shared_rows.hpp"

#include <algorithm>

#include "exchange.hpp"
#include "ndframe/algebra/ghosts.hpp"

namespace ndframe
{

namespace
{

using Global = IndexMap::Global;

/// Rows as they come from a rank: node, number of columns, columns; their values beside.
struct Packed
{
  std::vector<Global> pattern;
  std::vector<double> values;
};

/// Where a row is among those of a rank.
struct Place
{
  Global node;
  const Packed* from;
  std::size_t pattern, values;

  std::size_t count() const { return std::size_t(from->pattern[pattern + 1]); }
};

std::vector<Place> placesOf(const std::vector<Packed>& packed, std::size_t blockSize)
{
  std::vector<Place> places;
  for (const Packed& rows : packed)
    for (std::size_t p = 0, v = 0; p < rows.pattern.size(); p += 2 + places.back().count()) {
      places.push_back({rows.pattern[p], &rows, p, v});
      v += places.back().count() * blockSize;
    }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.node < b.node; });
  return places;
}

BlockMatrix unpacked(const std::vector<Packed>& packed, int dim, Global numNodes)
{
  const auto blockSize = std::size_t(dim) * std::size_t(dim);
  const std::vector<Place> places = placesOf(packed, blockSize);
  std::vector<Global> owned, columns;
  for (const Place& place : places) {
    owned.push_back(place.node);
    const auto first = place.from->pattern.begin() + std::ptrdiff_t(place.pattern) + 2;
    columns.insert(columns.end(), first, first + std::ptrdiff_t(place.count()));
  }
  BlockMatrix rows{dim, IndexMap(numNodes, std::move(owned), columns), {0}, {}, {}};
  for (const Global column : columns)
    rows.cols.push_back(rows.nodes.local(column));
  for (const Place& place : places) {
    const auto first = place.from->values.begin() + std::ptrdiff_t(place.values);
    rows.values.insert(rows.values.end(), first, first + std::ptrdiff_t(place.count()) * std::ptrdiff_t(blockSize));
    rows.rowPtr.push_back(rows.rowPtr.back() + std::int64_t(place.count()));
  }
  return rows;
}

/// Per rank the rows of K that it needs.
std::vector<std::vector<int>> rowsPerRank(const BlockMatrix& K, const RowReaders& readers, const Comm& comm)
{
  std::vector<int> rows; // per node of others that reads one
  std::vector<Global> nodes;
  for (int r = 0; r < K.numRows(); ++r)
    for (const Global node : readers(r))
      if (!K.nodes.owns(K.nodes.local(node))) {
        rows.push_back(r);
        nodes.push_back(node);
      }
  const std::vector<int> owners = ownersOf(nodes, K.nodes, comm);
  std::vector<std::vector<int>> result(std::size_t(comm.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (auto& wanted = result[std::size_t(owners[i])]; wanted.empty() || wanted.back() != rows[i])
      wanted.push_back(rows[i]);
  return result;
}

} // namespace

BlockMatrix receivedRows(const BlockMatrix& K, const RowReaders& readers, const Comm& comm)
{
  if (comm.size() == 1)
    return unpacked({}, K.dim, K.nodes.globalSize());
  const auto rowsFor = rowsPerRank(K, readers, comm);
  std::vector<std::vector<Global>> patterns(rowsFor.size());
  std::vector<std::vector<double>> values(rowsFor.size());
  const int blockSize = K.dim * K.dim;
  for (std::size_t rank = 0; rank < rowsFor.size(); ++rank)
    for (const int row : rowsFor[rank]) {
      const std::int64_t first = K.rowPtr[std::size_t(row)], last = K.rowPtr[std::size_t(row) + 1];
      patterns[rank].push_back(K.nodes.global(row));
      patterns[rank].push_back(last - first);
      for (std::int64_t b = first; b < last; ++b)
        patterns[rank].push_back(K.nodes.global(K.cols[std::size_t(b)]));
      values[rank].insert(values[rank].end(), K.values.begin() + first * blockSize,
                          K.values.begin() + last * blockSize);
    }
  std::vector<Packed> packed;
  for (std::vector<Global>& pattern : exchanged(patterns, comm))
    packed.push_back({std::move(pattern), {}});
  patterns.clear();
  auto received = exchanged(values, comm);
  for (std::size_t rank = 0; rank < packed.size(); ++rank)
    packed[rank].values = std::move(received[rank]);
  return unpacked(packed, K.dim, K.nodes.globalSize());
}

} // namespace ndframe
