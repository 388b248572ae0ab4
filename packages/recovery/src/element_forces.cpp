#include "element_forces.hpp"

#include <algorithm>

#include "ndframe/equilibrium/cell_stress.hpp"

namespace ndframe
{
namespace
{

/// sigma n times the length of the edge `facet`, at a sorted vertex.
Force tractionAt(const CellStress& stress, int facet, int vertex)
{
  double force[2] = {};
  addForce(stress, vertex, facet, -2.0 * stress.measure, force);
  return {force[0], force[1]};
}

/// int_E div sigma.
Force divergenceOf(const CellStress& stress)
{
  double force[2] = {};
  for (int vertex = 0; vertex < 3; ++vertex)
    addForce(stress, vertex, vertex, stress.measure, force);
  return {force[0], force[1]};
}

/// int_e (sigma~ n) phi_i by the rule whose points are the nodes: exact, the integrand has degree 2 order - 1.
template <int order>
void addTractions(const CellStress& stress, Force* tractions)
{
  for (int facet = 0; facet < 3; ++facet) {
    const Force a = tractionAt(stress, facet, facet == 0 ? 1 : 0), b = tractionAt(stress, facet, facet == 2 ? 1 : 2);
    const double ends = order == 1 ? 1.0 / 2.0 : 1.0 / 6.0;
    *tractions++ = ends * a;
    *tractions++ = ends * b;
    if constexpr (order == 2)
      *tractions++ = 1.0 / 3.0 * (a + b);
  }
}

/// - int_E b phi_i from the shares of b. Order 1: phi_a b has the resultant of its share. Order 2: the share of a has
/// the moments int phi_a b lambda_b, and phi_i is made of the products lambda_a lambda_b.
template <int order>
void subtractBodyForce(const double* shares, const Shares& ofLambda, int modes, Force* residual)
{
  const auto share = [&](int a, int k) {
    return Force{shares[std::ptrdiff_t(2) * (a * modes + k)], shares[std::ptrdiff_t(2) * (a * modes + k) + 1]};
  };
  const auto product = [&](int a, int b) {
    Force sum;
    for (int k = 0; k < modes; ++k)
      sum = sum + ofLambda.ofOne(b)[k] * share(a, k);
    return sum;
  };
  for (int a = 0; a < 3; ++a) {
    if constexpr (order == 1)
      residual[a] = residual[a] - share(a, 0);
    else {
      residual[a] = residual[a] - (2.0 * product(a, a) - share(a, 0));
      residual[3 + a] = residual[3 + a] - 4.0 * product((a + 1) % 3, (a + 2) % 3);
    }
  }
}

template <int order>
ElementForces forcesOfOrder(const EdgeMap& edges, const BodyModel& body, const StaticData& data,
                            const Vector& displacement)
{
  const MomentBasis basis = loadBasis(2, data.degree);
  const Shares ofLambda(basis, 2);
  const int modes = basis.size(), numCells = body.mesh.numCells();
  ElementForces forces;
  forces.edgeNodes = order + 1;
  forces.tractions.resize(std::size_t(numCells) * 3 * std::size_t(order + 1));
  forces.residual.resize(std::size_t(numCells) * 3 * std::size_t(order));
  forces.loads.assign(std::size_t(numCells) * std::size_t(modes) * 2, 0.0);
  for (int c = 0; c < numCells; ++c) {
    const CellStress stress = cellStress(body, c, edges.cells[std::size_t(c)], displacement);
    const Force divergence = divergenceOf(stress);
    Force* residual = &forces.residual[std::size_t(c) * 3 * std::size_t(order)];
    double* loads = &forces.loads[std::size_t(c) * std::size_t(modes) * 2];
    addTractions<order>(stress, &forces.tractions[std::size_t(c) * 3 * std::size_t(order + 1)]);
    std::fill_n(residual + (order == 1 ? 0 : 3), 3, -1.0 / 3.0 * divergence);
    loads[0] = -divergence.x;
    loads[1] = -divergence.y;
    if (data.cellShares.empty())
      continue;
    const double* shares = &data.cellShares[std::size_t(c) * 3 * std::size_t(modes) * 2];
    subtractBodyForce<order>(shares, ofLambda, modes, residual);
    for (int i = 0; i < 3 * modes * 2; ++i)
      loads[i % (modes * 2)] -= shares[i];
  }
  return forces;
}

} // namespace

ElementForces nodalForces(const EdgeMap& edges, const BodyModel& body, const StaticData& data,
                          const Vector& displacement)
{
  return data.order == 1 ? forcesOfOrder<1>(edges, body, data, displacement)
                         : forcesOfOrder<2>(edges, body, data, displacement);
}

BoundaryTractions::BoundaryTractions(const Mesh& mesh, const StaticData& data, const Vector* contact)
    : place_(3 * std::size_t(mesh.numCells()), 0)
{
  const auto modes = std::size_t(facetBasis(2, data.degree).size());
  entries_.push_back({{{1.0, 0.0}, {0.0, 1.0}}, std::vector<Force>(modes)});
  for (std::size_t i = 0; i < data.boundary.size(); ++i) {
    const BoundaryFacet& facet = data.boundary[i];
    Entry& entry = makeEntry(mesh, facet.facet);
    if (facet.supported == 1)
      entry.given = {{-facet.directions[0][1], facet.directions[0][0]}};
    if (facet.supported == 2)
      entry.given.clear();
    if (!data.facetShares.empty())
      addShares(data.facetShares.data() + i * 2 * modes * 2, entry);
  }
  for (std::size_t i = 0; contact != nullptr && i < data.contact.size(); ++i)
    addShares(contact->data() + i * 2 * modes * 2, makeEntry(mesh, data.contact[i]));
}

BoundaryTractions::Entry& BoundaryTractions::makeEntry(const Mesh& mesh, Facet facet)
{
  int& place = place_[3 * std::size_t(facet.cell) + std::size_t(sortedFacet(mesh, facet))];
  if (place == 0) {
    place = int(entries_.size());
    entries_.push_back(Entry(entries_.front()));
  }
  return entries_[std::size_t(place)];
}

void BoundaryTractions::addShares(const double* shares, Entry& entry)
{
  for (std::size_t i = 0; i < 2 * entry.moments.size(); ++i) {
    Force& moment = entry.moments[i % entry.moments.size()];
    moment = moment + Force{shares[2 * i], shares[2 * i + 1]};
  }
}

Force BoundaryTractions::givenPart(int half, Force force) const
{
  Force part;
  for (const Force direction : given(half))
    part = part + dot(direction, force) * direction;
  return part;
}

} // namespace ndframe
