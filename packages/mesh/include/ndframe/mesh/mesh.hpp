#pragma once

#include <array>
#include <string>
#include <vector>

namespace ndframe
{

/// A facet by its cell and its number there: local facet k is the one opposite to local vertex k.
struct Facet
{
  int cell;  ///< number in its mesh
  int local; ///< 0 to dim
};

/// A named part of the boundary.
struct Side
{
  std::string name;          ///< as decks call it
  std::vector<Facet> facets; ///< of the boundary, each once
};

/// The named groups of cells of a mesh. Groups may overlap; cells are of one kind when they belong to the same groups.
struct CellGroups
{
  std::vector<std::vector<std::string>> names; ///< per kind: the groups that its cells belong to, sorted
  std::vector<int> kind;                       ///< per cell; empty when the mesh has no groups

  /// Of cells that may be of different kinds.
  bool sameKind(int a, int b) const { return kind.empty() || kind[std::size_t(a)] == kind[std::size_t(b)]; }
  bool has(const std::string& name) const; ///< cells of some kind belong to this group
  /// Per kind whether its cells belong to one of these groups.
  std::vector<char> kindsIn(const std::vector<std::string>& groups) const;
  /// Number of the kind of cells that belong to these groups (in any order), which is added when it is new.
  int findOrAdd(std::vector<std::string> groups);
  /// The kinds of new cells that take the place of old ones.
  void inherit(const std::vector<int>& parents);
};

/// Straight-sided simplices: triangles (dim 2) or tetrahedra (dim 3), given by their vertices only.
///
/// Nodes of higher order belong to the dof map (fem). Cells are positively oriented (checked by checkMesh).
/// Every rank holds the whole mesh.
struct Mesh
{
  int dim = 0;                ///< 2 or 3; 0: no mesh
  std::vector<double> points; ///< dim * numPoints, point by point
  std::vector<int> cells;     ///< (dim + 1) * numCells, cell by cell
  std::vector<Side> sides;    ///< names differ; a facet may be on several
  std::vector<std::string>
      notes;           ///< what a user should know about how the mesh was read (e.g. curved edges straightened)
  CellGroups groups{}; ///< of the cells

  int numPoints() const { return dim == 0 ? 0 : int(points.size()) / dim; }     ///< vertices
  int numCells() const { return dim == 0 ? 0 : int(cells.size()) / (dim + 1); } ///< triangles or tetrahedra
  const double* point(int i) const { return points.data() + std::size_t(i) * std::size_t(dim); } ///< dim coordinates
  const int* cell(int c) const { return cells.data() + std::size_t(c) * std::size_t(dim + 1); }  ///< dim + 1 vertices
  const Side* findSide(const std::string& name) const; ///< null if there is none
};

/// Coordinates of a cell's vertices, one after the other: (dim + 1) x dim.
void cellPoints(const Mesh& mesh, int cell, double* points);

/// Vertices of a facet in increasing local number (dim of them).
void facetVertices(const Mesh& mesh, Facet facet, int* vertices);

/// Outward unit normal of a facet (dim components); returns its measure (length or area).
double facetNormal(const Mesh& mesh, Facet facet, double* normal);

/// Mean of a cell's, or a facet's, vertices; zeros beyond dim.
std::array<double, 3> cellCentre(const Mesh& mesh, int cell);
std::array<double, 3> facetCentre(const Mesh& mesh, Facet facet); ///< of its vertices

/// Signed measure of a cell (area or volume).
double cellMeasure(const Mesh& mesh, int cell);

/// Everything wrong with a mesh that a solver could not cope with, one sentence each: no cells, vertex numbers out of
/// range, coordinates that are not finite, cells that are inverted, degenerate or too small for their distance from the
/// origin (how many, the first and where), points of no cell, facets shared by more than two cells, neighbours that
/// overlap, and of the sides: a name or a facet given twice, a facet that does not exist or is not on the boundary.
/// Empty when the mesh is sound. Bodies of several parts that do not touch are sound. A cell is degenerate when its
/// measure is below the round-off of its longest edge to the power dim, and too small when the round-off of its
/// coordinates is more than 1e-6 of its shortest edge.
std::vector<std::string> checkMesh(const Mesh& mesh);

/// Coordinates that are round-off of a mesh whose coordinates differ by `extent` become zero.
void dropRoundOff(std::vector<double>& coordinates, double extent);

/// Length of the diagonal of the bounding box.
double diameter(const Mesh& mesh);

} // namespace ndframe
