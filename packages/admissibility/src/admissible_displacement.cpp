#include "ndframe/admissibility/admissible_displacement.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interface_pairs.hpp"
#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/assembly/fields.hpp"

namespace ndframe
{
namespace
{

/// Openings that are negative by less, relative to displacements and gaps on the interface, are round-off.
constexpr double roundOff = 1e-14;

class Admission
{
public:
  Admission(const std::vector<const BodyModel*>& bodies, const std::vector<const ConstraintSet*>& constraints,
            const std::vector<ContactPatch>& patches, const GapBound& gap, AdmissibleDisplacement& result)
      : bodies_(bodies), patches_(patches), result_(result),
        pairs_(bodies, constraints, patches, gap, result.displacement), tolerance_(roundOff * pairs_.size())
  {}

  /// Opens all pairs; where interfaces share nodes again and again, as long as what opens one closes another.
  void openAll()
  {
    constexpr int mostRounds = 100;
    const int rounds = pairs_.areShared() ? mostRounds : 1;
    for (int round = 0, moved = -1; round < rounds && moved < result_.moved; ++round) {
      moved = result_.moved;
      open(false);
      open(true);
      openBetween();
    }
  }

private:
  /// Opens every vertex or every middle where the bodies overlap. Middles after vertices: their Bernstein coefficient
  /// depends on them.
  void open(bool middles)
  {
    for (const auto& entry : pairs_.all())
      if (entry.second.isMiddle == middles)
        separate(entry.second);
  }

  /// Where the normal turns along patches of order 1, the inner coefficient belongs to both vertices: they open
  /// together.
  void openBetween()
  {
    for (std::size_t f = 0; f < patches_.size(); ++f)
      for (int e = 0; patches_[f].turns && bodies_.front()->nodes.order == 1 && e < facetEdges(patches_[f].dim).size;
           ++e)
        separateBetween(f, std::size_t(e));
  }

  void separate(const Pair& pair);
  void separateBetween(std::size_t patch, std::size_t edge);
  void move(const Pair& pair, const Compliance& apart, double force);
  void refuse(const Pair& pair, double excess);

  const std::vector<const BodyModel*>& bodies_;
  const std::vector<ContactPatch>& patches_;
  AdmissibleDisplacement& result_;
  InterfacePairs pairs_;
  double tolerance_;
};

void Admission::refuse(const Pair& pair, double excess)
{
  const BodyModel& body = *bodies_[pair.body[0]];
  result_.caveat +=
      fmt::format("{} and {} overlap by {:.2g} at {}, where supports hold both. ", body.name,
                  bodies_[pair.body[1]]->name, excess, pointText(body.nodes.point(pair.node[0]).data(), body.mesh.dim));
}

void Admission::move(const Pair& pair, const Compliance& apart, double force)
{
  const auto dim = std::size_t(bodies_.front()->mesh.dim);
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t k = 0; k < dim; ++k)
      result_.displacement[pair.body[side]][std::size_t(pair.node[side]) * dim + k] += force * apart.move[side][k];
  ++result_.moved;
}

void Admission::separate(const Pair& pair)
{
  double largest = 0.0, force = 0.0;
  for (const Corner& corner : pair.corners)
    for (const std::size_t k : pairs_.decided(corner))
      largest = std::max(largest, pairs_.excess(corner.patch, k));
  if (largest <= tolerance_)
    return;
  const Compliance apart = pairs_.compliance(pair);
  for (const Corner& corner : pair.corners)
    for (const std::size_t k : pairs_.decided(corner)) {
      const double needed = pairs_.excess(corner.patch, k);
      const double gain = apart.gain(pairs_.coefficients(corner.patch).weight(k, corner.number));
      if (needed > 0.0 && gain <= 0.0)
        return refuse(pair, needed);
      if (needed > 0.0)
        force = std::max(force, needed / gain);
    }
  move(pair, apart, force);
}

void Admission::separateBetween(std::size_t patch, std::size_t edge)
{
  const std::size_t between = pairs_.coefficients(patch).alongEdge(edge, false).front();
  const double needed = pairs_.excess(patch, between);
  if (needed <= tolerance_)
    return;
  std::array<const Pair*, 2> ends{};
  std::array<Compliance, 2> apart{};
  double gain = 0.0;
  for (std::size_t end = 0; end < 2; ++end) {
    const auto vertex = std::size_t(facetEdges(patches_[patch].dim).ends[edge][end]);
    ends[end] = &pairs_.all().at(patches_[patch].pairs[vertex]);
    apart[end] = pairs_.compliance(*ends[end]);
    gain += apart[end].gain(pairs_.coefficients(patch).weight(between, vertex));
  }
  if (gain <= 0.0)
    return refuse(*ends[0], needed);
  for (std::size_t end = 0; end < 2; ++end)
    move(*ends[end], apart[end], needed / gain);
}

} // namespace

void agreeAtContact(const std::vector<const BodyModel*>& bodies, const std::vector<ContactPatch>& patches,
                    AdmissibleDisplacement& admissible, const Comm& parts)
{
  if (parts.size() == 1)
    return;
  Vector values{double(admissible.moved)};
  const auto visit = [&](const auto& take) {
    for (const ContactPatch& patch : patches)
      for (const PatchSide& side : patch.sides) {
        const BodyModel& body = *bodies[std::size_t(side.body)];
        const FacetNodes nodes = contactNodes(body, side);
        for (std::size_t i = 0; !body.isRigid && i < patch.numNodes(body.nodes.order); ++i)
          for (int k = 0; k < body.mesh.dim; ++k)
            take(admissible.displacement[std::size_t(side.body)]
                                        [std::size_t(nodes[i]) * std::size_t(body.mesh.dim) + std::size_t(k)]);
      }
  };
  visit([&](double value) { values.push_back(value); });
  parts.broadcast(values);
  parts.broadcast(admissible.caveat);
  auto next = values.begin();
  admissible.moved = int(*next++);
  visit([&](double& value) { value = *next++; });
}

double changeInEnergy(const std::vector<const BodyModel*>& bodies, const std::vector<NodalField>& from,
                      const std::vector<NodalField>& to, const Comm& parts)
{
  double square = 0.0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    Vector change = to[b];
    for (std::size_t i = 0; i < change.size(); ++i)
      change[i] -= from[b][i];
    for (const double energy : cellEnergies(*bodies[b], change, countedCells(*bodies[b])))
      square += energy;
  }
  Vector sum{square};
  parts.sum(sum);
  return std::sqrt(sum.front());
}

AdmissibleDisplacement admitDisplacement(const std::vector<const BodyModel*>& bodies,
                                         const std::vector<const ConstraintSet*>& constraints,
                                         const std::vector<ContactPatch>& patches, const GapBound& gap,
                                         const std::vector<NodalField>& displacement, const Comm& parts)
{
  AdmissibleDisplacement result{displacement, 0.0, 0, {}};
  Admission admission(bodies, constraints, patches, gap, result);
  admission.openAll();
  agreeAtContact(bodies, patches, result, parts);
  if (result.moved > 0)
    result.charge = changeInEnergy(bodies, displacement, result.displacement, parts);
  return result;
}

} // namespace ndframe
