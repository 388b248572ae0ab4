#include "ndframe/algebra/common_numbers.hpp"

#include <algorithm>

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
    const auto eachKey = [&](const auto& take) {
      for (std::size_t rank = 0; rank < told.size(); ++rank)
        for (auto entry = told[rank].begin(); entry != told[rank].end(); entry += entries) {
          CommonKey key{};
          std::copy_n(entry, entries, key.begin());
          take(rank, key);
        }
    };
    eachKey([this](std::size_t, const CommonKey& key) { all_.push_back(key); });
    std::sort(all_.begin(), all_.end());
    all_.erase(std::unique(all_.begin(), all_.end()), all_.end());
    places_.resize(told.size());
    having_.resize(all_.size(), {-1, -1});
    eachKey([this](std::size_t rank, const CommonKey& key) {
      const auto place = std::size_t(std::lower_bound(all_.begin(), all_.end(), key) - all_.begin());
      places_[rank].push_back(place);
      auto& [lowest, highest] = having_[place];
      lowest = lowest < 0 ? int(rank) : lowest;
      highest = int(rank);
    });
  }

  std::int64_t count() const { return std::int64_t(all_.size()); }

  /// Per rank, for each of its keys: its number, counted from `first` on, and its owner.
  std::vector<std::vector<std::int64_t>> answers(std::int64_t first, std::int64_t bound) const
  {
    std::vector<std::vector<std::int64_t>> result(places_.size());
    for (std::size_t rank = 0; rank < places_.size(); ++rank)
      for (const std::size_t place : places_[rank]) {
        const auto& [lowest, highest] = having_[place];
        const std::int64_t stripe = all_[place][0] * stripes / bound;
        result[rank].insert(result[rank].end(),
                            {first + std::int64_t(place), (lowest + highest + stripe) % 2 == 0 ? lowest : highest});
      }
    return result;
  }

private:
  std::vector<CommonKey> all_;                   ///< ascending
  std::vector<std::pair<int, int>> having_;      ///< per key: the lowest and the highest rank that has it
  std::vector<std::vector<std::size_t>> places_; ///< per rank, for each of its keys: its place among all
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
  const auto [first, count] = beforeAndAll(block.count(), comm);
  CommonNumbers result;
  result.count = count;
  InOrder answers(exchanged(block.answers(first, bound), comm));
  for (const CommonKey& key : keys) {
    const std::size_t rank = blockOf(key);
    result.numbers.push_back(answers.next(rank));
    result.owners.push_back(int(answers.next(rank)));
  }
  return result;
}

} // namespace ndframe
