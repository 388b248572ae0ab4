#include "ndframe/algebra/ghosts.hpp"

#include <algorithm>
#include <utility>

#include "exchange.hpp"

namespace ndframe
{

namespace
{

using Global = IndexMap::Global;

/// A rank's part of the list of owners: numbers and who owns them, ascending.
std::vector<std::pair<Global, int>> ownersOfBlock(const IndexMap& map, Global blockSize, const Comm& comm)
{
  std::vector<std::vector<Global>> told(std::size_t(comm.size()));
  for (int own = 0; own < map.numOwned(); ++own)
    told[std::size_t(map.global(own) / blockSize)].push_back(map.global(own));
  const auto known = exchanged(told, comm);
  std::vector<std::pair<Global, int>> owners;
  for (std::size_t rank = 0; rank < known.size(); ++rank)
    for (const Global number : known[rank])
      owners.emplace_back(number, int(rank));
  std::sort(owners.begin(), owners.end());
  return owners;
}

} // namespace

std::vector<int> ownersOf(const std::vector<Global>& numbers, const IndexMap& map, const Comm& comm)
{
  if (comm.size() == 1)
    return std::vector<int>(numbers.size(), 0);
  const Global blockSize = map.globalSize() / comm.size() + 1;
  const auto owners = ownersOfBlock(map, blockSize, comm);
  std::vector<std::vector<Global>> asked(std::size_t(comm.size()));
  for (const Global number : numbers)
    asked[std::size_t(number / blockSize)].push_back(number);
  std::vector<std::vector<int>> answers;
  for (const std::vector<Global>& questions : exchanged(asked, comm)) {
    answers.emplace_back();
    for (const Global number : questions) {
      const auto found = std::lower_bound(owners.begin(), owners.end(), std::pair(number, 0));
      NDFRAME_ASSERT(found != owners.end() && found->first == number, "a number of a map has no owner");
      answers.back().push_back(found->second);
    }
  }
  InOrder told(exchanged(answers, comm));
  std::vector<int> result;
  for (const Global number : numbers)
    result.push_back(told.next(std::size_t(number / blockSize)));
  return result;
}

SharedValues sharedGhosts(const IndexMap& map, const Comm& comm)
{
  if (comm.size() == 1)
    return {};
  std::vector<Global> numbers;
  for (int i = 0; i < map.size(); ++i)
    numbers.push_back(map.global(i));
  std::vector<int> owners(std::size_t(map.numOwned()), comm.rank());
  const std::vector<int> others = ownersOf({numbers.begin() + map.numOwned(), numbers.end()}, map, comm);
  owners.insert(owners.end(), others.begin(), others.end());
  return sharedByOwners(
      numbers, owners, [&map](Global number) { return map.local(number); }, comm);
}

} // namespace ndframe
