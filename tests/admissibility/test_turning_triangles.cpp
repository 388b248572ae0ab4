// Tractions and jumps on triangles along which n turns.

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "assembly/sample_body.hpp"
#include "fem/sample_meshes.hpp"
#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/admissibility/contact_oscillation.hpp"
#include "ndframe/admissibility/jump_coefficients.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

struct Kind
{
  int order, degree;
};

Vector randomVector(std::size_t size, std::mt19937& random)
{
  Vector values;
  for (std::size_t i = 0; i < size; ++i)
    values.push_back(std::uniform_real_distribution<double>(-1.0, 1.0)(random));
  return values;
}

/// The bottom of a box, where a rigid body faces it, with a random field n.
struct TurningTriangles : testing::TestWithParam<Kind>
{
  std::mt19937 random{4};
  BodyModel body = test::makeBody(test::renumbered(test::box({2, 2, 1}), 7), GetParam().order);
  std::vector<ContactPatch> patches;
  int numNodes = 0;
  ContactTraction traction;

  TurningTriangles()
  {
    std::map<int, int> number;
    std::map<int, Direction> normals;
    for (const Facet mine : body.side("bottom")->facets) {
      ContactPatch patch;
      patch.dim = 3;
      patch.sides[0].facet = mine;
      patch.sides[1].body = 1;
      patch.measure = facetNormal(body.mesh, mine, patch.normal.data());
      const FacetNodes ours = contactNodes(body, patch.sides[0]);
      for (std::size_t i = 0; i < patch.numNodes(body.nodes.order); ++i)
        patch.nodes[i] = number.insert({ours[i], int(number.size())}).first->second;
      patch.pairs = patch.nodes;
      patch.turns = true;
      for (std::size_t a = 0; a < 3; ++a) {
        const Vector by = randomVector(3, random);
        patch.ends[a] =
            normals.insert({ours[a], {0.4 * by[0], 0.4 * by[1], patch.normal[2] + 0.2 * by[2]}}).first->second;
        std::copy_n(body.nodes.point(ours[a]).data(), 3, patch.points[a].begin());
      }
      patches.push_back(patch);
    }
    numNodes = int(number.size());
    traction =
        tractionFromNodes(patches, randomVector(std::size_t(numNodes), random), GetParam().order, GetParam().degree);
  }

  Direction normal(const ContactPatch& patch, const double* lambda) const
  {
    Direction n{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t k = 0; k < 3; ++k)
        n[k] += lambda[a] * patch.ends[a][k];
    return n;
  }

  /// Forces by area from moments with `components` a mode.
  Vector valuesAt(const Vector& moments, std::size_t components, double measure, const double* lambda) const
  {
    Vector L(traction.numModes()), value(components, 0.0);
    facetBasis(3, traction.degree).values(lambda, L.data());
    for (std::size_t k = 0; k < L.size(); ++k)
      for (std::size_t i = 0; i < components; ++i)
        value[i] += moments[k * components + i] * L[k] / measure;
    return value;
  }

  /// int t n . v over a facet, v(lambda).
  template <class Field>
  double work(std::size_t f, const Field& v) const
  {
    const ContactPatch& patch = patches[f];
    const QuadratureRule rule = simplexRule(2, 9);
    double sum = 0.0;
    for (int q = 0; q < rule.size(); ++q)
      sum += patch.measure * rule.weights[std::size_t(q)] *
             valuesAt(traction.moments(int(f)), 1, patch.measure, rule.point(q))[0] *
             dotProduct(normal(patch, rule.point(q)), v(rule.point(q)));
    return sum;
  }
};
INSTANTIATE_TEST_SUITE_P(Degrees, TurningTriangles, testing::Values(Kind{1, 1}, Kind{1, 2}, Kind{2, 2}),
                         [](const auto& test) {
                           return "Order" + std::to_string(test.param.order) + "Degree" +
                                  std::to_string(test.param.degree);
                         });

double bernstein(const std::array<int, 3>& powers, const double* lambda)
{
  const double factorial[4] = {1.0, 1.0, 2.0, 6.0};
  double value = factorial[powers[0] + powers[1] + powers[2]];
  for (std::size_t a = 0; a < 3; ++a)
    value *= std::pow(lambda[a], powers[a]) / factorial[powers[a]];
  return value;
}

const std::vector<std::array<double, 3>> places{
    {0.2, 0.3, 0.5}, {0.0, 0.4, 0.6}, {1.0, 0.0, 0.0}, {0.7, 0.1, 0.2}, {1.0 / 3, 1.0 / 3, 1.0 / 3}};

} // namespace

TEST_P(TurningTriangles, JumpCoefficientsAreThoseOfTheJump)
{
  const int order = GetParam().order;
  const auto powers = bernsteinPowers(3, order + 1);
  for (const ContactPatch& patch : patches) {
    const JumpCoefficients jump{patch, order};
    ASSERT_EQ(jump.size(), powers.size());
    PatchVectors opening{};
    for (Direction& vector : opening)
      for (double& component : vector)
        component = randomVector(1, random)[0];
    const Vector gap = randomVector(patch.numNodes(order), random); // in the order of the nodes
    for (const auto& lambda : places) {
      double value = 0.0, opened = 0.0, exact = 0.0, given = 0.0, N[mostFacetNodes];
      for (std::size_t k = 0; k < powers.size(); ++k) {
        value += bernstein(powers[k], lambda.data()) * jump.of(k, opening);
        opened += bernstein(powers[k], lambda.data()) * jump.gap(k, gap.data());
      }
      facetFunctions(3, order, lambda.data(), N);
      for (std::size_t i = 0; i < patch.numNodes(order); ++i)
        exact += N[i] * dotProduct(normal(patch, lambda.data()), opening[i]);
      for (std::size_t i = 0; i < gap.size(); ++i) {
        const auto& ends = facetEdges(3).ends[i < 3 ? 0 : i - 3];
        given += gap[i] * (i >= 3       ? 2.0 * lambda[std::size_t(ends[0])] * lambda[std::size_t(ends[1])]
                           : order == 1 ? lambda[i]
                                        : lambda[i] * lambda[i]);
      }
      EXPECT_NEAR(value, exact, 1e-14);
      EXPECT_NEAR(opened, given, 1e-14);
    }
  }
}

TEST_P(TurningTriangles, NodesDecideEveryCoefficient)
{
  const int order = GetParam().order;
  const JumpCoefficients jump{patches.front(), order};
  std::vector<int> decided(jump.size(), 0);
  for (std::size_t a = 0; a < 3; ++a) {
    ++decided[jump.atVertex(a)];
    EXPECT_EQ(jump.weight(jump.atVertex(a), a), patches.front().ends[a]);
    for (const std::size_t k : order == 2 ? jump.atMiddle(3 + a) : jump.alongEdge(a, false)) {
      ++decided[k];
      const auto [first, second] = facetEdges(3).ends[a];
      const Direction weight = jump.weight(k, order == 2 ? 3 + a : std::size_t(first));
      EXPECT_GT(dotProduct(weight, weight), 0.0);
      EXPECT_NE(first, second);
    }
  }
  EXPECT_EQ(std::count(decided.begin(), decided.end(), 0), 0);
}

TEST_P(TurningTriangles, ItsForcesDoTheWorkOfTN)
{
  const Vector v = randomVector(std::size_t(body.numDofs()), random);
  BodyModel ground = test::makeBody(test::renumbered(test::box({2, 2, 1}), 7), GetParam().order);
  std::vector<NodalField> fields{atNodes(v, 3), atNodes(Vector(v.size(), 0.0), 3)};
  const Vector force = contactForces(body, 0, patches, {traction, traction});
  const Vector jump = jumpMoments({&body, &ground}, patches, fields, traction.degree);
  double twice = 0.0, pointwise = 0.0;
  for (const double part : contactContributions(patches, traction, jump))
    twice += part;
  for (std::size_t f = 0; f < patches.size(); ++f) {
    const FacetNodes nodes = contactNodes(body, patches[f].sides[0]);
    pointwise += work(f, [&](const double* lambda) {
      Direction at{};
      double N[mostFacetNodes];
      facetFunctions(3, GetParam().order, lambda, N);
      for (std::size_t i = 0; i < patches[f].numNodes(GetParam().order); ++i)
        for (std::size_t k = 0; k < 3; ++k)
          at[k] += N[i] * v[std::size_t(nodes[i]) * 3 + k];
      return at;
    });
  }
  EXPECT_NEAR(dot(force, v), 0.5 * twice, 1e-13 * norm(force) * norm(v));
  EXPECT_NEAR(dot(force, v), pointwise, 1e-13 * norm(force) * norm(v));
}

TEST_P(TurningTriangles, ItsSharesBalanceTheForcesOfTheHatFunctions)
{
  // star recovery needs the work of a vertex's share on rigid motions (order 1: on translations) to be that of lambda_a
  // t n
  const Vector shares = contactShares(patches, {traction, traction}, 0);
  const std::size_t modes = traction.numModes();
  const QuadratureRule rule = simplexRule(2, 9);
  for (std::size_t f = 0; f < patches.size(); ++f)
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t linear = 0; linear < (GetParam().order == 2 ? 4u : 1u); ++linear) {
          const auto motion = [&](const double* lambda) { return linear == 0 ? 1.0 : lambda[linear - 1]; };
          const Vector own(shares.begin() + std::ptrdiff_t((f * 3 + a) * modes * 3),
                           shares.begin() + std::ptrdiff_t((f * 3 + a + 1) * modes * 3));
          double carried = 0.0;
          for (int q = 0; q < rule.size(); ++q)
            carried += patches[f].measure * rule.weights[std::size_t(q)] *
                       valuesAt(own, 3, patches[f].measure, rule.point(q))[k] * motion(rule.point(q));
          const double exact = work(f, [&](const double* lambda) {
            Direction v{};
            v[k] = lambda[a] * motion(lambda);
            return v;
          });
          EXPECT_NEAR(carried, exact, 1e-14);
        }
}

TEST_P(TurningTriangles, WhatIsNotCarriedIsBelowItsOscillation)
{
  BodyModel ground = body.isRigid ? BodyModel() : test::makeBody(test::box({2, 2, 1}), GetParam().order);
  ground.isRigid = true;
  const auto oscillation = contactOscillation({&body, &ground}, patches, traction);
  ASSERT_EQ(oscillation.size(), 2u);
  const Vector shares = contactShares(patches, {traction, traction}, 0);
  const std::size_t carried = traction.numModes() * 3;
  const QuadratureRule onFacet = simplexRule(2, 9), inCell = simplexRule(3, 6);
  double largest = 0.0;
  for (std::size_t f = 0; f < patches.size(); ++f) {
    const ContactPatch& patch = patches[f];
    const int cell = patch.sides[0].facet.cell;
    const double osc = std::sqrt(oscillation[0][std::size_t(cell)]);
    ASSERT_GT(osc, 0.0);
    Vector whole(carried, 0.0);
    for (std::size_t i = 0; i < 3 * carried; ++i)
      whole[i % carried] += shares[f * 3 * carried + i];
    for (int trial = 0; trial < 20; ++trial) {
      const Vector p = randomVector(60, random);
      const Direction centre = patch.points[0];
      const auto field = [&](const double* x) { // cubic
        const double X = 3 * (x[0] - centre[0]), Y = 3 * (x[1] - centre[1]), Z = 3 * (x[2] - centre[2]);
        const double m[20] = {1,         X,         Y,         Z,         X * X,     Y * Y,     Z * Z,
                              X * Y,     Y * Z,     Z * X,     X * X * X, Y * Y * Y, Z * Z * Z, X * X * Y,
                              X * X * Z, Y * Y * X, Y * Y * Z, Z * Z * X, Z * Z * Y, X * Y * Z};
        Direction v{};
        for (std::size_t i = 0; i < 60; ++i)
          v[i / 20] += p[i] * m[i % 20];
        return v;
      };
      double rest = 0.0, energy = 0.0;
      for (int q = 0; q < onFacet.size(); ++q) {
        const double* lambda = onFacet.point(q);
        double x[3] = {};
        for (std::size_t a = 0; a < 3; ++a)
          for (std::size_t k = 0; k < 3; ++k)
            x[k] += lambda[a] * patch.points[a][k];
        const double t = valuesAt(traction.moments(int(f)), 1, patch.measure, lambda)[0];
        const Vector held = valuesAt(whole, 3, patch.measure, lambda);
        const Direction n = normal(patch, lambda), v = field(x);
        for (std::size_t k = 0; k < 3; ++k)
          rest += patch.measure * onFacet.weights[std::size_t(q)] * (t * n[k] - held[k]) * v[k];
      }
      double points[12];
      cellPoints(body.mesh, cell, points);
      for (int q = 0; q < inCell.size(); ++q) {
        double x[3] = {}, gradient[3][3];
        for (int a = 0; a < 4; ++a)
          for (int k = 0; k < 3; ++k)
            x[k] += inCell.point(q)[a] * points[3 * a + k];
        for (int k = 0; k < 3; ++k) {
          const double h = 1e-4, at = x[k];
          x[k] = at + h;
          const Direction ahead = field(x);
          x[k] = at - h;
          const Direction behind = field(x);
          x[k] = at;
          for (std::size_t i = 0; i < 3; ++i)
            gradient[i][k] = (ahead[i] - behind[i]) / (2 * h);
        }
        const double strain[6] = {gradient[0][0],
                                  gradient[1][1],
                                  gradient[2][2],
                                  gradient[0][1] + gradient[1][0],
                                  gradient[1][2] + gradient[2][1],
                                  gradient[2][0] + gradient[0][2]};
        for (int i = 0; i < 6; ++i)
          for (int j = 0; j < 6; ++j)
            energy += cellMeasure(body.mesh, cell) * inCell.weights[std::size_t(q)] * strain[i] * body.laws(0)(i, j) *
                      strain[j];
      }
      EXPECT_LE(std::abs(rest), osc * std::sqrt(energy) * (1.0 + 1e-6));
      largest = std::max(largest, std::abs(rest) / (osc * std::sqrt(energy)));
    }
  }
  EXPECT_GT(largest, 1e-3) << "the fields see nothing of it";
}

} // namespace ndframe
