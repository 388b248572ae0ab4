#pragma once

#include <string>
#include <vector>

#include "ndframe/io/exodus_writer.hpp"

namespace ndframe
{

/// A side set of the file: a named side of a body, or a contact side with variables.
struct SideSet
{
  std::string name;
  int body;
  const std::vector<Facet>* facets;
  std::int64_t size; ///< how many facets the file has of it
};

/// An element block of the file: a body or a part of it.
struct ElementBlock
{
  std::string name;
  int body;
  const std::vector<int>* cells; ///< of the body; null: all
  int firstElement;              ///< of the file, from 0
  int numCells;                  ///< how many elements the file has of it
};

/// The bodies one after the other: what is numbered through the whole file.
struct ExodusLayout
{
  const std::vector<ExodusBody>* bodies;
  std::vector<int> firstNode{0}; ///< of each body, and one more: the number of all nodes
  std::vector<int> firstCell{0};
  std::vector<ElementBlock> blocks;
  std::vector<std::vector<int>> elements; ///< per body in parts: element of each cell; else empty
  std::vector<SideSet> sets;              ///< the named sides, then the contact sides
  std::size_t firstContact = 0;           ///< index of the first contact side in `sets`

  int dim() const { return bodies->front().nodes->dim; }
  int numNodes() const { return firstNode.back(); }
  int numCells() const { return firstCell.back(); }
  /// The element of the file, from 0.
  int element(int body, int cell) const
  {
    const auto& ofCells = elements[std::size_t(body)];
    return ofCells.empty() ? firstCell[std::size_t(body)] + cell : ofCells[std::size_t(cell)];
  }
  /// The library knows no variables on sets without facets.
  bool carriesVariables(std::size_t set) const { return set >= firstContact && sets[set].size > 0; }
  /// Throws std::runtime_error when 32-bit numbers cannot count the nodes or elements.
  void appendBody(std::int64_t numNodes, std::int64_t numCells);
};

/// Throws std::runtime_error when the bodies have more nodes or elements than 32-bit numbers can count.
/// The layout refers to its arguments.
ExodusLayout makeLayout(const std::vector<ExodusBody>& bodies, const std::vector<ExodusContactSide>& contactSides);

/// The names of the variables, the same in all steps and all bodies.
struct ExodusVariables
{
  std::vector<std::string> nodal, element, contactSide, global;
};

/// Asserts that all steps have the variables of the first, with one value per node, cell, facet.
ExodusVariables commonVariables(const ExodusLayout& layout, const std::vector<ExodusStep>& steps);

/// Length of the longest block, set or variable name.
std::size_t longestName(const ExodusLayout& layout, const ExodusVariables& variables);

} // namespace ndframe
