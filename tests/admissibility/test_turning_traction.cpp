#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "admissibility/contact_strip.hpp"
#include "common/test_main.hpp"
#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/admissibility/contact_oscillation.hpp"
#include "ndframe/admissibility/jump_coefficients.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

struct Kind
{
  int order, degree;
};

/// A cubic displacement around a point.
struct CubicField
{
  Vector p;
  std::array<double, 2> centre;

  std::array<double, 2> at(double x, double y) const
  {
    const double X = 4.0 * (x - centre[0]), Y = 4.0 * (y - centre[1]);
    const double m[10] = {1, X, Y, X * X, X * Y, Y * Y, X * X * X, X * X * Y, X * Y * Y, Y * Y * Y};
    std::array<double, 2> v{};
    for (std::size_t i = 0; i < 20; ++i)
      v[i / 10] += p[i] * m[i % 10];
    return v;
  }

  /// In the energy of a cell; strains by central differences, right to 1e-7 for cubics.
  double norm(const BodyModel& body, int cell) const
  {
    double corners[6], energy = 0.0;
    cellPoints(body.mesh, cell, corners);
    const QuadratureRule rule = simplexRule(2, 6);
    for (int q = 0; q < rule.size(); ++q) {
      double x = 0.0, y = 0.0;
      for (int i = 0; i < 3; ++i)
        x += rule.point(q)[i] * corners[2 * i], y += rule.point(q)[i] * corners[2 * i + 1];
      const double h = 1e-4;
      const auto east = at(x + h, y), west = at(x - h, y), north = at(x, y + h), south = at(x, y - h);
      const double strain[3] = {(east[0] - west[0]) / (2 * h), (north[1] - south[1]) / (2 * h),
                                (north[0] - south[0] + east[1] - west[1]) / (2 * h)};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          energy += cellMeasure(body.mesh, cell) * rule.weights[std::size_t(q)] * strain[i] *
                    body.laws(0).D[std::size_t(i * 3 + j)] * strain[j];
    }
    return std::sqrt(energy);
  }
};

struct TurningTraction : testing::TestWithParam<Kind>
{
  test::ContactStrip strip = test::turningStrip(4, GetParam().order, 0.6);
  ContactTraction traction = [&] {
    test::Random random(1);
    return tractionFromNodes(strip.patches, random.vector(std::size_t(4 * GetParam().order + 1)), GetParam().order,
                             GetParam().degree);
  }();

  Direction normal(std::size_t patch, const double* lambda) const
  {
    const auto& ends = strip.patches[patch].ends;
    return {lambda[0] * ends[0][0] + lambda[1] * ends[1][0], lambda[0] * ends[0][1] + lambda[1] * ends[1][1], 0.0};
  }

  double value(std::size_t patch, const double* lambda) const
  {
    Vector L(std::size_t(traction.degree + 1));
    facetBasis(2, traction.degree).values(lambda, L.data());
    return dot(L, traction.moments(int(patch))) / strip.patches[patch].measure;
  }

  /// int t n . v over all facets, v by its values.
  template <class Field>
  double work(const Field& v) const
  {
    const QuadratureRule rule = simplexRule(1, 12);
    double sum = 0.0;
    for (std::size_t f = 0; f < strip.patches.size(); ++f)
      for (int q = 0; q < rule.size(); ++q)
        sum += strip.patches[f].measure * rule.weights[std::size_t(q)] * value(f, rule.point(q)) *
               dotProduct(normal(f, rule.point(q)), v(f, rule.point(q)));
    return sum;
  }

  /// int (t n - what the upper body carries) . v over a facet.
  double uncarriedWork(std::size_t patch, const CubicField& v) const
  {
    const Vector shares = contactShares(strip.patches, {traction, traction}, 0);
    const QuadratureRule rule = simplexRule(1, 12);
    const std::size_t modes = std::size_t(traction.degree + 1);
    Vector L(modes);
    double sum = 0.0;
    for (int q = 0; q < rule.size(); ++q) {
      facetBasis(2, traction.degree).values(rule.point(q), L.data());
      const auto x = strip.point(patch, rule.point(q)[1]);
      const auto moved = v.at(x[0], x[1]);
      const Direction n = normal(patch, rule.point(q));
      for (std::size_t k = 0; k < 2; ++k) {
        double rest = strip.patches[patch].measure * value(patch, rule.point(q)) * n[k];
        for (std::size_t i = 0; i < 2 * modes; ++i)
          rest -= shares[(patch * 2 * modes + i) * 2 + k] * L[i % modes];
        sum += rule.weights[std::size_t(q)] * rest * moved[k];
      }
    }
    return sum;
  }
};
INSTANTIATE_TEST_SUITE_P(Degrees, TurningTraction, testing::Values(Kind{1, 1}, Kind{1, 2}, Kind{2, 2}, Kind{2, 3}),
                         [](const auto& test) {
                           return "Order" + std::to_string(test.param.order) + "Degree" +
                                  std::to_string(test.param.degree);
                         });

} // namespace

TEST_P(TurningTraction, ItsForcesDoTheWorkOfTN)
{
  test::Random random(2);
  for (const std::size_t b : {0u, 1u}) {
    const BodyModel& body = strip.bodies[b];
    const Vector v = random.vector(std::size_t(body.numDofs()));
    std::vector<NodalField> fields;
    for (const BodyModel& each : strip.bodies)
      fields.emplace_back(IndexMap::whole(each.nodes.numNodes()), each.mesh.dim);
    fields[b] = atNodes(v, body.mesh.dim);
    const Vector force = contactForces(body, int(b), strip.patches, {traction, traction});
    const Vector jump = jumpMoments(strip.bodyPointers(), strip.patches, fields, traction.degree);
    double twice = 0.0;
    for (const double part : contactContributions(strip.patches, traction, jump))
      twice += part;
    EXPECT_NEAR(dot(force, v), 0.5 * twice, 1e-13 * norm(force) * norm(v));
    const double pointwise = work([&](std::size_t f, const double* lambda) {
      Direction at{};
      const double t = lambda[1], N[3] = {GetParam().order == 1 ? 1 - t : (1 - t) * (1 - 2 * t),
                                          GetParam().order == 1 ? t : t * (2 * t - 1), 4 * t * (1 - t)};
      for (std::size_t i = 0; i <= std::size_t(GetParam().order); ++i)
        for (std::size_t k = 0; k < 2; ++k)
          at[k] += (b == 0 ? 1.0 : -1.0) * N[i] * strip.at(fields, f, i, b == 0)[k];
      return at;
    });
    EXPECT_NEAR(dot(force, v), pointwise, 1e-13 * norm(force) * norm(v));
  }
}

TEST_P(TurningTraction, ItsSharesBalanceTheForcesOfTheHatFunctions)
{
  // the resultant of a vertex's share is int lambda_a t n: what the star of that vertex has to balance
  for (const std::size_t b : {0u, 1u}) {
    const Vector shares = contactShares(strip.patches, {traction, traction}, int(b));
    const std::size_t modes = std::size_t(traction.degree + 1);
    for (std::size_t f = 0; f < strip.patches.size(); ++f)
      for (std::size_t a = 0; a < 2; ++a)
        for (std::size_t k = 0; k < 2; ++k) {
          const auto mine = std::size_t(strip.patches[f].sides[b].places[a]); // of two vertices: its own inverse
          const double sum = work([&](std::size_t patch, const double* lambda) {
            Direction v{};
            v[k] = patch == f ? (b == 0 ? 1.0 : -1.0) * lambda[a] : 0.0;
            return v;
          });
          EXPECT_NEAR(shares[((f * 2 + mine) * modes) * 2 + k], sum, 1e-14);
        }
  }
}

TEST_P(TurningTraction, WhatIsNotCarriedIsBelowItsOscillation)
{
  const auto oscillation = contactOscillation(strip.bodyPointers(), strip.patches, traction);
  ASSERT_EQ(oscillation.size(), 2u);
  const bool allIsCarried = GetParam().order == 2 && GetParam().degree == 3;
  double largest = 0.0;
  for (std::size_t f = 0; f < strip.patches.size(); ++f) {
    const double osc = std::sqrt(oscillation[0][std::size_t(strip.patches[f].sides[0].facet.cell)]);
    EXPECT_EQ(osc == 0.0, allIsCarried);
    test::Random random(7);
    for (int trial = 0; trial < 20 && !allIsCarried; ++trial) {
      const CubicField v{random.vector(20), strip.point(f, 0.5)};
      const double rest = std::abs(uncarriedWork(f, v)),
                   size = v.norm(strip.bodies[0], strip.patches[f].sides[0].facet.cell);
      EXPECT_LE(rest, osc * size * (1.0 + 1e-6));
      largest = std::max(largest, rest / (osc * size));
    }
  }
  EXPECT_TRUE(allIsCarried || largest > 1e-3) << "the fields see nothing of it: " << largest;
}

TEST_P(TurningTraction, JumpCoefficientsAreThoseOfTheJump)
{
  const int order = GetParam().order;
  test::Random random(3);
  for (const ContactPatch& patch : strip.patches) {
    const JumpCoefficients jump{patch, order};
    ASSERT_EQ(jump.size(), std::size_t(order + 2));
    PatchVectors opening{};
    for (int i = 0; i <= order; ++i)
      opening[std::size_t(i)] = {random.vector(1)[0], random.vector(1)[0], 0.0};
    const Vector gap = random.vector(std::size_t(order + 1));
    for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const double s = 1.0 - t;
      const Vector cubic{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t}, square{s * s, 2 * s * t, t * t},
          line{s, t};
      const Vector nodal{s * s, t * t, 2 * s * t}; // in the order of the nodes
      const Vector &B = order == 2 ? cubic : square, &lower = order == 2 ? nodal : line;
      const double N[3] = {order == 1 ? s : s * (1 - 2 * t), order == 1 ? t : t * (2 * t - 1), 4 * s * t};
      double value = 0.0, exact = 0.0, opened = 0.0;
      for (std::size_t k = 0; k < B.size(); ++k) {
        value += B[k] * jump.of(k, opening);
        opened += B[k] * jump.gap(k, gap.data());
      }
      const Direction n{s * patch.ends[0][0] + t * patch.ends[1][0], s * patch.ends[0][1] + t * patch.ends[1][1], 0.0};
      for (std::size_t i = 0; i <= std::size_t(order); ++i)
        exact += N[i] * dotProduct(n, opening[i]);
      EXPECT_NEAR(value, exact, 1e-15);
      EXPECT_NEAR(opened, dot(lower, gap), 1e-15);
    }
  }
}

} // namespace ndframe
