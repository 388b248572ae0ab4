#pragma once

#include <vector>

#include "ndframe/equilibrium/row_reduction.hpp"
#include "ndframe/equilibrium/star_data.hpp"
#include "ndframe/equilibrium/star_flow.hpp"
#include "ndframe/equilibrium/star_wrench.hpp"

namespace ndframe
{

/// Tractions of a spoke as they depend on the unknowns:  dT = columns u[unknowns].
struct SpokeColumns
{
  std::vector<int> unknowns;
  DenseMatrix columns; ///< facet data x unknowns.size(); outward for the spoke's first cell
};

/// The balance of the cells of a star, by construction.
///
/// Wrenches about the star's vertex add up, so they flow from cell to cell like a current: cells are the nodes of a
/// graph, interior spokes its edges, supported boundary spokes edges to the ground. Edges outside a spanning tree carry
/// a free wrench, ground edges a free traction along the supported directions; the tree carries what is left. What the
/// ground can take is found by elimination (rank decisions by rigidTolerance). Self-equilibrated modes are free.
///
/// Unknowns u: free wrenches, free reactions, self-equilibrated modes, and last the numReleased() released tractions.
class StarBalance
{
public:
  StarBalance(const StarBody& body, Star star, const std::vector<ReleasedFacet>& released);

  const StarBody& body() const { return *body_; }
  const Star& star() const { return star_; }
  int numUnknowns() const { return numUnknowns_; }
  int numReleased() const { return numReleased_; }
  const std::vector<SpokeColumns>& spokes() const { return spokes_; }
  /// E du = 0 for the released tractions.
  DenseMatrix conditions() const;
  /// Adds to x what brings every cell into balance; per field the norm of the wrench that nothing takes (left in one
  /// cell).
  Vector balance(StarFields& x) const;

private:
  void splitSpokes();
  void eliminateReactions();
  int numFlows() const { return int(chords_.size()) * wrenchSize(body_->dim()) + int(ground_.size()); }
  int groundFlow(std::size_t ground) const { return int(chords_.size()) * wrenchSize(body_->dim()) + int(ground); }
  Vector wrench(const GroundTraction& traction) const;
  std::vector<DenseMatrix> unitFlows() const;
  void addFlow(int flow, const double* traction, DenseMatrix& columns) const;
  DenseMatrix flowColumns(int spoke, const DenseMatrix& flows) const;
  DenseMatrix ownColumns(int spoke) const;
  void numberUnknowns();
  DenseMatrix imbalance(int cell, const StarFields& x) const;
  void addReactions(StarFields& x, std::vector<DenseMatrix>& needed) const;

  const StarBody* body_;
  Star star_;
  SpanningTree tree_;
  std::vector<FacetSplit> splits_;     ///< per spoke
  std::vector<DenseMatrix> loadMaps_;  ///< per cell: the wrench of its loads
  std::vector<int> chords_;            ///< interior spokes outside the tree
  std::vector<GroundTraction> ground_; ///< reactions with a wrench, then the released tractions
  std::vector<GroundTraction> held_;   ///< reactions without a wrench
  RowReduction reduction_;             ///< of [ wrenches of ground_ | identity ]
  std::vector<int> columnOfFlow_;      ///< flows: wrenches of the chords, then ground_; -1 for dependent reactions
  int numReleased_ = 0, numFree_ = 0, numUnknowns_ = 0;
  std::vector<SpokeColumns> spokes_;
};

} // namespace ndframe
