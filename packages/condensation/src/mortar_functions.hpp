#pragma once

#include <array>
#include <map>
#include <vector>

#include "ndframe/algebra/sparse_row.hpp"
#include "ndframe/interface/interface_mesh.hpp"

namespace ndframe
{

/// The functions of an interface whose contact is asked in means (MortarSpace): on each facet of the side that had more
/// facets before they were cut a polynomial of the elements' order, continuous along the side. Where a part of a facet
/// faces nothing the rest of it is the facet. In Lagrange's form or in Bernstein's.
///
/// Limit: two dimensions.
class MortarFunctions
{
public:
  MortarFunctions(const InterfaceMesh& interface, const std::vector<BodyModel>& bodies, bool isBernstein);

  int size() const { return int(nodes_.size()); }                  ///< number of functions
  const std::vector<SparseRow>& values() const { return values_; } ///< per interface node, by functions
  const std::vector<int>& nodes() const { return nodes_; }         ///< the node of a function, -1 where it has none
  bool differ() const { return differ_; }                          ///< some facet has several pieces

private:
  using Pieces = std::vector<int>; ///< of one facet, by their numbers in the interface

  void add(const Pieces& facet);
  std::array<int, 2> ends(const Pieces& facet, const Direction& along) const;
  SparseRow row(const std::array<int, 3>& number, double place) const;
  double placeOf(int node, const Direction& along) const;
  int numberAt(int node);

  const InterfaceMesh& interface_;
  bool isBernstein_, differ_ = false;
  ContactRole role_ = ContactRole::Dirichlet; ///< of the body whose nodes they stand at
  std::vector<SparseRow> values_;
  std::vector<int> nodes_;
  std::map<int, int> atNode_;
};

} // namespace ndframe
