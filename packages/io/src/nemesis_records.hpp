#pragma once

#include <vector>

#include "exodus_file.hpp"
#include "exodus_layout.hpp"
#include "piece_scene.hpp"

namespace ndframe
{

/// What a piece's file says of the whole and of the other pieces (Nemesis's part of the Exodus format): the maps to the
/// numbers of the whole, and who has which nodes and facets, too. All numbers are the file's, from 1.
class NemesisRecords
{
public:
  /// `whole` and `piece`: layouts of the scene and of the piece's part of it.
  NemesisRecords(const ExodusLayout& whole, const ExodusLayout& piece, const PieceScene& scene,
                 const ExodusSharing& sharing, int number);

  /// piece: layout of the piece's part of a scene of which no process has the whole.
  NemesisRecords(const ExodusLayout& piece, const PieceScene& scene, const ExodusWhole& whole);

  void put(ExodusFile& file); ///< once, when the file's sizes are defined

private:
  /// With one other piece.
  struct Common
  {
    int other;
    std::vector<int> nodes, elements, sides;
  };

  /// Numbers of things of the whole scene.
  struct Sizes
  {
    std::int64_t nodes = 0, cells = 0;
    std::vector<int> blocks, sets; ///< cells and facets of each
  };

  /// borders: per body.
  void addBorders(const std::vector<std::vector<PieceBorder>>& borders, const ExodusLayout& piece,
                  const PieceScene& scene);
  void separate(const ExodusLayout& piece);
  void putWhole(ExodusFile& file);
  void putBalance(ExodusFile& file);
  void putMaps(ExodusFile& file);

  Sizes whole_;
  int pieces_, number_;
  std::vector<int> nodeNumbers_, elementNumbers_; ///< of the whole, per node and element of the piece
  std::vector<Common> common_;                    ///< ascending by `other`
  std::vector<int> innerNodes_, borderNodes_, innerElements_, borderElements_;
};

} // namespace ndframe
