#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ndframe
{

/// Elements of one type with the same physical groups.
struct MshBlock
{
  int type;                          ///< gmsh's element type
  std::vector<int> groups;           ///< tags of the physical groups of the elements' dimension
  std::vector<std::int64_t> numbers; ///< the file's element numbers
  std::vector<int> nodes;            ///< indices into MshFile::coordinates
};

struct MshGroup
{
  int dim;
  int tag;
  std::string name;
};

/// What a .msh file says, as far as a mesh needs it.
struct MshFile
{
  std::vector<double> coordinates; ///< three per node
  std::vector<MshBlock> blocks;
  std::vector<MshGroup> groups; ///< the named physical groups
};

/// Properties of gmsh's element types.
struct MshElementType
{
  const char* name;
  int dim;
  int order;
  int nodes;
};

/// Null for a type that is not known.
const MshElementType* findMshElementType(int type);

/// Reads the text of a .msh file of format 2.2 or 4.1, ASCII or binary (gmsh reference manual, "MSH file format").
/// Sections other than nodes, elements, entities and physical names are skipped. Every count is checked against the
/// rest of the file and every number against what it refers to, so that no damaged file can do more than throw
/// FileError.
MshFile parseMsh(std::string_view text);

} // namespace ndframe
