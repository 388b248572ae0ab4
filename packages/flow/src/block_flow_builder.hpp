#pragma once

#include <initializer_list>
#include <map>

#include "ndframe/flow/block_flow.hpp"
#include "pairs_in_order.hpp"

namespace ndframe
{

/// Each step is one function; run() is their order.
class BlockFlow::Builder
{
public:
  using Number = std::int64_t;
  Builder(const Mesh& held, const BodyPiece* piece, const Comm& comm, BlockFlow& flow)
      : mesh_(held), piece_(piece), comm_(comm), flow_(flow)
  {}

  void run()
  {
    findOwn();
    findBlocks();
    findFaces();
    takeNear();
    joinWithin();
    numberSets();
    joinBetween();
    takeCrossings();
    findPlaces();
  }

private:
  /// A face inside the body as the rank that owns its first cell, by the number, sees it.
  struct OwnFace
  {
    std::array<int, 2> half; ///< of the held mesh
    Direction centre;
    double conductance, size;
  };

  bool isOwn(int cell) const { return piece_ == nullptr || piece_->owns(cell); }
  Number number(int cell) const { return piece_ == nullptr ? cell : piece_->numbers[std::size_t(cell)]; }
  int block(int half) const { return blockOf_[std::size_t(half / 4)]; }
  bool staysInside(const OwnFace& face) const { return block(face.half[0]) == block(face.half[1]); }
  /// What cells of other ranks have, too.
  void fetch(std::vector<int>& ofHeld) const;
  void send(std::vector<Vector>& out, int block, std::initializer_list<double> record) const;

  void findOwn();
  void findBlocks();
  void findFaces();
  void takeNear();
  void joinWithin();
  void numberSets();
  void joinBetween();
  std::vector<Vector> sentCrossings() const;
  void takeCrossings();
  void findPlaces();

  const Mesh& mesh_;
  const BodyPiece* piece_;
  const Comm& comm_;
  BlockFlow& flow_;
  std::vector<int> blockOf_;              ///< per held cell
  std::vector<std::vector<int>> ranksOf_; ///< per block
  std::vector<int> twins_;                ///< per half facet of the held mesh that on the other side, -1: none
  std::vector<OwnFace> faces_;
  std::vector<Number> near_;                 ///< numbers of the near cells, ascending
  std::vector<Direction> setCentres_;        ///< per set of the body
  std::vector<int> setOfPart_;               ///< per part of flow_.within_
  std::map<std::array<int, 2>, int> linkOf_; ///< per pair of sets
  std::vector<NumberPair> inner_, crossing_; ///< cells of within_'s links and of the crossings, ascending
};

} // namespace ndframe
