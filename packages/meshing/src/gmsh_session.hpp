#pragma once

#include <string>

#include "gmsh_functions.hpp"
#include "ndframe/reading/file_error.hpp"

namespace ndframe
{

/// gmsh has read a script and cannot mesh it; another algorithm or other sizes may help.
class GmshGaveUp final : public FileError
{
public:
  using FileError::FileError;
};

constexpr int gmshDelaunay = 1; ///< of tetrahedra: a value of Mesh.Algorithm3D

/// gmsh between initialisation and finalisation, silent on the terminal. Only one at a time.
class GmshSession
{
public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  void setNumber(const char* option, double value);
  double number(const char* option) const;

  /// Reads a script; what it says of threads and HXT gives way to one thread and Delaunay. Throws FileError with gmsh's
  /// messages, as generate and write do.
  void open(const std::string& path);
  /// Dimension of the geometry; FileError below 2.
  int dimension() const;
  /// Meshes everything up to a dimension. Throws GmshGaveUp.
  void generate(int dim);
  /// Writes all elements as a binary .msh file of format 4.1.
  void write(const std::string& path);

  /// Throws FileError saying `what` when a function of gmsh reports an error or its log holds one.
  void requireSuccess(int error, const std::string& what) const;

private:
  void keepToSteadyMeshers();

  const GmshFunctions& gmsh_ = GmshFunctions::get();
};

} // namespace ndframe
