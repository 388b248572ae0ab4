#include "contact_strip.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "admissibility/turn_facets.hpp"
#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/fem/lagrange.hpp"

namespace ndframe::test
{

namespace
{

std::array<double, 2> middle(const Mesh& mesh, Facet facet)
{
  int v[2];
  facetVertices(mesh, facet, v);
  return {0.5 * (mesh.point(v[0])[0] + mesh.point(v[1])[0]), 0.5 * (mesh.point(v[0])[1] + mesh.point(v[1])[1])};
}

bool isSame(const double* a, const double* b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]) < 1e-9;
}

Facet opposite(const Mesh& mesh, const Side& side, const std::array<double, 2>& point)
{
  for (const Facet facet : side.facets)
    if (isSame(middle(mesh, facet).data(), point.data()))
      return facet;
  ADD_FAILURE() << "no facet on the other side";
  return side.facets.front();
}

std::vector<ContactPatch> pairFacets(const BodyModel& upper, const BodyModel& lower)
{
  std::vector<ContactPatch> patches;
  std::map<int, int> number; // of interface nodes, by the upper body's
  for (const Facet mine : upper.side("bottom")->facets) {
    ContactPatch patch;
    const Facet other = opposite(lower.mesh, *lower.side("top"), middle(upper.mesh, mine));
    patch.sides = {{{0, mine}, {1, other}}};
    patch.measure = facetNormal(upper.mesh, mine, patch.normal.data());
    const auto ours = contactNodes(upper, patch.sides[0]);
    if (!isSame(upper.nodes.point(ours[0]).data(), lower.nodes.point(contactNodes(lower, patch.sides[1])[0]).data()))
      patch.sides[1].places = {1, 0, 2};
    for (std::size_t i = 0; i <= std::size_t(upper.nodes.order); ++i)
      patch.nodes[i] = number.insert({ours[i], int(number.size())}).first->second;
    patch.pairs = patch.nodes;
    for (std::size_t end = 0; end < 2; ++end)
      std::copy_n(upper.nodes.point(ours[end]).data(), 2, patch.points[end].begin());
    patches.push_back(patch);
  }
  return patches;
}

} // namespace

std::vector<const BodyModel*> ContactStrip::bodyPointers() const
{
  return {&bodies[0], &bodies[1]};
}

std::vector<const ConstraintSet*> ContactStrip::constraintPointers() const
{
  return {&constraints[0], &constraints[1]};
}

const double* ContactStrip::at(const std::vector<NodalField>& displacement, std::size_t patch, std::size_t number,
                               bool isUpper) const
{
  const std::size_t body = isUpper ? 0 : 1;
  const int node = contactNodes(bodies[body], patches[patch].sides[body])[number];
  return displacement[body].data() + std::size_t(node) * 2;
}

double ContactStrip::jump(const std::vector<NodalField>& displacement, std::size_t patch, double t) const
{
  const double lambda[2] = {1.0 - t, t};
  double N[3], value = 0.0;
  const int order = bodies[0].nodes.order;
  const ContactPatch& here = patches[patch];
  Direction normal = here.normal;
  for (std::size_t k = 0; here.turns && k < 2; ++k)
    normal[k] = lambda[0] * here.ends[0][k] + lambda[1] * here.ends[1][k];
  order == 1 ? Lagrange<1, 1>::values(lambda, N) : Lagrange<1, 2>::values(lambda, N);
  for (std::size_t i = 0; i <= std::size_t(order); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      value += N[i] * normal[k] * (at(displacement, patch, i, true)[k] - at(displacement, patch, i, false)[k]);
  return value;
}

std::array<double, 2> ContactStrip::point(std::size_t patch, double t) const
{
  const auto nodes = contactNodes(bodies[0], patches[patch].sides[0]);
  const auto a = bodies[0].nodes.point(nodes[0]), b = bodies[0].nodes.point(nodes[1]);
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])};
}

ContactStrip contactStrip(int numFacets, int order, double bend, const Conditions& upper, const Conditions& lower)
{
  ContactStrip strip;
  const Mesh box = test::box({numFacets, 2});
  const auto rise = [bend](double x) { return bend * std::max(0.0, x - 0.5); };
  const Mesh above = moved(renumbered(box, 3), [&](double* x) { x[1] += 1.0 + rise(x[0]); });
  const Mesh below = moved(renumbered(box, 4), [&](double* x) { x[1] *= 1.0 + rise(x[0]); });
  strip.bodies.push_back(makeBody(above, order, upper));
  strip.bodies.push_back(makeBody(below, order, lower));
  strip.bodies[0].name = "upper";
  strip.bodies[1].name = "lower";
  Elasticity law = strip.bodies[1].laws(0);
  for (double& entry : law.D) // softer than the upper one
    entry *= 0.2;
  strip.bodies[1].laws = law;
  for (const auto& body : strip.bodies)
    strip.constraints.push_back(constraintsOf(body));
  strip.patches = pairFacets(strip.bodies[0], strip.bodies[1]);
  return strip;
}

ContactStrip turningStrip(int numFacets, int order, double bend)
{
  ContactStrip strip = contactStrip(numFacets, order, bend);
  turnFacets(strip.patches);
  return strip;
}

} // namespace ndframe::test
