#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ndframe/base/registry.hpp"
#include "ndframe/mesh/numbered_mesh.hpp"
#include "ndframe/meshing/script_meshes.hpp"

namespace ndframe
{

/// A gmsh script that a body's mesh is made of, so that it can be made again (remesh.hpp).
struct MeshScript
{
  Params list;                      ///< of the deck: the place of mistakes
  std::string file;                 ///< its path, a .geo file
  std::vector<std::string> regions; ///< physical groups of cells that make the body; empty: all
  int maximumSeconds = 0;           ///< processor time
};

/// Where a body's mesh comes from.
class MeshSource
{
public:
  virtual ~MeshSource() = default;
  /// Generates or reads the mesh. Throws InputError (with the deck's place) when a file is missing, corrupt, not a
  /// triangle/tetrahedron mesh, or changes while it is read. The mesh has passed checkMesh and carries no unused
  /// points.
  virtual Mesh read() const = 0;
  /// The same mesh; what gmsh has made of its script already is not made again.
  virtual Mesh readWith(ScriptMeshes&) const { return read(); }

  /// What makes the mesh before its edges are halved (halvingsOf).
  virtual const MeshSource& drawn() const { return *this; }
  virtual Mesh refined(Mesh drawnMesh) const { return drawnMesh; } ///< what read() makes of that one's

  /// The number of pieces in which its files have the mesh; 0: in one.
  virtual int numPieces() const { return 0; }
  /// What the pieces from `first` to before `last` have, with the files' numbers; throws like read().
  virtual NumberedMesh readPieces(int first, int last) const;

  /// The script that gmsh makes the mesh of. Throws InputError (with the deck's place) when the mesh comes from none.
  virtual MeshScript script() const = 0;
};

/// "Box", "Gmsh", "Exodus", "Meshio".
void registerMeshSources(Registry<MeshSource>& registry);

} // namespace ndframe
