#include "ndframe/recovery/admissible_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "contact_nodes.hpp"
#include "ndframe/assembly/fields.hpp"
#include "node_stiffness.hpp"

namespace ndframe
{
namespace
{

/// Openings that are negative by less, relative to displacements and gaps on the interface, are round-off.
constexpr double roundOff = 1e-14;

/// A facet's node: number 0, 1 the vertices, 2 the middle.
struct Corner
{
  std::size_t facet;
  std::size_t number;
};

/// The two bodies at one interface node.
struct Pair
{
  std::array<std::size_t, 2> body{};
  std::array<int, 2> node{};
  std::vector<Corner> corners; ///< one facet for a middle, the facets of a vertex
};

/// How much an interface node's bodies give way along the mean normal, the stiffer one less: for a force of one between
/// them they move apart by `move`.
struct Compliance
{
  std::array<Direction, 2> move{};
  /// What the opening along a facet's normal gains.
  double gain(const Direction& normal) const { return dotProduct(move[1], normal) - dotProduct(move[0], normal); }
};

class Admission
{
public:
  Admission(const std::vector<const BodyModel*>& bodies, const std::vector<const ConstraintSet*>& constraints,
            const std::vector<ContactFacet>& facets, const GapBound& gap, AdmissibleDisplacement& result);

  /// Opens every node of this kind (vertices: 0, middles: 2) where the bodies overlap. Middles after vertices: their
  /// Bernstein coefficient depends on them.
  void open(std::size_t kind);

private:
  double jump(std::size_t facet, std::size_t number) const;
  double excess(const Corner& corner) const;
  Compliance compliance(const Pair& pair);
  void separate(const Pair& pair);
  void refuse(const Pair& pair, double excess);

  const std::vector<const BodyModel*>& bodies_;
  const std::vector<const ConstraintSet*>& constraints_;
  const std::vector<ContactFacet>& facets_;
  const GapBound& gap_;
  AdmissibleDisplacement& result_;
  std::map<int, Pair> pairs_; ///< by interface node
  double tolerance_ = 0.0;
  std::vector<NodeStiffness> stiffness_; ///< per body, found when first needed
};

Admission::Admission(const std::vector<const BodyModel*>& bodies, const std::vector<const ConstraintSet*>& constraints,
                     const std::vector<ContactFacet>& facets, const GapBound& gap, AdmissibleDisplacement& result)
    : bodies_(bodies), constraints_(constraints), facets_(facets), gap_(gap), result_(result), stiffness_(bodies.size())
{
  double size = 0.0;
  for (const double g : gap.bernstein)
    size = std::max(size, std::abs(g));
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const std::array<std::size_t, 2> body{std::size_t(facets[f].dirichletBody), std::size_t(facets[f].neumannBody)};
    const std::array<std::array<int, 3>, 2> nodes{contactNodes(*bodies[body[0]], facets[f], true),
                                                  contactNodes(*bodies[body[1]], facets[f], false)};
    for (std::size_t i = 0; i <= std::size_t(bodies[body[0]]->nodes.order); ++i) {
      Pair& pair = pairs_[facets[f].nodes[i]];
      pair.body = body;
      pair.node = {nodes[0][i], nodes[1][i]};
      pair.corners.push_back({f, i});
      for (std::size_t side = 0; side < 2; ++side)
        for (std::size_t k = 0; k < 2; ++k)
          size = std::max(size, std::abs(result.displacement[body[side]][std::size_t(pair.node[side]) * 2 + k]));
    }
  }
  tolerance_ = roundOff * size;
}

/// (u1 - u2) . n at a node of a facet.
double Admission::jump(std::size_t facet, std::size_t number) const
{
  const Pair& pair = pairs_.at(facets_[facet].nodes[number]);
  double value = 0.0;
  for (std::size_t k = 0; k < 2; ++k)
    value += facets_[facet].normal[k] * (result_.displacement[pair.body[0]][std::size_t(pair.node[0]) * 2 + k] -
                                         result_.displacement[pair.body[1]][std::size_t(pair.node[1]) * 2 + k]);
  return value;
}

/// How much the jump's Bernstein coefficient is above the gap's.
double Admission::excess(const Corner& corner) const
{
  const std::size_t size = gap_.bernstein.size() / facets_.size();
  const double* gap = gap_.bernstein.data() + corner.facet * size;
  if (corner.number == 2)
    return 2.0 * jump(corner.facet, 2) - 0.5 * (jump(corner.facet, 0) + jump(corner.facet, 1)) - gap[1];
  return jump(corner.facet, corner.number) - gap[corner.number * (size - 1)];
}

Compliance Admission::compliance(const Pair& pair)
{
  Direction normal{};
  for (const Corner& corner : pair.corners)
    for (std::size_t k = 0; k < 2; ++k)
      normal[k] += facets_[corner.facet].measure * facets_[corner.facet].normal[k];
  const double length = std::sqrt(dotProduct(normal, normal));
  for (double& component : normal)
    component /= length;
  Compliance result;
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t body = pair.body[side];
    const Direction free = constraints_[body]->freePart(pair.node[side], normal);
    if (dotProduct(free, free) == 0.0)
      continue;
    if (stiffness_[body].empty())
      stiffness_[body] = interfaceStiffness(*bodies_[body], facets_, int(body));
    const double factor = dotProduct(free, free) / stiffness_[body].at(pair.node[side]).along(free);
    for (std::size_t k = 0; k < 2; ++k)
      result.move[side][k] = (side == 0 ? -factor : factor) * free[k];
  }
  return result;
}

void Admission::refuse(const Pair& pair, double excess)
{
  const BodyModel& body = *bodies_[pair.body[0]];
  result_.caveat +=
      fmt::format("{} and {} overlap by {:.2g} at {}, where supports hold both. ", body.name,
                  bodies_[pair.body[1]]->name, excess, pointText(body.nodes.point(pair.node[0]), body.mesh.dim));
}

void Admission::separate(const Pair& pair)
{
  double largest = 0.0, force = 0.0;
  for (const Corner& corner : pair.corners)
    largest = std::max(largest, excess(corner));
  if (largest <= tolerance_)
    return;
  const Compliance apart = compliance(pair);
  for (const Corner& corner : pair.corners) {
    const double needed = excess(corner), gain = apart.gain(facets_[corner.facet].normal);
    if (needed > 0.0 && gain <= 0.0)
      return refuse(pair, needed);
    if (needed > 0.0)
      force = std::max(force, needed / gain * (corner.number == 2 ? 0.5 : 1.0));
  }
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t k = 0; k < 2; ++k)
      result_.displacement[pair.body[side]][std::size_t(pair.node[side]) * 2 + k] += force * apart.move[side][k];
  ++result_.moved;
}

void Admission::open(std::size_t kind)
{
  for (const auto& entry : pairs_)
    if ((entry.second.corners.front().number == 2) == (kind == 2))
      separate(entry.second);
}

double changeInEnergy(const std::vector<const BodyModel*>& bodies, const std::vector<Vector>& from,
                      const std::vector<Vector>& to)
{
  double square = 0.0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    Vector change = to[b];
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] -= from[b][i];
    for (const double energy : cellEnergies(*bodies[b], change))
      square += energy;
  }
  return std::sqrt(square);
}

} // namespace

AdmissibleDisplacement admitDisplacement(const std::vector<const BodyModel*>& bodies,
                                         const std::vector<const ConstraintSet*>& constraints,
                                         const std::vector<ContactFacet>& facets, const GapBound& gap,
                                         const std::vector<Vector>& displacement)
{
  AdmissibleDisplacement result{displacement, 0.0, 0, {}};
  Admission admission(bodies, constraints, facets, gap, result);
  admission.open(0);
  admission.open(2);
  if (result.moved > 0)
    result.charge = changeInEnergy(bodies, displacement, result.displacement);
  return result;
}

} // namespace ndframe
