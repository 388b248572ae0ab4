#pragma once

#include <array>
#include <string>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

enum class BoxPattern
{
  Right,
  Alternating,
  Crossed
};

/// A named part of one of the box's sides: the facets of the cells [firstCell, lastCell) counted along one direction.
struct BoxPart
{
  std::string name;
  int normal;                     ///< direction of the side's normal: 0, 1, 2 for x, y, z
  bool upper;                     ///< the side at the larger coordinate
  std::array<int, 3> first, last; ///< bricks [first, last) in the directions in which the side extends
};

/// A named part of the box: the bricks [first, last) in every direction.
struct BoxBlock
{
  std::string name;
  std::array<int, 3> first{}, last{1, 1, 1};
};

/// A tensor-product grid whose bricks are cut into simplices.
struct BoxGrid
{
  std::vector<std::vector<double>> lines; ///< increasing coordinates per direction; their number is the dimension
  BoxPattern pattern;
  double rotation; ///< degrees about the origin (the z axis)
  std::vector<BoxPart> parts;
  std::vector<BoxBlock> blocks; ///< become groups of cells; they may overlap
};

/// Simplices per brick.
int simplicesPerBrick(int dim, BoxPattern pattern);

/// Points of the grid with x running fastest, followed by the centres of crossed bricks; one side per part, one
/// group of cells per block.
Mesh boxMesh(const BoxGrid& grid);

} // namespace ndframe
