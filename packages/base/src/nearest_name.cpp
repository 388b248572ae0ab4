#include <algorithm>

#include "ndframe/base/help.hpp"
#include "text.hpp"

namespace ndframe
{

namespace
{

/// Insertions, deletions, substitutions and swaps of neighbours that lead from `a` to `b` (optimal string alignment).
std::size_t editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], beforeLast[j - 2] + 1);
    }
    std::swap(beforeLast, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

} // namespace

std::string nearestName(const std::string& name, const std::vector<std::string>& candidates)
{
  constexpr std::size_t longest = 200; // a name beyond this is no misspelling, and the distance costs its square
  std::string nearest;
  std::size_t smallest = longest;
  for (const auto& candidate : candidates) {
    const std::size_t length = std::max(name.size(), candidate.size());
    if (length > longest)
      continue;
    const std::size_t distance = editDistance(lowered(name), lowered(candidate));
    // About one letter in three may be wrong.
    if (distance <= (length + 1) / 3 && distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

} // namespace ndframe
