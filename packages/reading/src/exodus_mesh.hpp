#pragma once

#include <string>
#include <vector>

namespace ndframe
{

/// An element block of an Exodus file.
struct ExodusBlock
{
  int id;
  std::string name; ///< "block_ID" when the file gives none
  std::string type; ///< in capitals, e.g. "TRI3"
  int numElements;
  int nodesPerElement;
  int firstElement; ///< number of its first element in the file, from 0
};

struct ExodusSideSet
{
  std::string name;          ///< "sideset_ID" when the file gives none
  std::vector<int> elements; ///< from 1
  std::vector<int> sides;    ///< from 1, in Exodus's numbering
};

/// What an Exodus file, or several that are its pieces, have of a mesh. Throws FileError.
class ExodusMesh
{
public:
  virtual ~ExodusMesh() = default;
  virtual int dim() const = 0;
  virtual int numElements() const = 0;
  /// Three per node, the third zero in a file of two dimensions.
  virtual std::vector<double> coordinates() const = 0;
  virtual std::vector<ExodusBlock> blocks() const = 0;
  /// Node indices from 0.
  virtual std::vector<int> nodes(const ExodusBlock& block) const = 0;
  virtual std::vector<ExodusSideSet> sideSets() const = 0;
};

} // namespace ndframe
