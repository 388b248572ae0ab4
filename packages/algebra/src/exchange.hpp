#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "mpi_comm.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

template <class Value>
MPI_Datatype mpiType();
template <>
inline MPI_Datatype mpiType<char>()
{
  return MPI_CHAR;
}
template <>
inline MPI_Datatype mpiType<int>()
{
  return MPI_INT;
}
template <>
inline MPI_Datatype mpiType<std::int64_t>()
{
  return MPI_INT64_T;
}
template <>
inline MPI_Datatype mpiType<double>()
{
  return MPI_DOUBLE;
}

/// A length as MPI takes it.
inline int messageLength(std::size_t count)
{
  NDFRAME_ASSERT(count <= std::size_t(INT32_MAX), "a message is too long for MPI");
  return int(count);
}

/// Values of all ranks become, on every rank, what the operation makes of them. Collective.
template <class Value>
void reduceAll(Value* values, std::size_t count, MPI_Op operation, const Comm& comm)
{
  if (comm.size() == 1)
    return;
  MPI_Allreduce(MPI_IN_PLACE, values, messageLength(count), mpiType<Value>(), operation, mpiComm(comm));
  tellReduction(count * sizeof(Value));
}

/// Per rank the piece that it has for this one. pieces: per rank, what it gets from this one. Collective.
template <class Value>
std::vector<std::vector<Value>> exchanged(const std::vector<std::vector<Value>>& pieces, const Comm& comm)
{
  if (comm.size() == 1)
    return pieces;
  NDFRAME_ASSERT(int(pieces.size()) == comm.size(), "a list for every rank");
  std::vector<int> sent, taken(pieces.size()), sentAt, takenAt;
  std::vector<Value> all;
  for (const std::vector<Value>& piece : pieces) {
    sentAt.push_back(messageLength(all.size()));
    sent.push_back(messageLength(piece.size()));
    all.insert(all.end(), piece.begin(), piece.end());
  }
  MPI_Alltoall(sent.data(), 1, MPI_INT, taken.data(), 1, MPI_INT, mpiComm(comm));
  std::size_t total = 0;
  for (const int count : taken) {
    takenAt.push_back(messageLength(total));
    total += std::size_t(count);
  }
  std::vector<Value> in(total);
  MPI_Alltoallv(all.data(), sent.data(), sentAt.data(), mpiType<Value>(), in.data(), taken.data(), takenAt.data(),
                mpiType<Value>(), mpiComm(comm));
  std::vector<std::vector<Value>> result;
  for (std::size_t rank = 0; rank < pieces.size(); ++rank)
    result.emplace_back(in.begin() + takenAt[rank], in.begin() + takenAt[rank] + taken[rank]);
  return result;
}

/// What ranks have sent, one value after the other of each.
template <class Value>
class InOrder
{
public:
  explicit InOrder(std::vector<std::vector<Value>> sent) : sent_(std::move(sent)), next_(sent_.size(), 0) {}
  const Value& next(std::size_t rank) { return sent_[rank][next_[rank]++]; }

private:
  std::vector<std::vector<Value>> sent_; ///< per rank
  std::vector<std::size_t> next_;
};

} // namespace ndframe
