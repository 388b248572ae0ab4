#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "ndframe/mesh/bisection.hpp"

namespace ndframe::test
{

/// Bodies as they stand beside each other before a bisection.
struct Bodies
{
  std::string name;
  std::vector<Mesh> meshes;
};
void PrintTo(const Bodies& bodies, std::ostream* stream);

/// Boxes in all patterns, graded, rotated, bent and with stretched cells, one to four of them, triangles all of whose
/// edges are equal, and bodies from a gmsh file.
const std::vector<Bodies>& bisectionScenes();

/// Two boxes all of whose cells are half squares: nothing is to be mended there.
const std::vector<Bodies>& squareScenes();

/// n x n equal rhombi of two equilateral triangles each: all edges are equally long.
Mesh equilateral(int n);

/// The facets with one cell.
std::vector<Facet> boundaryOf(const Mesh& mesh);
double boundaryLength(const Mesh& mesh);

/// Boundary facets of different meshes with ends at the same places up to round-off, found by trying all.
std::vector<FacetTwin> findTwins(const std::vector<Mesh>& meshes);
/// Length of the first facets of the twins.
double lengthOf(const std::vector<FacetTwin>& twins, const std::vector<Mesh>& meshes);

/// Numbers of halvings below `limit`, mostly 0.
std::vector<std::vector<int>> randomHalvings(const std::vector<Mesh>& meshes, unsigned seed, int limit = 4);
std::vector<std::vector<int>> sameHalvings(const std::vector<Mesh>& meshes, int number);
/// `number` halvings of the cells that touch the place and none of others.
std::vector<std::vector<int>> halvingsAt(const std::vector<Mesh>& meshes, double x, double y, int number);

/// The corners of every cell, beginning with the leftmost, the cells in ascending order: the same for any numbering.
std::vector<std::vector<double>> cornersOf(const Mesh& mesh);

double smallestAngle(const Mesh& mesh, int cell);

} // namespace ndframe::test
