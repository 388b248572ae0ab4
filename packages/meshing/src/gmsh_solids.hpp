#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gmsh_model.hpp"
#include "length_field.hpp"
#include "ndframe/meshing/remesh.hpp"

namespace ndframe
{

/// Solids of one script, meshed together with lengths of edges from outside: where two of them share a face of the
/// geometry, they have the same triangles there.
class GmshSolids
{
public:
  /// bodies: parts of the same script. Throws FileError.
  explicit GmshSolids(std::vector<MeshScript> bodies);

  /// Throws FileError unless these two bodies share a face in the script: sides that merely lie on each other would be
  /// meshed differently.
  void requireCommonFace(std::size_t first, std::size_t second) const;

  /// The meshes of all bodies, each with the lengths of its own field; where bodies meet, the shortest counts. `file`
  /// is written on the way. Throws GmshGaveUp and FileError.
  std::vector<Mesh> mesh(const std::vector<const LengthField*>& lengths, GmshAlgorithm algorithm,
                         const std::string& file);

private:
  static double lengthAt(int dim, int tag, double x, double y, double z, void* solids);
  void assign(int dim, int tag, std::size_t body);

  std::vector<MeshScript> bodies_;
  GmshModel model_;
  std::map<std::pair<int, int>, std::vector<std::size_t>> owners_; ///< bodies of volumes and of what bounds them
  std::vector<const LengthField*> lengths_;
};

} // namespace ndframe
