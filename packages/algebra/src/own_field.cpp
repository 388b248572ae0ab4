#include "ndframe/algebra/own_field.hpp"

#include <algorithm>

namespace ndframe
{

NodalField ownPart(const NodalField& all, const IndexMap& nodes)
{
  if (nodes.isWhole())
    return all;
  Vector values;
  for (int node = 0; node < nodes.numOwned(); ++node) {
    const auto first = all.whole().begin() + std::ptrdiff_t(nodes.global(node)) * all.width();
    values.insert(values.end(), first, first + all.width());
  }
  return {nodes.withoutGhosts(), all.width(), std::move(values)};
}

NodalField onEveryRank(NodalField own, const Comm& comm)
{
  if (comm.size() == 1)
    return own;
  Vector all(std::size_t(own.map().globalSize()) * std::size_t(own.width()), 0.0);
  for (int node = 0; node < own.map().numOwned(); ++node)
    std::copy_n(own.at(node), own.width(), all.begin() + std::ptrdiff_t(own.map().global(node)) * own.width());
  comm.sum(all);
  return {IndexMap::whole(own.map().globalSize()), own.width(), std::move(all)};
}

} // namespace ndframe
