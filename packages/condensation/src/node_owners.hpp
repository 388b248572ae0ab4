#pragma once

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Per body the owner of each node, as ranks share the matrices' rows. Bodies that are solved together are shared out
/// as one graph, of their vertices: both partners of a contact pair are one, and the middle of an edge goes with one of
/// its ends. Other bodies are shared out one by one. Every rank computes the same.
class NodeOwners
{
public:
  NodeOwners(const Model& model, int ranks);

  /// The nodes of a body that a rank owns, ascending.
  std::vector<int> ownedBy(int rank, int body) const;
  /// Of the vertices of a body.
  std::vector<int> ofVertices(const Model& model, int body) const;

private:
  std::vector<std::vector<int>> ranks_; ///< per body and node
};

} // namespace ndframe
