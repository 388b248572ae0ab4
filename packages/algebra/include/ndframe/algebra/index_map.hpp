#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace ndframe
{

/// Which of the numbers 0 .. globalSize - 1 (nodes, cells) this rank holds, and how it numbers them: those that it owns
/// from 0 in ascending order, then those of other ranks that it reads, its ghosts, in ascending order as well. Global
/// numbers have 64 bits, those of a rank 32. A map that holds everything stores nothing: on one rank, and for what is
/// replicated on all.
///
/// Every number has one owner unless the map is whole. Copies share what is stored. All functions are local: nothing is
/// communicated, and nothing of a library is called, so modules may use it.
class IndexMap
{
public:
  using Global = std::int64_t;

  IndexMap() = default; ///< holds nothing of nothing
  /// All of 0 .. size - 1, numbered as everywhere. Throws std::length_error where 32 bits
  /// are not enough.
  static IndexMap whole(Global size)
  {
    IndexMap map;
    map.globalSize_ = size;
    map.numOwned_ = narrow(std::size_t(size));
    return map;
  }
  /// owned: ascending. needed: others and own ones in any order, repetitions allowed; those that are not owned become
  /// ghosts. Whole if all are owned.
  IndexMap(Global globalSize, std::vector<Global> owned, std::vector<Global> needed = {})
      : globalSize_(globalSize), numOwned_(narrow(owned.size()))
  {
    if (Global(owned.size()) == globalSize)
      return;
    std::sort(needed.begin(), needed.end());
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    std::vector<Global> ghosts;
    std::set_difference(needed.begin(), needed.end(), owned.begin(), owned.end(), std::back_inserter(ghosts));
    owned.insert(owned.end(), ghosts.begin(), ghosts.end());
    narrow(owned.size());
    numbers_ = std::make_shared<const std::vector<Global>>(std::move(owned));
  }

  Global globalSize() const { return globalSize_; }                          ///< of all ranks
  int numOwned() const { return numOwned_; }                                 ///< numbers that this rank owns
  int size() const { return isWhole() ? numOwned_ : int(numbers_->size()); } ///< owned ones and ghosts
  bool isWhole() const { return Global(numOwned_) == globalSize_; }          ///< nothing is left to other ranks
  /// Whether a number of this rank, as local() gives it, is neither a ghost nor -1.
  bool owns(int local) const { return local >= 0 && local < numOwned_; }

  /// What this rank owns, and nothing else.
  IndexMap withoutGhosts() const
  {
    return isWhole() ? *this : IndexMap(globalSize_, {numbers_->begin(), numbers_->begin() + numOwned_});
  }

  /// The global number of one of this rank, 0 <= local < size().
  Global global(int local) const { return isWhole() ? local : (*numbers_)[std::size_t(local)]; }
  /// This rank's number of a global one; -1 if it does not hold it. Logarithmic.
  int local(Global global) const
  {
    if (isWhole())
      return global >= 0 && global < globalSize_ ? int(global) : -1;
    const auto begin = numbers_->begin(), middle = begin + numOwned_, end = numbers_->end();
    const auto found = std::lower_bound(begin, middle, global);
    if (found != middle && *found == global)
      return int(found - begin);
    const auto ghost = std::lower_bound(middle, end, global);
    return ghost != end && *ghost == global ? int(ghost - begin) : -1;
  }

private:
  static int narrow(std::size_t size)
  {
    if (size > std::size_t(std::numeric_limits<int>::max()))
      throw std::length_error("a rank would hold more than 2^31 numbers of an index map");
    return int(size);
  }

  Global globalSize_ = 0;
  int numOwned_ = 0;
  std::shared_ptr<const std::vector<Global>> numbers_; ///< of owned ones and ghosts; null if the map is whole
};

/// The numbers of several maps one after the other: those of a map follow all of the maps before it. Of a rank's
/// numbers the owned ones of all maps come first, then the ghosts of all.
inline IndexMap stacked(const std::vector<const IndexMap*>& maps)
{
  std::vector<IndexMap::Global> owned, ghosts;
  IndexMap::Global before = 0;
  for (const IndexMap* map : maps) {
    for (int i = 0; i < map->size(); ++i)
      (map->owns(i) ? owned : ghosts).push_back(before + map->global(i));
    before += map->globalSize();
  }
  return IndexMap(before, std::move(owned), std::move(ghosts));
}

} // namespace ndframe
