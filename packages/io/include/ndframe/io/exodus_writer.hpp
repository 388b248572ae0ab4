#pragma once

#include <string>
#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/fem/node_map.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// One scalar variable with its values.
struct NamedField
{
  std::string name; ///< of the variable
  Vector values;    ///< as many as ExodusStep says
};

/// Some cells of a body, an element block of their own.
struct ExodusPart
{
  std::string name;       ///< of the block, "BODY:REGION"
  std::vector<int> cells; ///< of the body's mesh, in the order of the block
};

/// One body becomes one element block, or one for each of its parts; its named sides become side sets "BODY:SIDE" (node
/// numbers and element numbers of the bodies follow each other).
struct ExodusBody
{
  /// Of the block, if it has no parts, and in those of its side sets; empty: these are called like the sides.
  std::string name;
  const Mesh* mesh = nullptr;      ///< not owned; has the sides
  const NodeMap* nodes = nullptr;  ///< not owned; nodes and cells of this mesh, at least one cell
  std::vector<ExodusPart> parts{}; ///< every cell in one of them; none: the body is one block
};

/// A side set that carries variables: the contact interface as seen from one body.
struct ExodusContactSide
{
  std::string name;          ///< of the side set, e.g. the interface's
  int body = 0;              ///< index into the bodies
  std::vector<Facet> facets; ///< of the body's mesh; a side set without any carries no variables
};

/// The values of one step. Every body has the same nodal and the same element variables, every contact side the same
/// side-set variables.
struct ExodusStep
{
  double time = 0.0;                                ///< number of the sweep, level or load case
  std::vector<std::vector<NamedField>> nodal;       ///< per body, one value per node
  std::vector<std::vector<NamedField>> element;     ///< per body, one value per cell
  std::vector<std::vector<NamedField>> contactSide; ///< per contact side, one value per facet
  std::vector<NamedField> global;                   ///< one value each
};

/// Writes an Exodus II file (NetCDF-3, 64-bit offset): TRI3/TRI6/TETRA4/TETRA10 blocks, side sets of all named sides,
/// contact side sets with variables, several steps. `path` is written as it is: wrap in writeAtomically. Throws
/// std::runtime_error with the library's reason.
///
/// The format's limits: the title is cut after 80 bytes; a longer info line goes on in the next record after a
/// backslash; names of more than 255 bytes and more than 2^31 - 1 nodes or elements are refused.
void writeExodus(const std::string& path, const std::string& title, const std::vector<ExodusBody>& bodies,
                 const std::vector<ExodusContactSide>& contactSides, const std::vector<ExodusStep>& steps,
                 const std::vector<std::string>& infoLines);

} // namespace ndframe
