#include "part_graph.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace ndframe
{

PartGraph::PartGraph(const BodyPiece& piece, const CellTree& own, const Comm& comm) : own_(int(own.parts().size()))
{
  first_ = int(beforeAndAll(own_, comm)[0]);
  Vector measures;
  for (const CellTree::Part& part : own.parts())
    measures.push_back(cellMeasure(piece.model.mesh, part.cells.front()));
  measures = gatheredFrom(measures, comm);
  findJoints(piece, own, comm);
  for (std::vector<int>* list : {&parent_, &root_, &joint_})
    list->assign(measures.size(), -1);
  std::vector<int> largestFirst(measures.size());
  std::iota(largestFirst.begin(), largestFirst.end(), 0);
  std::stable_sort(largestFirst.begin(), largestFirst.end(),
                   [&](int a, int b) { return measures[std::size_t(a)] > measures[std::size_t(b)]; });
  for (const int part : largestFirst)
    if (root(part) < 0)
      hang(part);
}

/// The largest facet of two parts that touch, where what passes makes the least stress; the rank that has the one with
/// the smaller number names it.
void PartGraph::findJoints(const BodyPiece& piece, const CellTree& own, const Comm& comm)
{
  const int facets = piece.model.mesh.dim + 1;
  Vector partOf(piece.cells.size(), -1.0);
  for (std::size_t part = 0; part < own.parts().size(); ++part)
    for (const int cell : own.parts()[part].cells)
      partOf[std::size_t(cell)] = number(part);
  piece.shared.fetch([](int cell) { return SharedValues::Place{std::size_t(cell), 1}; }, partOf);
  const auto size = [&](int half) {
    double normal[3];
    const int cell = half / facets;
    return facetNormal(piece.model.mesh, {cell, own.cell(cell).local[std::size_t(half % facets)]}, normal);
  };
  std::map<std::pair<int, int>, int> found; // half facets
  for (const CellTree::Part& part : own.parts())
    for (const int cell : part.cells)
      for (int half = cell * facets; half < (cell + 1) * facets; ++half) {
        const int other = own.twin(half) < 0 ? -1 : own.twin(half) / facets;
        if (other < 0 || piece.owns(other) || partOf[std::size_t(other)] < partOf[std::size_t(cell)])
          continue;
        const std::pair<int, int> both{partOf[std::size_t(cell)], partOf[std::size_t(other)]};
        int& largest = found.emplace(both, half).first->second;
        if (size(half) > size(largest))
          largest = half;
      }
  Vector named;
  for (const auto& [parts, half] : found)
    named.insert(named.end(), {double(parts.first), double(parts.second),
                               double(piece.numbers[std::size_t(half / facets)]), double(half % facets)});
  named = gatheredFrom(named, comm);
  for (std::size_t at = 0; at < named.size(); at += 4)
    joints_.push_back({int(named[at]), int(named[at + 1]), std::int64_t(named[at + 2]), int(named[at + 3])});
}

void PartGraph::hang(int start)
{
  std::vector<int> tree{start};
  root_[std::size_t(start)] = start;
  for (std::size_t at = 0; at < tree.size(); ++at)
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const Joint& joint = joints_[j];
      if (joint.low != tree[at] && joint.high != tree[at])
        continue;
      const int other = joint.low == tree[at] ? joint.high : joint.low;
      if (root(other) >= 0)
        continue;
      root_[std::size_t(other)] = start;
      parent_[std::size_t(other)] = tree[at];
      joint_[std::size_t(other)] = int(j);
      tree.push_back(other);
    }
  order_.insert(order_.end(), tree.begin(), tree.end());
}

int PartGraph::exit(int part, const BodyPiece& piece, const CellTree& tree) const
{
  const Joint& joint = joints_[std::size_t(joint_[std::size_t(part)])];
  const int half = piece.held(joint.cell) * (piece.model.mesh.dim + 1) + joint.facet;
  return joint.low == part ? half : tree.twin(half);
}

} // namespace ndframe
