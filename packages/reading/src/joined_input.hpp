#pragma once

#include <map>
#include <memory>

#include "exodus_input.hpp"

namespace ndframe
{

/// The mesh whose pieces are several Exodus files, by their maps to the numbers of the whole (node_num_map,
/// elem_num_map): nodes and the elements of a block in the order of these numbers, facets of a side set piece by piece.
/// Throws FileError, also when the pieces do not belong together.
class JoinedInput final : public ExodusMesh
{
public:
  explicit JoinedInput(const std::vector<std::string>& paths);

  int dim() const override { return pieces_.front()->dim(); }
  int numElements() const override { return numElements_; }
  std::vector<double> coordinates() const override { return coordinates_; }
  std::vector<ExodusBlock> blocks() const override { return blocks_; }
  std::vector<int> nodes(const ExodusBlock& block) const override;
  std::vector<ExodusSideSet> sideSets() const override;
  const std::vector<int>& nodeIds() const { return nodeIds_; }       ///< per node its number in the whole, ascending
  const std::vector<int>& elementIds() const { return elementIds_; } ///< the same per element, ascending in a block

private:
  /// An element: its number in the whole, its piece, and its place in the piece's block.
  struct Member
  {
    int id;
    std::size_t piece;
    int place;
  };

  const ExodusBlock& blockOf(std::size_t piece, int id) const;
  void joinNodes();
  void joinBlocks();
  void joinBlock(ExodusBlock block);

  std::vector<std::string> paths_;
  std::vector<std::unique_ptr<ExodusInput>> pieces_;
  std::vector<std::vector<ExodusBlock>> pieceBlocks_;
  std::vector<std::vector<int>> nodeOf_, elementOf_; ///< per piece: number in the join, from 0
  std::vector<int> nodeIds_, elementIds_;
  std::vector<double> coordinates_;
  std::vector<ExodusBlock> blocks_;
  std::map<int, std::vector<Member>> members_; ///< by the block's id, ascending numbers
  int numElements_ = 0;
};

} // namespace ndframe
