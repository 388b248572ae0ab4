#include "ndframe/assembly/body_share.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

using Global = BodyShare::Global;

/// The place of a number among ascending ones, -1: it is none of them.
int placeOf(const std::vector<Global>& ascending, Global number)
{
  const auto found = std::lower_bound(ascending.begin(), ascending.end(), number);
  return found != ascending.end() && *found == number ? int(found - ascending.begin()) : -1;
}

} // namespace

BodyShare::BodyShare(Global numNodes, Global numCells, std::vector<Global> numbers, std::vector<int> owners,
                     int numOwnCells, const Comm& comm)
    : numNodes_(numNodes), numCells_(numCells), numbers_(std::move(numbers)), owners_(std::move(owners)),
      numOwnCells_(numOwnCells), rank_(comm.rank()),
      shared_(sharedByOwners(
          numbers_, owners_, [this](Global number) { return placeOf(numbers_, number); }, comm))
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
