#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// A part of a mesh, and the numbers that its points and cells have in the whole, both ascending.
struct NumberedMesh
{
  Mesh mesh;                        ///< with all sides of the whole, perhaps without facets, and all names of groups
  std::vector<std::int64_t> points, ///< per point
      cells;                        ///< per cell

  /// The cells for which `isTaken(cell)`, with their points and facets.
  template <class IsTaken>
  NumberedMesh only(const IsTaken& isTaken) const
  {
    std::vector<int> taken;
    for (int cell = 0; cell < mesh.numCells(); ++cell)
      if (isTaken(cell))
        taken.push_back(cell);
    return with(taken);
  }
  NumberedMesh with(const std::vector<int>& taken) const; ///< these cells, ascending
};

/// All of some parts of one mesh, which may have cells in common and are in the order of the cells and points of the
/// whole; facets of a side are in the order of their cells. parts: some.
NumberedMesh joined(const std::vector<NumberedMesh>& parts);

/// As bytes for another process of this machine's kind, and read back (InternalError: they are others).
std::string toBytes(const NumberedMesh& part);
NumberedMesh numberedMeshFromBytes(std::string_view bytes); ///< the second of these

} // namespace ndframe
