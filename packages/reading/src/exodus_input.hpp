#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "exodus_mesh.hpp"

namespace ndframe
{

/// An Exodus file open for reading. Everything it says is checked against the size of the file before memory is
/// allocated. Throws FileError.
class ExodusInput final : public ExodusMesh
{
public:
  explicit ExodusInput(const std::string& path);

  int dim() const override { return dim_; }
  int numElements() const override { return numElements_; }
  std::vector<double> coordinates() const override;
  std::vector<ExodusBlock> blocks() const override;
  std::vector<int> nodes(const ExodusBlock& block) const override;
  std::vector<ExodusSideSet> sideSets() const override;
  /// Per node, and element, its number in the mesh that the file is a piece of; 1, 2, ... in a file that is none.
  std::vector<int> nodeIds() const;
  std::vector<int> elementIds() const;

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
  std::vector<int> idMap(int kind, int count) const;
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
