#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{

/// The edges (pairs of vertices) on which a file format puts the nodes that follow the vertices of a second-order
/// simplex.
using MidNodes = std::array<std::array<int, 2>, 6>;

/// Makes a mesh of a file's cells and sides: keeps the vertices, orients the cells, drops points that no cell uses.
/// Throws FileError for what a mesh cannot be made of.
class MeshBuilder
{
public:
  /// coordinates: three per node (dim 2: the third is constant).
  MeshBuilder(int dim, std::vector<double> coordinates);

  /// nodes: nodesPerCell node indices per cell, vertices first, then (second order) those on the edges `midNodes`;
  /// numbers: what the file calls the cells; groups: those that they belong to.
  void addCells(const std::vector<int>& nodes, int nodesPerCell, const std::vector<std::int64_t>& numbers,
                const MidNodes& midNodes, std::vector<std::string> groups);
  /// Keeps the first of cells with the same vertices, in the groups of all of them. Only before the first side.
  void dropRepeatedCells();
  /// A side by the cells added so far; facets named twice are taken once.
  void addSide(std::string name, std::vector<Facet> facets);
  void addNote(std::string note) { mesh_.notes.push_back(std::move(note)); }

  /// The cells so far; their points are still those of the file (three coordinates each).
  const Mesh& cells() const { return mesh_; }
  int numNodes() const { return int(coordinates_.size() / 3); }

  /// The checked mesh.
  Mesh finish();

private:
  void joinGroups(const VertexTuples& cells, int first, int end);
  double distanceFromMiddle(int mid, int a, int b) const;
  void dropUnusedPoints();
  void requirePlane() const;
  void orient();
  void turnAround();
  void noteCurvedEdges();
  [[noreturn]] void failInverted(int count, int first) const;

  Mesh mesh_;
  std::vector<double> coordinates_;
  std::vector<std::int64_t> numbers_;
  std::vector<bool> seenMid_; ///< by node: its edge has been measured; empty for first-order meshes
  int curvedEdges_ = 0;
  double largestMove_ = 0.0;
};

} // namespace ndframe
