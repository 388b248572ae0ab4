#pragma once

namespace ndframe
{

/// A program in Python that reads a mesh by meshio and writes it as a .msh file: arguments FILE OUTPUT MESSAGE.
///
/// Sets of cells (of MED: groups; of VTU: integer cell data, "NAME VALUE") become physical groups of their dimension,
/// sets of points and, of .inp files, surfaces that name sets of elements become groups of the boundary's facets.
/// Cells are written by their vertices. Exit code 3: it is refused, for the reason in MESSAGE.
extern const char* const meshioScript;

} // namespace ndframe
