#include "ndframe/mechanics/cell_laws.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

CellLaws::CellLaws(const std::vector<Elasticity>& laws, const std::vector<int>& ofCell)
    : laws_() // NOLINT(readability-redundant-member-init): none, where the default is one
{
  std::vector<int> number(laws.size(), -1);
  for (const int law : ofCell) { // only laws that a cell has
    int& found = number[std::size_t(law)];
    if (found >= 0)
      continue;
    found = int(std::find(laws_.begin(), laws_.end(), laws[std::size_t(law)]) - laws_.begin());
    if (found == int(laws_.size()))
      laws_.push_back(laws[std::size_t(law)]);
  }
  NDFRAME_ASSERT(!laws_.empty(), "a body has cells");
  if (laws_.size() == 1)
    return;
  ofCell_.reserve(ofCell.size());
  for (const int law : ofCell)
    ofCell_.push_back(number[std::size_t(law)]);
}

} // namespace ndframe
