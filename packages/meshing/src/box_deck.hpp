#pragma once

#include <string>
#include <vector>

#include "box_mesh.hpp"
#include "grid_lines.hpp"
#include "ndframe/base/params.hpp"

namespace ndframe
{

// Names that decks use, for the specification and for reading.
extern const Names<BoxPattern> boxPatterns;
extern const Names<int> boxDirections;
/// "Cell Sizes X" and so on.
std::string boxSizesList(int direction);

struct BoxSide
{
  int normal;
  bool upper;
  bool operator==(const BoxSide& other) const { return normal == other.normal && upper == other.upper; }
};

/// The sides by dimension.
const Names<BoxSide>& boxSides(int dim);

/// Reads the deck's list and collects its mistakes.
class BoxDeck
{
public:
  explicit BoxDeck(const Params& params) : params_(params) {}

  BoxGrid grid();

private:
  /// A side, or a part of one: where it begins and ends in every direction.
  struct Part
  {
    std::string name;
    BoxSide side;
    std::vector<double> low, high;
  };

  /// A part to be cut into named ones along a direction.
  struct Split
  {
    Part whole;
    int along;
    std::vector<double> at;
    std::vector<std::string> names;
  };

  /// A named part of the box: bricks between two corners.
  struct Block
  {
    std::string name;
    std::vector<double> lower, upper;
  };

  void readExtents();
  void checkSize();
  void readProfiles();
  SizeProfile readSizes(const Params& list);
  void nameSides();
  void readSplit(const Params& list);
  void readDirection(const Params& list, Split& split);
  void checkSplitPoints(const Params& list, const Split& split);
  void readBlock(const Params& list);
  void makeLines();
  void makeBlocks();
  void makeParts();
  int lineAt(int direction, double x) const;
  double length(int direction) const { return upper_[direction] - lower_[direction]; }
  /// Points closer than this are one grid line.
  double tolerance(int direction) const { return 1e-9 * length(direction); }
  void mistake(const Params& list, const std::string& key, const std::string& message)
  {
    mistakes_.add(list.mistake(key, message));
  }

  const Params& params_;
  Diagnostics mistakes_;
  int dim_ = 0;
  std::vector<double> lower_;
  std::vector<double> upper_;
  std::vector<int> cells_;
  std::vector<SizeProfile> profiles_;
  std::vector<Part> parts_; ///< the sides, then what splits make of them
  std::vector<Split> splits_;
  std::vector<Block> blocks_;
  BoxGrid grid_;
};

} // namespace ndframe
