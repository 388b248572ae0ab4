#include "ndframe/algebra/shared_rows.hpp"

#include <algorithm>
#include <numeric>

#include "mpi_comm.hpp"

namespace ndframe
{

namespace
{

template <class Value>
MPI_Datatype mpiType();
template <>
MPI_Datatype mpiType<int>()
{
  return MPI_INT;
}
template <>
MPI_Datatype mpiType<double>()
{
  return MPI_DOUBLE;
}

/// Every rank's piece for this one, one after the other.
template <class Value>
std::vector<Value> received(const std::vector<std::vector<Value>>& pieces, MPI_Comm comm)
{
  const std::size_t ranks = pieces.size();
  std::vector<int> sent(ranks), taken(ranks), sentAt(ranks + 1, 0), takenAt(ranks + 1, 0);
  std::vector<Value> all;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    sent[rank] = int(pieces[rank].size());
    all.insert(all.end(), pieces[rank].begin(), pieces[rank].end());
  }
  MPI_Alltoall(sent.data(), 1, MPI_INT, taken.data(), 1, MPI_INT, comm);
  std::partial_sum(sent.begin(), sent.end(), sentAt.begin() + 1);
  std::partial_sum(taken.begin(), taken.end(), takenAt.begin() + 1);
  std::vector<Value> result(std::size_t(takenAt.back()));
  MPI_Alltoallv(all.data(), sent.data(), sentAt.data(), mpiType<Value>(), result.data(), taken.data(), takenAt.data(),
                mpiType<Value>(), comm);
  return result;
}

/// Rows as they come: node, number of columns, columns; their values beside.
BlockMatrix unpacked(const std::vector<int>& pattern, const std::vector<double>& values, int dim, int numNodes)
{
  struct Place
  {
    int node;
    std::size_t pattern, values;
  };
  std::vector<Place> places;
  const auto blockSize = std::size_t(dim) * std::size_t(dim);
  for (std::size_t p = 0, v = 0; p < pattern.size();
       v += std::size_t(pattern[p + 1]) * blockSize, p += 2 + std::size_t(pattern[p + 1]))
    places.push_back({pattern[p], p, v});
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.node < b.node; });
  std::vector<int> owned, columns;
  std::vector<double> blocksOfRows;
  std::vector<std::int64_t> rowPtr{0};
  for (const Place& place : places) {
    const auto count = std::ptrdiff_t(pattern[place.pattern + 1]);
    const auto cols = pattern.begin() + std::ptrdiff_t(place.pattern) + 2;
    const auto blocks = values.begin() + std::ptrdiff_t(place.values);
    owned.push_back(place.node);
    columns.insert(columns.end(), cols, cols + count);
    blocksOfRows.insert(blocksOfRows.end(), blocks, blocks + count * std::ptrdiff_t(blockSize));
    rowPtr.push_back(std::int64_t(columns.size()));
  }
  return withOwnColumns(dim, numNodes, owned, std::move(rowPtr), std::move(columns), std::move(blocksOfRows));
}

/// Per rank the places in K.rows that it needs.
std::vector<std::vector<int>> rowsPerRank(const BlockMatrix& K, const RowReaders& readers, const Comm& comm)
{
  Vector owner(std::size_t(K.numNodes()), 0.0);
  for (int r = 0; r < K.numRows(); ++r)
    owner[std::size_t(K.rowNode(r))] = comm.rank();
  comm.sum(owner);
  std::vector<std::vector<int>> result(std::size_t(comm.size()));
  for (int r = 0; r < K.numRows(); ++r)
    for (const int node : readers(K.rowNode(r))) {
      const int rank = int(owner[std::size_t(node)]);
      auto& rows = result[std::size_t(rank)];
      if (rank != comm.rank() && (rows.empty() || rows.back() != r))
        rows.push_back(r);
    }
  return result;
}

} // namespace

BlockMatrix receivedRows(const BlockMatrix& K, const RowReaders& readers, const Comm& comm)
{
  if (comm.size() == 1)
    return unpacked({}, {}, K.dim, K.numNodes());
  const auto rowsFor = rowsPerRank(K, readers, comm);
  std::vector<std::vector<int>> patterns(rowsFor.size());
  std::vector<std::vector<double>> values(rowsFor.size());
  const int blockSize = K.dim * K.dim;
  for (std::size_t rank = 0; rank < rowsFor.size(); ++rank)
    for (const int row : rowsFor[rank]) {
      const std::int64_t first = K.rowPtr[std::size_t(row)], last = K.rowPtr[std::size_t(row) + 1];
      patterns[rank].push_back(K.rowNode(row));
      patterns[rank].push_back(int(last - first));
      for (std::int64_t b = first; b < last; ++b)
        patterns[rank].push_back(K.colNode(b));
      values[rank].insert(values[rank].end(), K.values.begin() + first * blockSize,
                          K.values.begin() + last * blockSize);
    }
  const std::vector<int> pattern = received(patterns, mpiComm(comm));
  return unpacked(pattern, received(values, mpiComm(comm)), K.dim, K.numNodes());
}

} // namespace ndframe
