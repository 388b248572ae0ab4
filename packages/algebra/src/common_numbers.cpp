#include "ndframe/algebra/common_numbers.hpp"

#include <algorithm>
#include <iterator>

#include "exchange.hpp"
#include "ndframe/algebra/shared_values.hpp"

namespace ndframe
{
namespace
{

constexpr std::int64_t stripes = 4;
constexpr int entries = std::tuple_size_v<CommonKey>;

/// The keys of one block, by the ranks that have them.
class KeyBlock
{
public:
  explicit KeyBlock(const std::vector<std::vector<std::int64_t>>& told)
  {
    for (const std::vector<std::int64_t>& ofRank : told) {
      ofRanks_.emplace_back();
      for (auto entry = ofRank.begin(); entry != ofRank.end(); entry += entries)
        std::copy_n(entry, entries, ofRanks_.back().emplace_back().begin());
      all_.insert(all_.end(), ofRanks_.back().begin(), ofRanks_.back().end());
    }
    std::sort(all_.begin(), all_.end());
    all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
  }

  std::int64_t count() const { return std::int64_t(all_.size()); }

  /// Per rank, for each of its keys: its number, counted from `first` on, and its owner.
  std::vector<std::vector<std::int64_t>> answers(std::int64_t first, std::int64_t bound) const
  {
    std::vector<std::vector<std::int64_t>> result(ofRanks_.size());
    std::vector<std::pair<int, int>> having(all_.size(), {-1, -1}); // lowest and highest rank
    const auto placeOf = [&](const CommonKey& key) {
      return std::lower_bound(all_.begin(), all_.end(), key) - all_.begin();
    };
    for (std::size_t rank = 0; rank < ofRanks_.size(); ++rank)
      for (const CommonKey& key : ofRanks_[rank]) {
        auto& [lowest, highest] = having[std::size_t(placeOf(key))];
        lowest = lowest < 0 ? int(rank) : lowest;
        highest = int(rank);
      }
    for (std::size_t rank = 0; rank < ofRanks_.size(); ++rank)
      for (const CommonKey& key : ofRanks_[rank]) {
        const auto place = placeOf(key);
        const auto& [lowest, highest] = having[std::size_t(place)];
        const std::int64_t stripe = key[0] * stripes / bound;
        result[rank].insert(result[rank].end(),
                            {first + place, (lowest + highest + stripe) % 2 == 0 ? lowest : highest});
      }
    return result;
  }

private:
  std::vector<std::vector<CommonKey>> ofRanks_;
  std::vector<CommonKey> all_; ///< ascending
};

} // namespace

CommonNumbers commonNumbers(const std::vector<CommonKey>& keys, std::int64_t bound, const Comm& comm)
{
  const std::int64_t blockSize = bound / comm.size() + 1;
  const auto blockOf = [&](const CommonKey& key) {
    NDFRAME_ASSERT(key[0] >= 0 && key[0] < bound, "first entries of keys are below the bound");
    return std::size_t(key[0] / blockSize);
  };
  std::vector<std::vector<std::int64_t>> told(std::size_t(comm.size()));
  for (const CommonKey& key : keys)
    told[blockOf(key)].insert(told[blockOf(key)].end(), key.begin(), key.end());
  const KeyBlock block(exchanged(told, comm));
  const Vector counts = gatheredFrom({double(block.count())}, comm);
  std::int64_t first = 0;
  CommonNumbers result;
  for (std::size_t rank = 0; rank < counts.size(); ++rank) {
    first += int(rank) < comm.rank() ? std::int64_t(counts[rank]) : 0;
    result.count += std::int64_t(counts[rank]);
  }
  const auto answers = exchanged(block.answers(first, bound), comm);
  std::vector<std::size_t> next(answers.size(), 0);
  for (const CommonKey& key : keys) {
    const std::size_t rank = blockOf(key);
    result.numbers.push_back(answers[rank][next[rank]]);
    result.owners.push_back(int(answers[rank][next[rank] + 1]));
    next[rank] += 2;
  }
  return result;
}

} // namespace ndframe
