#include "ndframe/algebra/shared_values.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "exchange.hpp"
#include "ndframe/algebra/dense.hpp"
#include "ndframe/algebra/exchanged_values.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

std::size_t countOf(const std::vector<int>& things, const SharedValues::Places& places)
{
  std::size_t count = 0;
  for (const int thing : things)
    count += places(thing).count;
  return count;
}

Vector packed(const std::vector<int>& things, const SharedValues::Places& places, const Vector& values)
{
  Vector message;
  message.reserve(countOf(things, places));
  for (const int thing : things) {
    const auto [first, count] = places(thing);
    const auto begin = values.begin() + std::ptrdiff_t(first);
    message.insert(message.end(), begin, begin + std::ptrdiff_t(count));
  }
  return message;
}

/// take(value, message entry) for all values of these things.
template <class Take>
void unpack(const std::vector<int>& things, const SharedValues::Places& places, const Vector& message, Vector& values,
            const Take& take)
{
  auto from = message.begin();
  for (const int thing : things) {
    const auto [first, count] = places(thing);
    for (std::size_t i = first; i < first + count; ++i)
      take(values[i], *from++);
  }
}

} // namespace

/// Per neighbour, what it sent.
std::vector<Vector> SharedValues::sent(List from, List to, const Places& places, const Vector& values) const
{
  constexpr int tag = 318;
  std::vector<Vector> out, in;
  std::vector<MPI_Request> requests;
  if (neighbours_.empty())
    return in;
  for (const SharedWith& other : neighbours_) {
    in.emplace_back(countOf(other.*to, places));
    out.push_back(packed(other.*from, places, values));
  }
  for (std::size_t n = 0; n < neighbours_.size(); ++n) {
    if (!in[n].empty())
      MPI_Irecv(in[n].data(), messageLength(in[n].size()), MPI_DOUBLE, neighbours_[n].rank, tag, mpiComm(comm_),
                &requests.emplace_back());
    if (out[n].empty())
      continue;
    MPI_Isend(out[n].data(), messageLength(out[n].size()), MPI_DOUBLE, neighbours_[n].rank, tag, mpiComm(comm_),
              &requests.emplace_back());
    ++messages_;
    bytes_ += std::int64_t(out[n].size()) * std::int64_t(sizeof(double));
  }
  MPI_Waitall(int(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return in;
}

void SharedValues::fetch(const Places& places, Vector& values) const
{
  const std::vector<Vector> found = sent(&SharedWith::lent, &SharedWith::borrowed, places, values);
  for (std::size_t n = 0; n < found.size(); ++n)
    unpack(neighbours_[n].borrowed, places, found[n], values, [](double& value, double theirs) { value = theirs; });
}

void SharedValues::add(const Places& places, Vector& values) const
{
  const std::vector<Vector> found = sent(&SharedWith::borrowed, &SharedWith::lent, places, values);
  for (std::size_t n = 0; n < found.size(); ++n) {
    unpack(neighbours_[n].lent, places, found[n], values, [](double& value, double theirs) { value += theirs; });
    for (const int thing : neighbours_[n].borrowed) {
      const auto begin = values.begin() + std::ptrdiff_t(places(thing).first);
      std::fill(begin, begin + std::ptrdiff_t(places(thing).count), 0.0);
    }
  }
}

std::vector<std::vector<std::int64_t>> askedFor(const std::vector<std::vector<std::int64_t>>& wanted, const Comm& comm)
{
  return comm.size() == 1 ? std::vector<std::vector<std::int64_t>>{{}} : exchanged(wanted, comm);
}

SharedValues sharedByOwners(const std::vector<std::int64_t>& numbers, const std::vector<int>& owners,
                            const std::function<int(std::int64_t number)>& local, const Comm& comm)
{
  std::vector<std::vector<std::int64_t>> wanted(std::size_t(comm.size()));
  std::vector<SharedWith> all(wanted.size()), neighbours;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (owners[i] != comm.rank()) {
      wanted[std::size_t(owners[i])].push_back(numbers[i]);
      all[std::size_t(owners[i])].borrowed.push_back(int(i));
    }
  const auto asked = askedFor(wanted, comm);
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    all[rank].rank = int(rank);
    for (const std::int64_t number : asked[rank]) {
      all[rank].lent.push_back(local(number));
      NDFRAME_ASSERT(all[rank].lent.back() >= 0, "the owner of a thing holds it");
    }
    if (!all[rank].lent.empty() || !all[rank].borrowed.empty())
      neighbours.push_back(std::move(all[rank]));
  }
  return {std::move(neighbours), comm};
}

void takeLargest(Vector& values, const Comm& comm)
{
  reduceAll(values.data(), values.size(), MPI_MAX, comm);
}

void takeExtremes(Vector& smallest, Vector& largest, const Comm& comm)
{
  Vector all = largest;
  std::transform(smallest.begin(), smallest.end(), std::back_inserter(all), std::negate<>());
  takeLargest(all, comm);
  const auto middle = all.begin() + std::ptrdiff_t(largest.size());
  std::copy(all.begin(), middle, largest.begin());
  std::transform(middle, all.end(), smallest.begin(), std::negate<>());
}

Vector gatheredFrom(const Vector& own, const Comm& comm)
{
  if (comm.size() == 1)
    return own;
  std::vector<int> counts(std::size_t(comm.size()), 0), first(counts);
  const int count = messageLength(own.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, mpiComm(comm));
  std::size_t total = 0;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    first[rank] = messageLength(total);
    total += std::size_t(counts[rank]);
  }
  tellReduction(counts.size() * sizeof(int));
  Vector all(total);
  MPI_Allgatherv(own.data(), count, MPI_DOUBLE, all.data(), counts.data(), first.data(), MPI_DOUBLE, mpiComm(comm));
  tellReduction(total * sizeof(double));
  return all;
}

std::array<std::int64_t, 2> beforeAndAll(std::int64_t own, const Comm& comm)
{
  const Vector counts = gatheredFrom({double(own)}, comm);
  const auto sum = [&](auto last) { return std::int64_t(std::accumulate(counts.begin(), last, 0.0)); };
  return {sum(counts.begin() + comm.rank()), sum(counts.end())};
}

std::string firstText(const std::string& own, const Comm& comm)
{
  if (comm.size() == 1)
    return own;
  const Vector characters(own.begin(), own.end());
  std::vector<Vector> texts(std::size_t(comm.size()), characters);
  for (const Vector& text : exchangedValues(texts, comm))
    if (!text.empty())
      return {text.begin(), text.end()};
  return {};
}

void definiteOnEveryRank(const Comm& comm, const std::function<void()>& work)
{
  constexpr double none = -2.0; // -1 is a row that is not known
  Vector row{none};
  try {
    work();
  } catch (const NotPositiveDefinite& failure) {
    if (comm.size() == 1)
      throw;
    row[0] = double(failure.row);
  }
  takeLargest(row, comm);
  if (row[0] > none)
    throw NotPositiveDefinite(int(row[0]));
}

} // namespace ndframe
