#pragma once

#include <string>
#include <vector>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/bisection.hpp"
#include "ndframe/meshing/mesh_source.hpp"

namespace ndframe
{

/// A side of each of two bodies that have the same facets.
struct MatchingSides
{
  int first;              ///< body; less than second
  std::string firstSide;  ///< name of its side
  int second;             ///< body
  std::string secondSide; ///< name of its side
};

/// The sides whose facets are each other's twins, all of them.
std::vector<MatchingSides> matchingSides(const std::vector<Mesh>& meshes, const std::vector<FacetTwin>& twins);

/// What the meshes of a scene shall be like: edges that have, at every vertex of a mesh of the body, the length that is
/// given there, linear in between.
struct WantedMesh
{
  Mesh background;             ///< a mesh of the body
  std::vector<double> lengths; ///< per vertex, positive
};

/// How gmsh makes triangles, by its own numbers.
enum class GmshAlgorithm
{
  MeshAdapt = 1, ///< slow, for difficult geometry
  Delaunay = 5,
  FrontalDelaunay = 6 ///< good triangles also where sizes change
};

/// gmsh has no mesh although scripts and deck are as they should be: another algorithm or other lengths may help.
class RemeshFailure final : public InputError
{
public:
  using InputError::InputError; ///< with the place in the deck
};

/// Makes the meshes of all bodies anew, by gmsh from the script of each.
///
/// Boundaries are those of the script, curved ones too: vertices lie on them, and its points are vertices. Sizes and
/// size fields of the script give way. Where lengths grow by more than half of the distance they are made smaller.
/// Vertices of matching sides are equal bit by bit: the shorter of both lengths counts. In the plane a body takes the
/// vertices of the bodies before it; solids of one script are meshed as one, with the same triangles on every face that
/// they share there (backgrounds have the same vertices on it).
/// gmsh works in a child process, 0.1 s and some 25 microseconds a cell; a second call makes the same meshes.
/// Limits: in the plane what the script makes Transfinite or puts into a boundary layer stays as it is, and a curve of
/// a matching side has two ends. Solids that match are of one script.
///
/// Throws InputError with the place of the body's mesh in the deck: scripts that cannot be read, more memory than is
/// free, more processor time than the scripts may take, boundaries of matching sides with different corners, matching
/// solids without a common face; where gmsh gives up, RemeshFailure with its own messages.
std::vector<Mesh> remesh(const std::vector<MeshScript>& scripts, const std::vector<MatchingSides>& matching,
                         const std::vector<WantedMesh>& wanted,
                         GmshAlgorithm algorithm = GmshAlgorithm::FrontalDelaunay);

/// The facets of matching sides that lie on each other, to a tenth of their length. In the plane.
std::vector<FacetTwin> twinsOf(const std::vector<Mesh>& meshes, const std::vector<MatchingSides>& matching);

/// The facets on the boundaries of different solids that have the same vertices, bit by bit.
std::vector<FacetTwin> commonFacets(const std::vector<Mesh>& meshes);

} // namespace ndframe
