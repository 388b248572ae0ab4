#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// What a rank shares with another one, by its own numbers. Both list the same things in the same order.
struct SharedWith
{
  int rank = 0;
  std::vector<int> lent;     ///< that this rank owns and the other one holds, too
  std::vector<int> borrowed; ///< that the other one owns
};

/// Values of things (cells, unknowns of faces) that several ranks hold and one of them owns: ranks send to those that
/// they share something with, and to no others. Counts what it sends. Functions that send are collective among them.
class SharedValues
{
public:
  /// Where the values of a thing are among all values: `count` from `first` on. Owner and borrower have the same count.
  struct Place
  {
    std::size_t first, count;
  };
  using Places = std::function<Place(int)>;

  SharedValues() = default; ///< nothing is shared
  /// neighbours: by ascending ranks.
  SharedValues(std::vector<SharedWith> neighbours, const Comm& comm) : neighbours_(std::move(neighbours)), comm_(comm)
  {}

  /// Borrowed values become those of their owners.
  void fetch(const Places& places, Vector& values) const;
  /// Owned values become the sums of all ranks', in the order of the ranks that borrow; borrowed ones become zero.
  void add(const Places& places, Vector& values) const;

  std::int64_t messages() const { return messages_; } ///< that this rank has sent
  std::int64_t bytes() const { return bytes_; }       ///< in these messages

private:
  using List = std::vector<int> SharedWith::*;
  std::vector<Vector> sent(List from, List to, const Places& places, const Vector& values) const;

  std::vector<SharedWith> neighbours_;
  Comm comm_ = Comm::single();
  mutable std::int64_t messages_ = 0, bytes_ = 0;
};

/// wanted: per rank the numbers that this rank wants from it. Returns per rank what it wants from this one, in its
/// order. Collective.
std::vector<std::vector<std::int64_t>> askedFor(const std::vector<std::vector<std::int64_t>>& wanted, const Comm& comm);

/// Values of things of which each rank holds some. numbers: per thing that this rank holds one that all ranks know;
/// owners: per thing the rank that owns it, and holds it; local: this rank's place of a number. Collective.
SharedValues sharedByOwners(const std::vector<std::int64_t>& numbers, const std::vector<int>& owners,
                            const std::function<int(std::int64_t number)>& local, const Comm& comm);

/// Element-wise the largest value of all ranks, on every rank. Collective.
void takeLargest(Vector& values, const Comm& comm);
/// The same with the smallest values of the first ones. Collective.
void takeExtremes(Vector& smallest, Vector& largest, const Comm& comm);
/// All ranks' values one after the other, on every rank; ranks may have different numbers of them. Collective.
Vector gatheredFrom(const Vector& own, const Comm& comm);

/// How much the ranks before this one have, and how much all have. own: what this one has. Collective.
std::array<std::int64_t, 2> beforeAndAll(std::int64_t own, const Comm& comm);

/// The text of the first rank that has one, on every rank. Collective.
std::string firstText(const std::string& own, const Comm& comm);

/// Calls `work`, which sends nothing. NotPositiveDefinite of any rank is one on every rank: none waits for another that
/// has given up. Collective.
void definiteOnEveryRank(const Comm& comm, const std::function<void()>& work);

} // namespace ndframe
