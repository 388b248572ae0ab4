#pragma once

#include <cstdint>
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

/// An Exodus file open for reading. Everything it says is checked against the size of the file before memory is
/// allocated. Throws FileError.
class ExodusInput
{
public:
  explicit ExodusInput(const std::string& path);

  int dim() const { return dim_; }
  int numElements() const { return numElements_; }
  /// Three per node, the third zero in a file of two dimensions.
  std::vector<double> coordinates() const;
  std::vector<ExodusBlock> blocks() const;
  /// Node indices from 0.
  std::vector<int> nodes(const ExodusBlock& block) const;
  std::vector<ExodusSideSet> sideSets() const;

private:
  /// The library's open file.
  class Handle
  {
  public:
    explicit Handle(const std::string& path);
    ~Handle();
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator int() const { return id_; }

  private:
    int id_;
  };

  void require(int status, const char* what) const;
  int plausible(std::int64_t count, const char* what) const;
  std::vector<int> ids(int kind, int count) const;
  std::string name(int kind, int id, const char* unnamed) const;

  Handle file_;
  std::int64_t fileSize_;
  int dim_ = 0;
  int numNodes_ = 0;
  int numElements_ = 0;
  int numBlocks_ = 0;
  int numSideSets_ = 0;
};

} // namespace ndframe
