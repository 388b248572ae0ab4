#include "joined_input.hpp"

#include <algorithm>
#include <climits>

#include <fmt/format.h>

#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

JoinedInput::JoinedInput(const std::vector<std::string>& paths) : paths_(paths)
{
  for (const std::string& path : paths) {
    try {
      pieces_.push_back(std::make_unique<ExodusInput>(path));
      pieceBlocks_.push_back(pieces_.back()->blocks());
    } catch (const FileError& error) {
      throw FileError(fmt::format("{}: {}", path, error.what()));
    }
    if (pieces_.back()->dim() != dim())
      throw FileError(fmt::format("{} has dimension {} and {} has {}; they are no pieces of one mesh.", paths.front(),
                                  dim(), path, pieces_.back()->dim()));
    elementOf_.emplace_back(pieces_.back()->numElements(), -1);
  }
  joinNodes();
  joinBlocks();
}

void JoinedInput::joinNodes()
{
  std::vector<int> all;
  for (const auto& piece : pieces_) {
    nodeOf_.push_back(piece->nodeIds());
    all.insert(all.end(), nodeOf_.back().begin(), nodeOf_.back().end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  coordinates_.resize(3 * all.size());
  std::vector<char> isKnown(all.size(), 0);
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const std::vector<double> points = pieces_[p]->coordinates();
    for (std::size_t n = 0; n < nodeOf_[p].size(); ++n) {
      const auto node = std::size_t(std::lower_bound(all.begin(), all.end(), nodeOf_[p][n]) - all.begin());
      if (isKnown[node] && !std::equal(&points[3 * n], &points[3 * n] + 3, &coordinates_[3 * node]))
        throw FileError(fmt::format("node {} is at another place in {} than in a piece before it; they are no pieces "
                                    "of one mesh.",
                                    nodeOf_[p][n], paths_[p]));
      std::copy_n(&points[3 * n], 3, &coordinates_[3 * node]);
      isKnown[node] = 1;
      nodeOf_[p][n] = int(node);
    }
  }
  nodeIds_ = std::move(all);
}

const ExodusBlock& JoinedInput::blockOf(std::size_t piece, int id) const
{
  const auto& blocks = pieceBlocks_[piece];
  const auto found = std::find_if(blocks.begin(), blocks.end(), [&](const auto& block) { return block.id == id; });
  if (found == blocks.end() || blocks.size() != pieceBlocks_.front().size())
    throw FileError(fmt::format("{} and {} have different element blocks; they are no pieces of one mesh.",
                                paths_.front(), paths_[piece]));
  return *found;
}

void JoinedInput::joinBlocks()
{
  std::int64_t count = 0;
  for (const auto& piece : pieces_)
    count += piece->numElements();
  if (count > INT_MAX)
    throw FileError(fmt::format("the pieces have {} elements, more than can be numbered.", count));
  for (const ExodusBlock& block : pieceBlocks_.front())
    joinBlock(block);
}

void JoinedInput::joinBlock(ExodusBlock block)
{
  std::vector<Member>& members = members_[block.id];
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const ExodusBlock& part = blockOf(p, block.id);
    if (part.numElements == 0)
      continue;
    if (!members.empty() && (part.type != block.type || part.nodesPerElement != block.nodesPerElement))
      throw FileError(fmt::format("block {} has elements of another type in {}; they are no pieces of one mesh.",
                                  block.name, paths_[p]));
    block.type = part.type;
    block.nodesPerElement = part.nodesPerElement;
    const std::vector<int> ids = pieces_[p]->elementIds();
    for (int place = 0; place < part.numElements; ++place)
      members.push_back({ids[std::size_t(part.firstElement) + std::size_t(place)], p, place});
  }
  std::sort(members.begin(), members.end(), [](const Member& a, const Member& b) { return a.id < b.id; });
  const auto twice =
      std::adjacent_find(members.begin(), members.end(), [](const Member& a, const Member& b) { return a.id == b.id; });
  if (twice != members.end())
    throw FileError(fmt::format("element {} is in {} and in {}; they are no pieces of one mesh.", twice->id,
                                paths_[twice->piece], paths_[(twice + 1)->piece]));
  for (const Member& member : members) {
    const int local = blockOf(member.piece, block.id).firstElement + member.place;
    elementOf_[member.piece][std::size_t(local)] = numElements_++;
    elementIds_.push_back(member.id);
  }
  block.numElements = int(members.size());
  block.firstElement = numElements_ - block.numElements;
  blocks_.push_back(block);
}

std::vector<int> JoinedInput::nodes(const ExodusBlock& block) const
{
  std::vector<std::vector<int>> ofPieces;
  for (std::size_t p = 0; p < pieces_.size(); ++p)
    ofPieces.push_back(pieces_[p]->nodes(blockOf(p, block.id)));
  std::vector<int> joined;
  for (const Member& member : members_.at(block.id))
    for (int a = 0; a < block.nodesPerElement; ++a) {
      const auto place = std::size_t(member.place) * std::size_t(block.nodesPerElement) + std::size_t(a);
      joined.push_back(nodeOf_[member.piece][std::size_t(ofPieces[member.piece][place])]);
    }
  return joined;
}

std::vector<ExodusSideSet> JoinedInput::sideSets() const
{
  std::vector<ExodusSideSet> joined;
  for (std::size_t p = 0; p < pieces_.size(); ++p)
    for (const ExodusSideSet& set : pieces_[p]->sideSets()) {
      auto same = std::find_if(joined.begin(), joined.end(), [&](const auto& s) { return s.name == set.name; });
      if (same == joined.end())
        same = joined.insert(joined.end(), {set.name, {}, {}});
      for (const int element : set.elements) {
        if (element < 1 || element > pieces_[p]->numElements())
          throw FileError(fmt::format("{}: side set {} names element {}, but there are {}.", paths_[p], set.name,
                                      element, pieces_[p]->numElements()));
        same->elements.push_back(elementOf_[p][std::size_t(element - 1)] + 1);
      }
      same->sides.insert(same->sides.end(), set.sides.begin(), set.sides.end());
    }
  return joined;
}

} // namespace ndframe
