#include "ndframe/algebra/from_rank_zero.hpp"

#include <algorithm>
#include <optional>

#include "mpi_comm.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// The text of one rank on every rank; `length`: of the text there.
std::string textOf(const Comm& comm, int rank, const std::string& text, std::size_t length)
{
  Vector characters(length, 0.0);
  if (comm.rank() == rank)
    std::copy(text.begin(), text.end(), characters.begin());
  comm.sum(characters);
  return {characters.begin(), characters.end()};
}

constexpr int handedOutTag = 319;

/// Calls `pass(first, length)` for pieces that MPI can count.
template <class Bytes, class Pass>
void inMessages(Bytes& bytes, const Pass& pass)
{
  constexpr std::size_t longest = std::size_t(1) << 30U;
  for (std::size_t first = 0; first < bytes.size(); first += longest)
    pass(bytes.data() + first, int(std::min(longest, bytes.size() - first)));
}

} // namespace

std::string handedOut(const Comm& comm, const std::function<std::string(int rank)>& make)
{
  if (comm.rank() == 0) {
    for (int rank = 1; rank < comm.size(); ++rank) {
      const std::string bytes = make(rank);
      const auto length = std::int64_t(bytes.size());
      MPI_Send(&length, 1, MPI_INT64_T, rank, handedOutTag, mpiComm(comm));
      inMessages(bytes, [&](const char* first, int count) {
        MPI_Send(first, count, MPI_CHAR, rank, handedOutTag, mpiComm(comm));
      });
    }
    return make(0);
  }
  std::int64_t length = 0;
  MPI_Recv(&length, 1, MPI_INT64_T, 0, handedOutTag, mpiComm(comm), MPI_STATUS_IGNORE);
  std::string bytes(std::size_t(length), '\0');
  inMessages(bytes, [&](char* first, int count) {
    MPI_Recv(first, count, MPI_CHAR, 0, handedOutTag, mpiComm(comm), MPI_STATUS_IGNORE);
  });
  return bytes;
}

std::string fromRankZero(const Comm& comm, const std::function<std::string()>& make)
{
  std::string bytes; // stays empty when there are none to be had
  std::optional<InputError> failure;
  if (comm.rank() == 0) {
    try {
      bytes = make();
    } catch (const InputError& error) {
      failure = error;
    }
  }
  comm.broadcast(bytes);
  if (bytes.empty())
    throw failure ? *failure : InputError("rank 0 could not do its part"); // only rank 0 speaks
  return bytes;
}

void onEveryRank(const Comm& comm, const std::function<void()>& work)
{
  if (comm.size() == 1)
    return work();
  std::string failure;
  try {
    work();
  } catch (const InputError& error) {
    failure = error.what();
  }
  Vector lengths(std::size_t(comm.size()), 0.0);
  lengths[std::size_t(comm.rank())] = double(failure.size());
  comm.sum(lengths);
  const auto failed = std::find_if(lengths.begin(), lengths.end(), [](double length) { return length > 0.0; });
  if (failed != lengths.end())
    throw InputError(textOf(comm, int(failed - lengths.begin()), failure, std::size_t(*failed)));
}

} // namespace ndframe
