#include "interface_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/admissibility/contact_nodes.hpp"

namespace ndframe
{

InterfacePairs::InterfacePairs(const std::vector<const BodyModel*>& bodies,
                               const std::vector<const ConstraintSet*>& constraints,
                               const std::vector<ContactFacet>& facets, const GapBound& gap,
                               const std::vector<Vector>& displacement)
    : bodies_(bodies), constraints_(constraints), facets_(facets), gap_(gap), displacement_(displacement),
      uses_(bodies.size()), stiffness_(bodies.size())
{
  for (const double g : gap.bernstein)
    size_ = std::max(size_, std::abs(g));
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const std::array<std::size_t, 2> body{std::size_t(facets[f].dirichletBody), std::size_t(facets[f].neumannBody)};
    const std::array<FacetNodes, 2> nodes{contactNodes(*bodies[body[0]], facets[f], true),
                                          contactNodes(*bodies[body[1]], facets[f], false)};
    const auto dim = std::size_t(facets[f].dim);
    for (std::size_t i = 0; i < std::size_t(bodies[body[0]]->nodes.nodesPerFacet); ++i) {
      Pair& pair = pairs_[facets[f].pairs[i]];
      pair.body = body;
      pair.node = {nodes[0][i], nodes[1][i]};
      pair.corners.push_back({f, i});
      pair.isMiddle = i >= dim;
      for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t k = 0; k < dim; ++k)
          size_ = std::max(size_, std::abs(displacement[body[side]][std::size_t(pair.node[side]) * dim + k]));
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

JumpCoefficients InterfacePairs::coefficients(std::size_t facet) const
{
  return {facets_[facet], bodies_.front()->nodes.order};
}

std::vector<std::size_t> InterfacePairs::decided(const Corner& corner) const
{
  const JumpCoefficients jump = coefficients(corner.facet);
  if (corner.number < std::size_t(facets_[corner.facet].dim))
    return {jump.atVertex(corner.number)};
  return jump.atMiddle(corner.number);
}

double InterfacePairs::excess(std::size_t facet, std::size_t coefficient) const
{
  const std::size_t size = gap_.bernstein.size() / facets_.size();
  const JumpCoefficients jump = coefficients(facet);
  return jump.of(coefficient, closing(bodies_, facets_[facet], displacement_)) -
         jump.gap(coefficient, gap_.bernstein.data() + facet * size);
}

const NodeStiffness& InterfacePairs::stiffness(std::size_t body)
{
  if (stiffness_[body].empty())
    stiffness_[body] = interfaceStiffness(*bodies_[body], facets_, int(body));
  return stiffness_[body];
}

Compliance InterfacePairs::compliance(const Pair& pair)
{
  Direction normal{};
  const auto node = [&](const Corner& corner) { return facets_[corner.facet].nodes[corner.number]; };
  const bool isCorner = node(pair.corners.front()) != node(pair.corners.back());
  for (const Corner& corner : pair.corners)
    for (std::size_t k = 0; k < 3; ++k) // at a corner the bisector, which opens both flanks whatever their lengths
      normal[k] += (isCorner ? 1.0 : facets_[corner.facet].measure) * facets_[corner.facet].normalAt(corner.number)[k];
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
      result.move[side][k] = (side == 0 ? -factor : factor) * free[k];
  }
  return result;
}

} // namespace ndframe
