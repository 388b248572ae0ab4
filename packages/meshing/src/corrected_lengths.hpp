#pragma once

#include "length_field.hpp"
#include "ndframe/meshing/remesh.hpp"

namespace ndframe
{

/// The lengths for which gmsh's tetrahedra have on average the measures of regular ones with the wanted lengths, by a
/// mesh that it made with `given`: at the vertices of that mesh.
///
/// gmsh's cells are too large where sizes hardly change and too small where they fall towards an edge, by 1.5 times
/// their volume each; a mesh then takes a quarter more dofs.
WantedMesh correctedLengths(const LengthField& wanted, const LengthField& given, const Mesh& made);

} // namespace ndframe
