#include "ndframe/assembly/body_share.hpp"

#include <algorithm>

#include "ndframe/base/ascending.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
BodyShare::BodyShare(Things nodes, Things cells, const Comm& comm)
    : nodes_(std::move(nodes)), cells_(std::move(cells)), rank_(comm.rank()),
      numOwnCells_(int(std::count(cells_.owners.begin(), cells_.owners.end(), rank_))),
      shared_(sharedByOwners(
          nodes_.numbers, nodes_.owners, [this](Global number) { return placeOf(nodes_.numbers, number); }, comm))
{
  NDFRAME_ASSERT(std::is_sorted(nodes_.numbers.begin(), nodes_.numbers.end()) &&
                     nodes_.numbers.size() == nodes_.owners.size(),
                 "nodes ascend, and each has an owner");
  NDFRAME_ASSERT(std::count(cells_.owners.begin(), cells_.owners.begin() + numOwnCells_, rank_) == numOwnCells_,
                 "own cells come first");
}

std::vector<int> BodyShare::ownNodes() const
{
  std::vector<int> nodes;
  for (int node = 0; node < int(nodes_.owners.size()); ++node)
    if (owns(node))
      nodes.push_back(node);
  return nodes;
}

void BodyShare::fetch(Vector& values, int width) const
{
  const auto count = std::size_t(width);
  NDFRAME_ASSERT(values.size() == nodes_.numbers.size() * count, "there are values at all nodes of the part");
  shared_.fetch([count](int node) { return SharedValues::Place{std::size_t(node) * count, count}; }, values);
}

void BodyShare::annulOthers(Vector& values, int width) const
{
  for (std::size_t node = 0; node < nodes_.owners.size(); ++node)
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
  Vector values(nodes_.numbers.size() * std::size_t(width), 0.0);
  auto next = own.begin();
  for (const int node : ownNodes()) {
    std::copy_n(next, width, values.begin() + std::ptrdiff_t(node) * width);
    next += width;
  }
  fetch(values, width);
  return values;
}

} // namespace ndframe
