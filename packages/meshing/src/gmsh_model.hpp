#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "gmsh_session.hpp"

namespace ndframe
{

/// An array that gmsh allocates.
template <class T>
struct GmshArray
{
  GmshArray() = default;
  ~GmshArray() { GmshFunctions::get().free(data); }
  GmshArray(const GmshArray&) = delete;
  GmshArray& operator=(const GmshArray&) = delete;
  const T* begin() const { return data; }
  const T* end() const { return data + size; }

  T* data = nullptr;
  std::size_t size = 0;
};

/// The geometry of a script without what the script says about sizes: points, curves, surfaces, volumes (dimension 0 to
/// 3) by gmsh's tags.
class GmshModel
{
public:
  /// What gmsh asks for a size: dimension and tag of what it meshes, the point, the data given along.
  using SizeAt = double (*)(int, int, double, double, double, void*);

  explicit GmshModel(const std::string& script); ///< throws FileError

  GmshSession& session() { return session_; }
  int dimension() const { return session_.dimension(); } ///< of the geometry

  /// In the physical groups with these names; without names all of them.
  std::vector<int> entitiesOf(int dim, const std::vector<std::string>& groups) const;
  std::vector<int> boundaryOf(int dim, int tag) const; ///< of one of them, those of dimension dim - 1
  /// Meshes nothing but these, what bounds them and what lies in them.
  void showOnly(int dim, const std::vector<int>& tags);
  /// The same random numbers, so that meshes are the same every time; good shapes; nothing Transfinite or
  /// recombined, whatever the script says.
  void useSettingsForSolids();
  /// Sizes from nothing but this function.
  void setSizes(SizeAt sizeAt, const void* data, int surfaceAlgorithm);

  void require(int error) const { session_.requireSuccess(error, "gmsh cannot remesh the script"); }

private:
  void forgetOwnSizes();

  GmshSession session_;
  const GmshFunctions& gmsh_ = GmshFunctions::get();
};

} // namespace ndframe
