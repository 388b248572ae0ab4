#pragma once

#include <string>
#include <vector>

#include "ndframe/mesh/mesh.hpp"

namespace ndframe::test
{

/// The mesh as a .msh file of format 2.2 (ASCII), with its sides and one physical group "body" of cells.
std::string asMsh22(const Mesh& mesh);

/// The same in format 4.1. Node and element numbers have gaps and decrease, as the format allows.
std::string asMsh41(const Mesh& mesh);

/// What an Exodus file is to hold.
struct ExodusSample
{
  int dim = 2;
  std::vector<double> points; ///< dim per node
  struct Block
  {
    int id;
    std::string name; ///< may be empty
    std::string type;
    int nodesPerElement;
    std::vector<int> nodes; ///< from 1
  };
  std::vector<Block> blocks;
  struct SideSet
  {
    int id;
    std::string name;
    std::vector<int> elements;
    std::vector<int> sides;
  };
  std::vector<SideSet> sideSets;
};

ExodusSample asExodusSample(const Mesh& mesh);

/// Writes with the Exodus library; mode is EX_CLOBBER with the format's flag (0 for the default).
void writeExodus(const std::string& path, const ExodusSample& sample, int formatFlag = 0);

} // namespace ndframe::test
