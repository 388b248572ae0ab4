#pragma once

#include "bisection_scenes.hpp"

namespace ndframe::test
{

/// Boxes of tetrahedra in both patterns, graded, turned, bent and with stretched cells, one to four of them, cubes from
/// a gmsh file, and a wild mesh.
const std::vector<Bodies>& solidScenes();

/// Cubes of 6 tetrahedra each: those of n^3 of them.
Mesh kuhnCubes(int n);

/// Tetrahedra by themselves with random corners.
std::vector<Mesh> randomTetrahedra(unsigned seed, int number);

double boundaryArea(const Mesh& mesh);

/// Boundary facets of different meshes with corners at the same places up to round-off.
std::vector<FacetTwin> findSolidTwins(const std::vector<Mesh>& meshes);

/// The corners of every cell, ascending, the cells in ascending order: the same for any numbering.
std::vector<std::vector<double>> sortedCorners(const Mesh& mesh);

} // namespace ndframe::test
