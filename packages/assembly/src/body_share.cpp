#include "ndframe/assembly/body_share.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

using Global = BodyShare::Global;

/// Numbers of 64 bits as two of 32 each, and back.
std::vector<int> halves(const std::vector<Global>& numbers)
{
  std::vector<int> result;
  for (const Global number : numbers)
    result.insert(result.end(), {int(number >> 31), int(number & 0x7fffffff)});
  return result;
}

std::vector<Global> joined(const std::vector<int>& halves)
{
  std::vector<Global> result;
  for (std::size_t i = 0; i + 1 < halves.size(); i += 2)
    result.push_back(Global(halves[i]) << 31 | Global(halves[i + 1]));
  return result;
}

/// Whom this rank shares nodes with: those that it has of others, and those of its own that others have.
std::vector<SharedWith> neighbours(const std::vector<Global>& numbers, const std::vector<int>& owners, const Comm& comm)
{
  const auto ranks = std::size_t(comm.size());
  std::vector<std::vector<int>> borrowed(ranks), wanted;
  for (std::size_t node = 0; node < owners.size(); ++node)
    if (owners[node] != comm.rank())
      borrowed[std::size_t(owners[node])].push_back(int(node));
  for (const auto& nodes : borrowed) {
    std::vector<Global> names;
    for (const int node : nodes)
      names.push_back(numbers[std::size_t(node)]);
    wanted.push_back(halves(names));
  }
  const auto asked = askedFor(wanted, comm);
  std::vector<SharedWith> result;
  for (std::size_t rank = 0; rank < ranks; ++rank) {
    SharedWith with{int(rank), {}, std::move(borrowed[rank])};
    for (const Global number : joined(asked[rank])) {
      const auto found = std::lower_bound(numbers.begin(), numbers.end(), number);
      NDFRAME_ASSERT(found != numbers.end() && *found == number, "the owner of a node has it");
      with.lent.push_back(int(found - numbers.begin()));
    }
    if (!with.lent.empty() || !with.borrowed.empty())
      result.push_back(std::move(with));
  }
  return result;
}

} // namespace

BodyShare::BodyShare(Global numNodes, Global numCells, std::vector<Global> numbers, std::vector<int> owners,
                     int numOwnCells, const Comm& comm)
    : numNodes_(numNodes), numCells_(numCells), numbers_(std::move(numbers)), owners_(std::move(owners)),
      numOwnCells_(numOwnCells), rank_(comm.rank()), shared_(neighbours(numbers_, owners_, comm), comm)
{
  NDFRAME_ASSERT(std::is_sorted(numbers_.begin(), numbers_.end()) && numbers_.size() == owners_.size(),
                 "nodes ascend, and each has an owner");
}

std::vector<int> BodyShare::ownNodes() const
{
  std::vector<int> nodes;
  for (int node = 0; node < int(owners_.size()); ++node)
    if (owns(node))
      nodes.push_back(node);
  return nodes;
}

void BodyShare::fetch(Vector& values, int width) const
{
  const auto count = std::size_t(width);
  NDFRAME_ASSERT(values.size() == numbers_.size() * count, "there are values at all nodes of the part");
  shared_.fetch([count](int node) { return SharedValues::Place{std::size_t(node) * count, count}; }, values);
}

void BodyShare::annulOthers(Vector& values, int width) const
{
  for (std::size_t node = 0; node < owners_.size(); ++node)
    if (!owns(int(node)))
      std::fill_n(values.begin() + std::ptrdiff_t(node) * width, width, 0.0);
}

Vector BodyShare::own(const Vector& values, int width) const
{
  Vector result;
  for (const int node : ownNodes()) {
    const auto first = values.begin() + std::ptrdiff_t(node) * width;
    result.insert(result.end(), first, first + width);
  }
  return result;
}

Vector BodyShare::spread(const Vector& own, int width) const
{
  Vector values(numbers_.size() * std::size_t(width), 0.0);
  auto next = own.begin();
  for (const int node : ownNodes()) {
    std::copy_n(next, width, values.begin() + std::ptrdiff_t(node) * width);
    next += width;
  }
  fetch(values, width);
  return values;
}

} // namespace ndframe
