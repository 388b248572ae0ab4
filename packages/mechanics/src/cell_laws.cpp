#include "ndframe/mechanics/cell_laws.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

CellLaws::CellLaws(const std::vector<Elasticity>& laws, const std::vector<int>& ofCell)
    : laws_() // NOLINT(readability-redundant-member-init): none, where the default is one
{
  NDFRAME_ASSERT(!laws.empty(), "a body has a law");
  std::vector<int> number;
  for (const Elasticity& law : laws) {
    number.push_back(int(std::find(laws_.begin(), laws_.end(), law) - laws_.begin()));
    if (number.back() == int(laws_.size()))
      laws_.push_back(law);
  }
  if (laws_.size() == 1)
    return;
  ofCell_.reserve(ofCell.size());
  for (const int law : ofCell)
    ofCell_.push_back(number[std::size_t(law)]);
}

int CellLaws::numberOf(const Elasticity& law) const
{
  const auto found = std::find(laws_.begin(), laws_.end(), law);
  NDFRAME_ASSERT(found != laws_.end(), "a law of the body");
  return int(found - laws_.begin());
}

} // namespace ndframe
