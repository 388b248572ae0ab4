#include "product_nodes.hpp"

#include <algorithm>

#include "ndframe/algebra/ghosts.hpp"

namespace ndframe
{

namespace
{

/// Own nodes, the ghosts of their rows, and others.
IndexMap withOthers(const IndexMap& held, const IndexMap& others)
{
  if (held.isWhole())
    return held;
  std::vector<IndexMap::Global> owned, needed;
  for (int node = 0; node < held.size(); ++node)
    (held.owns(node) ? owned : needed).push_back(held.global(node));
  for (int node = 0; node < others.size(); ++node)
    needed.push_back(others.global(node));
  return {held.globalSize(), std::move(owned), std::move(needed)};
}

} // namespace

ProductNodes::ProductNodes(const RankProblem& problem, const LinearInterpolation& P, const IndexMap& received,
                           const Comm& comm)
    : nodes_(withOthers(problem.matrix->nodes, received)), blocksSize_(2 * std::size_t(P.dim) * std::size_t(P.dim)),
      turned_(P.turned), blocks_(P.turnedBlocks)
{
  for (int node = 0; node < nodes_.numOwned(); ++node) {
    int flags = 0;
    for (int i = 0; i < P.dim; ++i)
      flags |= int(problem.role(node, i) != DofRole::Interior) << i;
    flags_.push_back(static_cast<unsigned char>(flags | (P.blocks(node) ? isTurned : 0)));
  }
  Vector anyTurned{double(!P.turnedBlocks.empty())};
  takeLargest(anyTurned, comm);
  const Vector facts = factsOfAll(problem, P, anyTurned.front() > 0.0, comm);
  if (anyTurned.front() > 0.0)
    turned_.resize(std::size_t(nodes_.numOwned()), -1);
  std::vector<std::array<Global, 2>> ghostEnds;
  const std::size_t width = 3 + (anyTurned.front() > 0.0 ? blocksSize_ : 0);
  for (auto node = std::size_t(nodes_.numOwned()); node < std::size_t(nodes_.size()); ++node) {
    const double* fact = facts.data() + node * width;
    flags_.push_back(static_cast<unsigned char>(fact[0]));
    ghostEnds.push_back({Global(fact[1]), Global(fact[2])});
    if (width == 3)
      continue;
    const bool hasBlocks = (flags_.back() & isTurned) != 0;
    turned_.push_back(hasBlocks ? int(blocks_.size() / blocksSize_) : -1);
    if (hasBlocks)
      blocks_.insert(blocks_.end(), fact + 3, fact + width);
  }
  number(P, ghostEnds);
}

/// Per node flags, ends and blocks, those of ghosts from their owners; empty on one rank.
Vector ProductNodes::factsOfAll(const RankProblem& problem, const LinearInterpolation& P, bool anyTurned,
                                const Comm& comm) const
{
  Vector facts;
  if (comm.size() == 1)
    return facts;
  const std::size_t width = 3 + (anyTurned ? blocksSize_ : 0);
  facts.resize(std::size_t(nodes_.size()) * width, 0.0);
  for (int node = 0; node < problem.matrix->numRows(); ++node) {
    double* fact = facts.data() + std::size_t(node) * width;
    *fact++ = double(flags_[std::size_t(node)]);
    for (const int end : P.ends[std::size_t(node)])
      *fact++ = double(P.vertices.global(end)); // exact up to 2^53
    if (const double* blocks = P.blocks(node))
      std::copy_n(blocks, blocksSize_, fact);
  }
  sharedGhosts(nodes_, comm)
      .fetch(
          [width](int node) {
            return SharedValues::Place{std::size_t(node) * width, width};
          },
          facts);
  return facts;
}

void ProductNodes::number(const LinearInterpolation& P, const std::vector<std::array<Global, 2>>& ghostEnds)
{
  vertices_ = P.vertices;
  ends_ = P.ends;
  if (P.vertices.isWhole() && ghostEnds.empty())
    return;
  std::vector<Global> owned, needed;
  for (int vertex = 0; vertex < P.vertices.size(); ++vertex)
    (P.vertices.owns(vertex) ? owned : needed).push_back(P.vertices.global(vertex));
  for (const auto& ends : ghostEnds)
    needed.insert(needed.end(), ends.begin(), ends.end());
  vertices_ = IndexMap(P.vertices.globalSize(), std::move(owned), std::move(needed));
  for (auto& ends : ends_)
    for (int& end : ends)
      end = vertices_.local(P.vertices.global(end));
  for (const auto& [a, b] : ghostEnds)
    ends_.push_back({vertices_.local(a), vertices_.local(b)});
}

} // namespace ndframe
