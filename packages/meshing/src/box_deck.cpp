#include "box_deck.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unistd.h>

#include <fmt/format.h>

namespace ndframe
{

const Names<BoxPattern> boxPatterns{
    {"Right", BoxPattern::Right}, {"Alternating", BoxPattern::Alternating}, {"Crossed", BoxPattern::Crossed}};

const Names<int> boxDirections{{"X", 0}, {"Y", 1}, {"Z", 2}};

std::string boxSizesList(int direction)
{
  return "Cell Sizes " + boxDirections.name(direction);
}

const Names<BoxSide>& boxSides(int dim)
{
  static const Names<BoxSide> plane{
      {"left", {0, false}}, {"right", {0, true}}, {"bottom", {1, false}}, {"top", {1, true}}};
  static const Names<BoxSide> space{{"left", {0, false}}, {"right", {0, true}},   {"front", {1, false}},
                                    {"back", {1, true}},  {"bottom", {2, false}}, {"top", {2, true}}};
  return dim == 2 ? plane : space;
}

BoxGrid BoxDeck::grid()
{
  readExtents();
  mistakes_.throwIfAny(); // everything below needs the extents
  grid_.pattern = boxPatterns.value(params_.get<std::string>("Pattern"));
  grid_.rotation = params_.get<double>("Rotation");
  if (dim_ == 3 && grid_.pattern == BoxPattern::Crossed)
    mistake(params_, "Pattern", "Crossed is for boxes in two dimensions; use Right or Alternating.");
  readProfiles();
  nameSides();
  for (const Params& list : params_.sub("Splits").subs())
    readSplit(list);
  if (params_.hasSub("Parts"))
    for (const Params& list : params_.sub("Parts").subs())
      readBlock(list);
  mistakes_.throwIfAny();
  checkSize();
  makeLines();
  mistakes_.throwIfAny();
  makeParts();
  makeBlocks();
  mistakes_.throwIfAny();
  return std::move(grid_);
}

void BoxDeck::readExtents()
{
  lower_ = params_.get<std::vector<double>>("Lower");
  upper_ = params_.get<std::vector<double>>("Upper");
  cells_ = params_.get<std::vector<int>>("Cells");
  dim_ = int(lower_.size());
  if (dim_ != 2 && dim_ != 3)
    return mistake(params_, "Lower", fmt::format("Lower has {} coordinates; a box has 2 or 3.", dim_));
  const std::pair<const char*, std::size_t> lengths[] = {{"Upper", upper_.size()}, {"Cells", cells_.size()}};
  for (const auto& [key, size] : lengths)
    if (int(size) != dim_)
      mistake(params_, key,
              fmt::format("{} has {} entries but Lower has {}; give one per direction.", key, size, dim_));
  for (int d = 0; d < std::min(dim_, int(upper_.size())); ++d)
    if (lower_[d] >= upper_[d] || !std::isfinite(upper_[d] - lower_[d]))
      mistake(params_, "Upper",
              fmt::format("Upper must be larger than Lower in direction {}, but {} and {} are given.",
                          boxDirections.name(d), lower_[d], upper_[d]));
  for (const int n : cells_)
    if (n < 1)
      mistake(params_, "Cells", fmt::format("{} cells in a direction; at least 1 is needed.", n));
}

void BoxDeck::checkSize()
{
  const double bricks = std::accumulate(cells_.begin(), cells_.end(), 1.0, std::multiplies<>());
  const double simplices = bricks * simplicesPerBrick(dim_, grid_.pattern);
  const double bytes = simplices * (dim_ + 1) * (dim_ + 3) * sizeof(int); // the mesh and the ordering of its facets
  const double memory = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  // Points and facets are numbered by int.
  if (simplices * (dim_ + 1) > std::numeric_limits<int>::max() || 4 * bricks > std::numeric_limits<int>::max())
    mistake(params_, "Cells",
            fmt::format("Cells make {:.3g} simplices, more than can be numbered; use fewer.", simplices));
  else if (bytes > memory)
    mistake(
        params_, "Cells",
        fmt::format("Cells make {:.3g} simplices, which need {:.3g} GB for the mesh alone; this machine has {:.3g} GB.",
                    simplices, bytes / 1e9, memory / 1e9));
  mistakes_.throwIfAny();
}

void BoxDeck::readProfiles()
{
  std::vector<double> ratios(dim_, 1.0);
  if (params_.has("Grading"))
    ratios = params_.get<std::vector<double>>("Grading");
  if (int(ratios.size()) != dim_)
    return mistake(
        params_, "Grading",
        fmt::format("Grading has {} entries but Lower has {}; give one per direction.", ratios.size(), dim_));
  for (const double ratio : ratios)
    if (ratio < 1e-6 || ratio > 1e6)
      mistake(params_, "Grading", fmt::format("Grading = {} is outside [1e-6, 1e6].", ratio));
  for (int d = 0; d < 3; ++d) {
    const bool hasList = params_.hasSub(boxSizesList(d));
    if (d < dim_ && !hasList)
      profiles_.push_back(geometricProfile(lower_[d], upper_[d], cells_[d], ratios[d]));
    else if (d < dim_)
      profiles_.push_back(readSizes(params_.sub(boxSizesList(d))));
    else if (hasList)
      mistake(params_.sub(boxSizesList(d)), "", "a box in two dimensions has no direction Z.");
    if (d < dim_ && hasList && ratios[d] != 1.0)
      mistake(params_, "Grading",
              fmt::format("direction {} has both a Grading and a list {}; give one of them.", boxDirections.name(d),
                          boxSizesList(d)));
  }
}

SizeProfile BoxDeck::readSizes(const Params& list)
{
  SizeProfile profile{list.get<std::vector<double>>("At"), list.get<std::vector<double>>("Size")};
  if (profile.at.empty() || profile.at.size() != profile.size.size())
    mistake(list, "Size",
            fmt::format("{} sizes for {} points; give one for each point, and at least one.", profile.size.size(),
                        profile.at.size()));
  if (std::adjacent_find(profile.at.begin(), profile.at.end(), std::greater_equal<>()) != profile.at.end())
    mistake(list, "At", "the points must increase.");
  const auto [least, largest] = std::minmax_element(profile.size.begin(), profile.size.end());
  if (!profile.size.empty() && (*least <= 0.0 || *largest > 1e6 * *least))
    mistake(list, "Size", "the sizes must be positive and within a factor of 1e6.");
  return profile;
}

void BoxDeck::nameSides()
{
  for (int normal = 0; normal < dim_; ++normal)
    for (const bool upper : {false, true})
      parts_.push_back({boxSides(dim_).name({normal, upper}), {normal, upper}, lower_, upper_});
}

void BoxDeck::readSplit(const Params& list)
{
  const auto name = list.get<std::string>("Side");
  const auto whole = std::find_if(parts_.begin(), parts_.end(), [&](const Part& part) { return part.name == name; });
  if (whole == parts_.end())
    return mistake(list, "Side",
                   fmt::format("a box in {} dimensions has no side \"{}\" and no split before this one makes it; the "
                               "sides are {}.",
                               dim_ == 2 ? "two" : "three", name, boxSides(dim_).range().text));
  Split split{*whole, 0, list.get<std::vector<double>>("At"), list.get<std::vector<std::string>>("Names")};
  readDirection(list, split);
  checkSplitPoints(list, split);
  splits_.push_back(split);
  const auto along = std::size_t(split.along);
  Part rest = split.whole;
  for (std::size_t k = 0; k < split.names.size() && along < split.whole.high.size(); ++k) {
    rest.name = split.names[k];
    rest.high[along] = k < split.at.size() ? split.at[k] : split.whole.high[along];
    for (const Part& other : parts_)
      if (other.name == rest.name)
        return mistake(params_.sub("Splits"), "",
                       fmt::format("two sides are called \"{}\"; names must differ.", rest.name));
    parts_.push_back(rest);
    rest.low[along] = rest.high[along];
  }
}

void BoxDeck::readDirection(const Params& list, Split& split)
{
  split.along = split.whole.side.normal == 0 ? 1 : 0;
  if (!list.has("Direction"))
    return;
  const auto name = list.get<std::string>("Direction");
  split.along = boxDirections.value(name);
  if (split.along >= dim_ || split.along == split.whole.side.normal)
    mistake(list, "Direction", fmt::format("the side {} does not extend in direction {}.", split.whole.name, name));
}

void BoxDeck::checkSplitPoints(const Params& list, const Split& split)
{
  if (split.along >= dim_)
    return;
  if (split.names.size() != split.at.size() + 1)
    mistake(list, "Names",
            fmt::format("{} points cut the side into {} parts, but {} names are given.", split.at.size(),
                        split.at.size() + 1, split.names.size()));
  const double margin = tolerance(split.along);
  const double low = split.whole.low[std::size_t(split.along)], high = split.whole.high[std::size_t(split.along)];
  for (std::size_t i = 0; i < split.at.size(); ++i) {
    if (split.at[i] <= low + margin || split.at[i] >= high - margin)
      mistake(list, "At", fmt::format("At = {} is outside ({}, {}).", split.at[i], low, high));
    if (i > 0 && split.at[i] <= split.at[i - 1] + margin)
      mistake(list, "At", fmt::format("the points must increase, but {} follows {}.", split.at[i], split.at[i - 1]));
  }
}

void BoxDeck::makeLines()
{
  for (int d = 0; d < dim_; ++d) {
    std::vector<double> breaks;
    for (const Split& split : splits_)
      if (split.along == d)
        breaks.insert(breaks.end(), split.at.begin(), split.at.end());
    for (const Block& block : blocks_)
      for (const double at : {block.lower[std::size_t(d)], block.upper[std::size_t(d)]})
        if (at > lower_[d] + tolerance(d) && at < upper_[d] - tolerance(d))
          breaks.push_back(at);
    std::sort(breaks.begin(), breaks.end());
    const auto same = [&](double a, double b) { return b - a <= tolerance(d); };
    breaks.erase(std::unique(breaks.begin(), breaks.end(), same), breaks.end());
    if (cells_[d] <= int(breaks.size()))
      mistake(params_, "Cells",
              fmt::format("{} cells in direction {} are too few for the splits{}, which need {}.", cells_[d],
                          boxDirections.name(d), blocks_.empty() ? "" : " and parts", breaks.size() + 1));
    else
      grid_.lines.push_back(gridLines(lower_[d], upper_[d], cells_[d], profiles_[d], breaks));
  }
}

int BoxDeck::lineAt(int direction, double x) const
{
  const auto& lines = grid_.lines[direction];
  return int(std::lower_bound(lines.begin(), lines.end(), x - tolerance(direction)) - lines.begin());
}

void BoxDeck::makeParts()
{
  for (const Part& part : parts_) {
    BoxPart bricks{part.name, part.side.normal, part.side.upper, {}, {1, 1, 1}};
    for (int d = 0; d < dim_; ++d) {
      bricks.first[std::size_t(d)] = lineAt(d, part.low[std::size_t(d)]);
      bricks.last[std::size_t(d)] = lineAt(d, part.high[std::size_t(d)]);
    }
    grid_.parts.push_back(std::move(bricks));
  }
}

void BoxDeck::readBlock(const Params& list)
{
  Block block{list.name(), list.get<std::vector<double>>("Lower"), list.get<std::vector<double>>("Upper")};
  for (const auto& [key, corner] : {std::pair("Lower", &block.lower), std::pair("Upper", &block.upper)})
    if (int(corner->size()) != dim_)
      return mistake(list, key,
                     fmt::format("{} has {} entries but the box has {} directions.", key, corner->size(), dim_));
  for (int d = 0; d < dim_; ++d) {
    const double low = block.lower[std::size_t(d)], high = block.upper[std::size_t(d)];
    if (!(high > low + tolerance(d)))
      mistake(list, "Upper",
              fmt::format("Upper must be larger than Lower in direction {}, but {} and {} are given.",
                          boxDirections.name(d), low, high));
    else if (low < lower_[d] - tolerance(d) || high > upper_[d] + tolerance(d))
      mistake(list, "Lower",
              fmt::format("the part goes from {} to {} in direction {}, the box from {} to {}.", low, high,
                          boxDirections.name(d), lower_[d], upper_[d]));
  }
  blocks_.push_back(std::move(block));
}

void BoxDeck::makeBlocks()
{
  for (const Block& block : blocks_) {
    BoxBlock cells{block.name, {}, {1, 1, 1}};
    for (int d = 0; d < dim_; ++d) {
      cells.first[std::size_t(d)] = lineAt(d, block.lower[std::size_t(d)]);
      cells.last[std::size_t(d)] = lineAt(d, block.upper[std::size_t(d)]);
    }
    grid_.blocks.push_back(std::move(cells));
  }
}

} // namespace ndframe
