// Which side of a patch is the first, and in which order its vertices are, is a matter of writing.

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "admissibility/turn_facets.hpp"
#include "assembly/sample_body.hpp"
#include "common/test_main.hpp"
#include "fem/sample_meshes.hpp"
#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/admissibility/contact_oscillation.hpp"

namespace ndframe
{

namespace
{

struct Kind
{
  int dim, order;
  bool turns;
};

std::string nameOf(const testing::TestParamInfo<Kind>& test)
{
  const auto [dim, order, turns] = test.param;
  return std::to_string(dim) + "dOrder" + std::to_string(order) + (turns ? "Turning" : "");
}

bool isSame(const double* x, const double* y, int dim)
{
  return std::equal(x, x + dim, y, [](double a, double b) { return std::abs(a - b) < 1e-9; });
}

void expectSame(const Vector& found, const Vector& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], 1e-13 * norm(expected)) << i;
}

/// The bottom of a box and, as the other side, that of a copy with other numbers.
struct ContactPatches : testing::TestWithParam<Kind>
{
  static constexpr int degree = 2;
  const int dim = GetParam().dim, order = GetParam().order;
  const std::array<BodyModel, 2> bodies{box(7), box(8)};
  const std::vector<const BodyModel*> pointers{&bodies[0], &bodies[1]};
  std::vector<ContactPatch> patches;
  Vector nodal;                       ///< a traction at the interface nodes
  std::array<Vector, 2> displacement; ///< of either body

  ContactPatches()
  {
    std::map<int, int> number; // of interface nodes
    for (const Facet mine : bodies[0].side("bottom")->facets)
      addPatch(mine, number);
    if (GetParam().turns)
      test::turnFacets(patches);
    test::Random random(3);
    nodal = random.vector(number.size());
    for (std::size_t b = 0; b < 2; ++b)
      displacement[b] = random.vector(std::size_t(bodies[b].numDofs()));
  }

  BodyModel box(unsigned seed) const
  {
    return test::makeBody(test::renumbered(dim == 2 ? test::box({3, 2}) : test::box({3, 2, 1}), seed), order);
  }

  void addPatch(Facet mine, std::map<int, int>& number)
  {
    ContactPatch patch;
    patch.dim = dim;
    const auto centre = facetCentre(bodies[0].mesh, mine);
    const auto& others = bodies[1].side("bottom")->facets;
    const Facet other = *std::find_if(others.begin(), others.end(), [&](Facet facet) {
      return isSame(facetCentre(bodies[1].mesh, facet).data(), centre.data(), dim);
    });
    patch.sides = {{{0, mine}, {1, other}}};
    patch.measure = facetNormal(bodies[0].mesh, mine, patch.normal.data());
    const FacetNodes ours = contactNodes(bodies[0], patch.sides[0]), theirs = contactNodes(bodies[1], patch.sides[1]);
    for (std::size_t a = 0; a < patch.numVertices(); ++a)
      for (std::size_t k = 0; k < patch.numVertices(); ++k)
        if (isSame(bodies[0].nodes.point(ours[k]).data(), bodies[1].nodes.point(theirs[a]).data(), dim))
          patch.sides[1].places[a] = int(k);
    for (std::size_t i = 0; i < patch.numNodes(order); ++i)
      patch.nodes[i] = number.insert({ours[i], int(number.size())}).first->second;
    patches.push_back(patch);
  }

  /// The patches of another list give the bodies what `patches` do.
  void expectSameOn(const std::vector<ContactPatch>& other) const
  {
    const ContactTraction t = tractionFromNodes(patches, nodal, order, degree),
                          s = tractionFromNodes(other, nodal, order, degree);
    const std::vector<NodalField> u{atNodes(displacement[0], bodies[0].mesh.dim),
                                    atNodes(displacement[1], bodies[1].mesh.dim)};
    expectSame(contactContributions(other, s, jumpMoments(pointers, other, u, degree)),
               contactContributions(patches, t, jumpMoments(pointers, patches, u, degree)));
    const auto oscillation = contactOscillation(pointers, patches, t), same = contactOscillation(pointers, other, s);
    ASSERT_EQ(same.size(), oscillation.size());
    for (std::size_t b = 0; b < 2; ++b) {
      const int body = int(b);
      expectSame(contactShares(other, {s, s}, body), contactShares(patches, {t, t}, body));
      expectSame(contactForces(bodies[b], body, other, {s, s}), contactForces(bodies[b], body, patches, {t, t}));
      EXPECT_NEAR(dot(nodal, motionWork(bodies[b], u[b], other, patchesOfBody(other, body))),
                  dot(nodal, motionWork(bodies[b], u[b], patches, patchesOfBody(patches, body))), 1e-13);
      if (!same.empty())
        expectSame(same[b], oscillation[b]);
    }
  }

  static double dot(const Vector& values, const SparseRow& row)
  {
    double sum = 0.0;
    for (const auto& [i, value] : row)
      sum += values[std::size_t(i)] * value;
    return sum;
  }
};
INSTANTIATE_TEST_SUITE_P(AllKinds, ContactPatches,
                         testing::Values(Kind{2, 1, false}, Kind{2, 2, false}, Kind{2, 1, true}, Kind{2, 2, true},
                                         Kind{3, 1, false}, Kind{3, 2, false}),
                         nameOf);

/// The same patch with the vertex that was order[a] at place a.
ContactPatch reordered(const ContactPatch& patch, const std::array<int, 3>& order)
{
  ContactPatch other = patch;
  for (std::size_t a = 0; a < patch.numVertices(); ++a) {
    const auto from = std::size_t(order[a]);
    other.nodes[a] = patch.nodes[from];
    if (patch.turns)
      other.ends[a] = patch.ends[from];
    for (std::size_t side = 0; side < 2; ++side)
      for (std::size_t k = 0; k < patch.numVertices(); ++k)
        if (patch.sides[side].places[k] == order[a])
          other.sides[side].places[k] = int(a);
  }
  const FacetEdges edges = facetEdges(patch.dim);
  for (int e = 0; e < edges.size; ++e)
    for (int was = 0; was < edges.size; ++was)
      if (std::minmax(order[std::size_t(edges.ends[e][0])], order[std::size_t(edges.ends[e][1])]) ==
          std::minmax(edges.ends[was][0], edges.ends[was][1]))
        other.nodes[patch.numVertices() + std::size_t(e)] = patch.nodes[patch.numVertices() + std::size_t(was)];
  return other;
}

} // namespace

TEST_P(ContactPatches, TellBodiesTheSameWhicheverSideIsTheFirst)
{
  std::vector<ContactPatch> other = patches;
  for (ContactPatch& patch : other) {
    std::swap(patch.sides[0], patch.sides[1]);
    for (Direction* normal : {&patch.normal, &patch.ends[0], &patch.ends[1]})
      for (double& component : *normal)
        component = -component;
  }
  expectSameOn(other);
}

TEST_P(ContactPatches, TellBodiesTheSameInWhateverOrderTheirVerticesAre)
{
  std::array<int, 3> places{0, 1, 2};
  do {
    std::vector<ContactPatch> other;
    for (const ContactPatch& patch : patches)
      other.push_back(reordered(patch, places));
    expectSameOn(other);
  } while (std::next_permutation(places.begin(), places.begin() + dim));
}

TEST_P(ContactPatches, HaveNodesOfBothBodiesAtTheSamePoints)
{
  for (const ContactPatch& patch : patches) {
    const FacetNodes ours = contactNodes(bodies[0], patch.sides[0]), theirs = contactNodes(bodies[1], patch.sides[1]);
    for (std::size_t i = 0; i < patch.numNodes(order); ++i)
      EXPECT_TRUE(isSame(bodies[0].nodes.point(ours[i]).data(), bodies[1].nodes.point(theirs[i]).data(), dim));
  }
}

} // namespace ndframe
