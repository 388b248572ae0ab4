#include "interface_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/admissibility/contact_nodes.hpp"

namespace ndframe
{

InterfacePairs::InterfacePairs(const std::vector<const BodyModel*>& bodies,
                               const std::vector<const ConstraintSet*>& constraints,
                               const std::vector<ContactPatch>& patches, const GapBound& gap,
                               const std::vector<NodalField>& displacement)
    : bodies_(bodies), constraints_(constraints), patches_(patches), gap_(gap), displacement_(displacement),
      uses_(bodies.size()), stiffness_(bodies.size())
{
  for (const double g : gap.bernstein)
    size_ = std::max(size_, std::abs(g));
  for (std::size_t f = 0; f < patches.size(); ++f) {
    const auto dim = patches[f].numVertices();
    for (std::size_t side = 0; side < 2; ++side) {
      const auto b = std::size_t(patches[f].sides[side].body);
      const FacetNodes nodes = contactNodes(*bodies[b], patches[f].sides[side]);
      for (std::size_t i = 0; i < patches[f].numNodes(bodies[b]->nodes.order); ++i) {
        Pair& pair = pairs_[patches[f].pairs[i]];
        pair.body[side] = b;
        pair.node[side] = nodes[i];
        pair.isMiddle = i >= dim;
        if (side == 0)
          pair.corners.push_back({f, i});
        for (std::size_t k = 0; k < dim; ++k)
          size_ = std::max(size_, std::abs(displacement[b][std::size_t(nodes[i]) * dim + k]));
      }
    }
  }
  for (const auto& entry : pairs_)
    for (std::size_t side = 0; side < 2; ++side)
      areShared_ = ++uses_[entry.second.body[side]][entry.second.node[side]] > 1 || areShared_;
}

bool InterfacePairs::isShared(const Pair& pair) const
{
  return areShared_ && (uses_[pair.body[0]].at(pair.node[0]) > 1 || uses_[pair.body[1]].at(pair.node[1]) > 1);
}

JumpCoefficients InterfacePairs::coefficients(std::size_t patch) const
{
  return {patches_[patch], bodies_.front()->nodes.order};
}

std::vector<std::size_t> InterfacePairs::decided(const Corner& corner) const
{
  const JumpCoefficients jump = coefficients(corner.patch);
  if (corner.number < patches_[corner.patch].numVertices())
    return {jump.atVertex(corner.number)};
  return jump.atMiddle(corner.number);
}

double InterfacePairs::excess(std::size_t patch, std::size_t coefficient) const
{
  const std::size_t size = gap_.bernstein.size() / patches_.size();
  const JumpCoefficients jump = coefficients(patch);
  return jump.of(coefficient, closing(bodies_, patches_[patch], displacement_)) -
         jump.gap(coefficient, gap_.bernstein.data() + patch * size);
}

const NodeStiffness& InterfacePairs::stiffness(std::size_t body)
{
  if (stiffness_[body].empty())
    stiffness_[body] = interfaceStiffness(*bodies_[body], patches_, int(body));
  return stiffness_[body];
}

Compliance InterfacePairs::compliance(const Pair& pair)
{
  Direction normal{};
  const auto node = [&](const Corner& corner) { return patches_[corner.patch].nodes[corner.number]; };
  const bool isCorner = node(pair.corners.front()) != node(pair.corners.back());
  for (const Corner& corner : pair.corners)
    for (std::size_t k = 0; k < 3; ++k) // at a corner the bisector, which opens both flanks whatever their lengths
      normal[k] +=
          (isCorner ? 1.0 : patches_[corner.patch].measure) * patches_[corner.patch].normalAt(corner.number)[k];
  const double length = std::sqrt(dotProduct(normal, normal));
  for (double& component : normal)
    component /= length;
  Compliance result;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t body = pair.body[side];
    const Direction free = constraints_[body]->freePart(pair.node[side], normal);
    if (dotProduct(free, free) == 0.0)
      continue;
    const NodeBlock& block = stiffness(body).at({pair.node[side], pair.node[side]});
    const double factor = dotProduct(free, free) / block.work(free, free);
    for (std::size_t k = 0; k < 3; ++k)
      result.move[side][k] = -sideSign(side) * factor * free[k];
  }
  return result;
}

} // namespace ndframe
