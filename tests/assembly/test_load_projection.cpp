// What the certificate has of a load in cells: its projection and its distance from it.

#include <array>
#include <cmath>

#include <gmock/gmock.h>

#include "assembly/sample_body.hpp"
#include "ndframe/assembly/body_loads.hpp"
#include "ndframe/assembly/load_samples.hpp"
#include "ndframe/fem/moment_basis.hpp"

namespace ndframe
{

namespace
{

/// A body under a force per volume, on cells with vertices in any order.
BodyModel loaded(const Mesh& mesh, const std::string& x, const std::string& y)
{
  return test::makeBody(test::renumbered(test::shaken(mesh, 0.03, 5), 9), 2,
                        {{}, {{"Body Force", {{"X", x}, {"Y", y}}}}});
}

BodyModel loaded(int dim, const std::string& x, const std::string& y)
{
  return loaded(dim == 2 ? test::box({5, 4}, "Alternating") : test::box({2, 2, 2}), x, y);
}

struct CellMoments
{
  std::vector<double> moments; ///< of polynomials of degree 5 - dim
  double distance = 0.0;       ///< from the polynomial with these moments
  double points = 0.0;         ///< of samples; a projection has none
};

/// Of samples: the moments for the vertices in ascending order.
CellMoments momentsOf(const LoadedSimplex& cell, const MomentBasis& basis, std::size_t dim)
{
  const auto modes = std::size_t(basis.size());
  CellMoments of{std::vector<double>(modes * dim, 0.0), 0.0, double(cell.samples.rule.size())};
  std::vector<double> m(modes);
  const auto places = ascendingPlaces(cell);
  double square = cell.samples.rest * cell.samples.rest;
  for (int g = 0; g < cell.samples.rule.size(); ++g) {
    std::array<double, 4> lambda{};
    for (std::size_t v = 0; v <= dim; ++v)
      lambda[std::size_t(places[v])] = cell.samples.rule.point(g)[v];
    basis.values(lambda.data(), m.data());
    for (std::size_t i = 0; i < dim; ++i) {
      const double weight = cell.samples.rule.weights[std::size_t(g)];
      const double value = cell.samples.values[std::size_t(g) * dim + i];
      square += weight * value * value;
      for (std::size_t k = 0; k < modes; ++k)
        of.moments[k * dim + i] += weight * value * m[k];
    }
  }
  for (const double moment : of.moments)
    square -= moment * moment;
  of.distance = std::sqrt(std::max(0.0, square));
  return of;
}

std::vector<CellMoments> momentsOf(const BodyModel& body)
{
  const std::size_t dim = std::size_t(body.mesh.dim);
  const MomentBasis basis = MomentBasis::polynomials(body.mesh.dim, 5 - body.mesh.dim);
  std::vector<CellMoments> all;
  visitLoad(*body.loads.front(), body.mesh, [&](const LoadedSimplex& cell) {
    if (cell.projection == nullptr)
      return all.push_back(momentsOf(cell, basis, dim));
    EXPECT_EQ(cell.functions, basis.size());
    all.push_back({{cell.projection, cell.projection + std::size_t(cell.functions) * dim}, cell.samples.rest, 0.0});
  });
  return all;
}

void integrate(const BodyModel& body, Load::Keep keep = Load::Keep::Projections)
{
  integrateLoads(body, keep);
}

} // namespace

struct LoadProjections : testing::TestWithParam<int>
{};
INSTANTIATE_TEST_SUITE_P(Spaces, LoadProjections, testing::Values(2, 3), testing::PrintToStringParamName());

/// Integrating a load keeps its projections: the next visit has the same moments and distances, without points.
TEST_P(LoadProjections, HaveTheMomentsAndTheDistancesOfTheLoad)
{
  const std::pair<std::string, std::string> loads[] = {
      {"sin(2*x-y)", "exp(x*y)"}, {"x > 0.37 ? 1 : 0.2", "y"}, {"abs(x - 0.4*y)", "0"}, {"x*y", "1+x^2"}};
  for (const auto& [x, y] : loads) {
    if (GetParam() == 3 && x.find("abs") == 0)
      continue;
    const BodyModel body = loaded(GetParam(), x, y);
    const auto sampled = momentsOf(body);
    integrate(body);
    const auto kept = momentsOf(body);
    ASSERT_EQ(kept.size(), sampled.size());
    for (std::size_t cell = 0; cell < kept.size(); ++cell) {
      EXPECT_EQ(kept[cell].points, 0.0) << x;
      for (std::size_t k = 0; k < kept[cell].moments.size(); ++k)
        EXPECT_NEAR(kept[cell].moments[k], sampled[cell].moments[k], 1e-14) << x << ' ' << k;
      EXPECT_NEAR(kept[cell].distance, sampled[cell].distance, 1e-7 * sampled[cell].distance + 3e-8) << x;
    }
  }
}

TEST_P(LoadProjections, AreNotThoseOfAnotherMesh)
{
  BodyModel body = loaded(GetParam(), "sin(2*x-y)", "0");
  integrate(body);
  for (double& coordinate : body.mesh.points)
    coordinate *= 1.0 + 1e-9;
  const auto sampled = momentsOf(body), fresh = momentsOf(loaded(GetParam(), "sin(2*x-y)", "0"));
  EXPECT_EQ(sampled.front().points, fresh.front().points);
}

/// A run without a certificate does not pay for them.
TEST(LoadProjections, AreNotKeptUnlessAskedFor)
{
  const BodyModel body = loaded(2, "sin(2*x-y)", "0");
  integrate(body);
  EXPECT_NE(body.loads.front()->projection(), nullptr);
  integrate(body, Load::Keep::Nothing);
  EXPECT_EQ(body.loads.front()->projection(), nullptr);
}

/// A load that is not certain somewhere is sampled again, so that its doubts are told with their place.
TEST(LoadProjections, AreNotKeptWhereSamplesAreNotCertain)
{
  const BodyModel body = loaded(test::box({1, 1}), "sqrt(max(0, 0.04 - (x-0.6)^2 - (y-0.3)^2))", "0");
  integrate(body);
  for (const auto& cell : momentsOf(body))
    EXPECT_GT(cell.points, 0.0);
}

} // namespace ndframe
