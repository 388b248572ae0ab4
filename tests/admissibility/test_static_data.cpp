#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "assembly/sample_body.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/equilibrium/static_data.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

namespace
{

using test::Condition;

struct Space
{
  int dim, order, degree;
};

std::string spaceName(const testing::TestParamInfo<Space>& test)
{
  return "Dim" + std::to_string(test.param.dim) + "Order" + std::to_string(test.param.order) + "Degree" +
         std::to_string(test.param.degree);
}

Condition load(const std::string& type, std::vector<std::pair<std::string, std::string>> entries)
{
  return {type, std::move(entries)};
}

Mesh sampleMesh(int dim, double rotation = 0.0)
{
  const std::vector<int> cells = dim == 2 ? std::vector<int>{3, 2} : std::vector<int>{2, 1, 1};
  return test::renumbered(test::shaken(test::box(cells, "Right", rotation), 0.05, 3), 8);
}

/// Rigid motions: dim translations, then the rotations.
void rigidMotion(int dim, int m, const double* x, double* u)
{
  std::fill_n(u, dim, 0.0);
  if (m < dim) {
    u[m] = 1.0;
    return;
  }
  const int i = dim == 2 ? 0 : (m + 1 - dim) % 3, j = dim == 2 ? 1 : (m + 2 - dim) % 3;
  u[i] = -x[j];
  u[j] = x[i];
}

std::vector<int> sortedVertices(const Mesh& mesh, Facet facet)
{
  std::vector<int> vertices(std::size_t(mesh.dim));
  facetVertices(mesh, facet, vertices.data());
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

std::vector<int> sortedVertices(const Mesh& mesh, int cell)
{
  std::vector<int> vertices(mesh.cell(cell), mesh.cell(cell) + mesh.dim + 1);
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// A simplex of the data with its shares.
struct Part
{
  std::vector<int> vertices;
  MomentBasis basis;
  const double* shares;
  double measure;
  bool isPiecewise;
};

std::vector<Part> partsOf(const BodyModel& body, const StaticData& data)
{
  const MomentBasis onFacet = facetBasis(data.dim, data.degree), inCell = loadBasis(data.dim, data.degree);
  std::vector<Part> parts;
  const auto facetSize = std::size_t(data.dim * onFacet.size() * data.dim),
             cellSize = std::size_t((data.dim + 1) * inCell.size() * data.dim);
  double normal[3];
  for (std::size_t f = 0; f < data.boundary.size(); ++f)
    parts.push_back({sortedVertices(body.mesh, data.boundary[f].facet), onFacet,
                     data.facetShares.data() + f * facetSize, facetNormal(body.mesh, data.boundary[f].facet, normal),
                     false});
  for (std::size_t c = 0; c * cellSize < data.cellShares.size(); ++c)
    parts.push_back({sortedVertices(body.mesh, int(c)), inCell, data.cellShares.data() + c * cellSize,
                     cellMeasure(body.mesh, int(c)), data.degree == 1});
  return parts;
}

/// Barycentric points with weights at which products of a part's functions with affine ones are averaged exactly.
QuadratureRule averaging(const Part& part)
{
  const int n = int(part.vertices.size());
  if (!part.isPiecewise)
    return simplexRule(n - 1, 5);
  QuadratureRule rule{n - 1, {}, std::vector<double>(std::size_t(n), 1.0 / n)};
  for (int sub = 0; sub < n; ++sub) // centroids of the sub-cells
    for (int a = 0; a < n; ++a)
      rule.lambda.push_back(a == sub ? 1.0 / (n * n) : (n + 1.0) / (n * n));
  return rule;
}

std::vector<double> pointAt(const Mesh& mesh, const Part& part, const double* lambda)
{
  std::vector<double> x(std::size_t(mesh.dim), 0.0);
  for (std::size_t v = 0; v < part.vertices.size(); ++v)
    for (std::size_t k = 0; k < x.size(); ++k)
      x[k] += lambda[v] * mesh.point(part.vertices[v])[k];
  return x;
}

/// Work of the share of the a-th vertex on a rigid motion.
double work(const Mesh& mesh, const Part& part, std::size_t a, int motion)
{
  const auto modes = std::size_t(part.basis.size()), dim = std::size_t(mesh.dim);
  const QuadratureRule rule = averaging(part);
  std::vector<double> m(modes), u(dim);
  double sum = 0.0;
  for (int q = 0; q < rule.size(); ++q) {
    part.basis.values(rule.point(q), m.data());
    rigidMotion(mesh.dim, motion, pointAt(mesh, part, rule.point(q)).data(), u.data());
    for (std::size_t k = 0; k < modes; ++k)
      for (std::size_t i = 0; i < dim; ++i)
        sum += rule.weights[std::size_t(q)] * m[k] * u[i] * part.shares[(a * modes + k) * dim + i];
  }
  return sum;
}

/// The hat function of a vertex times a rigid motion, as nodal values (order 1: of its interpolant).
Vector hatTimesMotion(const BodyModel& body, int vertex, int motion)
{
  const int dim = body.mesh.dim;
  Vector hat(std::size_t(body.nodes.numNodes()), 0.0), u(hat.size() * std::size_t(dim), 0.0);
  hat[std::size_t(vertex)] = 1.0;
  const auto edges = dim == 2 ? std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 0}}
                              : std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  for (int c = 0; body.nodes.order == 2 && c < body.mesh.numCells(); ++c)
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (body.mesh.cell(c)[edges[e][0]] == vertex || body.mesh.cell(c)[edges[e][1]] == vertex)
        hat[std::size_t(body.nodes.cell(c)[dim + 1 + int(e)])] = 0.5;
  for (int node = 0; node < body.nodes.numNodes(); ++node) {
    rigidMotion(dim, motion, body.nodes.point(node).data(), u.data() + node * dim);
    for (int k = 0; k < dim; ++k)
      u[std::size_t(node * dim + k)] *= hat[std::size_t(node)];
  }
  return u;
}

/// Loads that no polynomial carries, one of them with a jump.
std::vector<Condition> roughLoads(int dim)
{
  std::vector<Condition> loads = {load("Pressure", {{"Side", "top"}, {"Value", "exp(x) + sin(5*x*y)"}}),
                                  load("Traction", {{"Side", "right"}, {"X", "1/(1.1 + y)"}, {"Y", "cos(4*y)"}}),
                                  load("Traction", {{"Side", "right"}, {"Y", "0.3"}}),
                                  load("Body Force", {{"X", "exp(x - y)"}, {"Y", "3"}})};
  if (dim == 2)
    loads.push_back(load("Pressure", {{"Side", "left"}, {"Value", "y > 0.37"}}));
  return loads;
}

/// q_h on a part at a point: the sum of the shares.
std::vector<double> carried(const Part& part, const double* lambda, int dim)
{
  const auto modes = std::size_t(part.basis.size());
  std::vector<double> m(modes), q(std::size_t(dim), 0.0);
  part.basis.values(lambda, m.data());
  for (std::size_t a = 0; a < part.vertices.size(); ++a)
    for (std::size_t k = 0; k < modes; ++k)
      for (std::size_t i = 0; i < q.size(); ++i)
        q[i] += part.shares[(a * modes + k) * q.size() + i] * m[k] / part.measure;
  return q;
}

} // namespace

struct Spaces : testing::TestWithParam<Space>
{
  int dim = GetParam().dim, order = GetParam().order, degree = GetParam().degree;

  BodyModel loaded(std::vector<Condition> loads) const
  {
    return test::makeBody(sampleMesh(dim), order, {{}, std::move(loads)});
  }
};
INSTANTIATE_TEST_SUITE_P(StaticData, Spaces,
                         testing::Values(Space{2, 1, 1}, Space{2, 1, 2}, Space{2, 2, 2}, Space{2, 2, 3}, Space{3, 1, 1},
                                         Space{3, 1, 2}, Space{3, 2, 2}),
                         spaceName);

TEST_P(Spaces, SharesOfAStarWorkOnRigidMotionsLikeTheLoadVectorOnTheHat)
{
  const BodyModel body = loaded(roughLoads(dim));
  const StaticData data = makeStaticData(body, degree, {});
  const Vector f = assembleLoad(body, Frames(dim, body.nodes.numNodes()));
  const int motions = dim == 2 ? 3 : 6;
  Vector works(std::size_t(body.mesh.numPoints() * motions), 0.0);
  const auto parts = partsOf(body, data);
  for (const auto& part : parts)
    for (std::size_t a = 0; a < part.vertices.size(); ++a)
      for (int m = 0; m < motions; ++m)
        works[std::size_t(part.vertices[a] * motions + m)] += work(body.mesh, part, a, m);
  for (int vertex = 0; vertex < body.mesh.numPoints(); ++vertex)
    for (int m = 0; m < motions; ++m)
      EXPECT_NEAR(works[std::size_t(vertex * motions + m)], dot(f, hatTimesMotion(body, vertex, m)), 2e-14 * norm(f))
          << "vertex " << vertex << " motion " << m;
}

TEST_P(Spaces, ConstantLoadsAreCarriedExactly)
{
  const BodyModel body = loaded(
      {load("Traction", {{"Side", "top"}, {"X", "2"}, {"Y", "-1"}}), load("Body Force", {{"X", "2"}, {"Y", "-1"}})});
  const StaticData data = makeStaticData(body, degree, {});
  const std::vector<double> exact = {2.0, -1.0, 0.0};
  for (const Part& part : partsOf(body, data)) {
    const QuadratureRule rule = simplexRule(int(part.vertices.size()) - 1, 4);
    for (int q = 0; q < rule.size(); ++q) {
      const auto value = carried(part, rule.point(q), dim);
      for (std::size_t i = 0; i < value.size(); ++i)
        EXPECT_NEAR(value[i], exact[i], 1e-13);
    }
  }
  EXPECT_EQ(test::largest(data.oscillation), 0.0);
  EXPECT_EQ(data.caveat, "");
}

TEST_P(Spaces, PolynomialsOfTheStressesAreCarriedExactly)
{
  // On facets degree q for order 2 and degree 1 for order 1; in cells degree q - 1.
  const int onFacet = order == 1 ? 1 : degree;
  const std::string value = onFacet == 1 ? "1 + 2*x" : onFacet == 2 ? "1 + 2*x - x^2" : "1 + x^3";
  const BodyModel body = loaded({load("Pressure", {{"Side", "top"}, {"Value", value}}),
                                 load("Body Force", {{"Y", degree == 1   ? "3"
                                                           : degree == 2 ? "x - 2*y"
                                                                         : "x*y + y^2"}})});
  const StaticData data = makeStaticData(body, degree, {});
  EXPECT_EQ(test::largest(data.oscillation), 0.0);
  EXPECT_EQ(data.caveat, "");
}

TEST_P(Spaces, OtherLoadsOscillateInTheCellsTheyActOn)
{
  const BodyModel body = loaded({load("Pressure", {{"Side", "top"}, {"Value", "exp(x)"}})});
  const StaticData data = makeStaticData(body, degree, {});
  std::vector<char> touched(data.oscillation.size(), 0);
  for (const Facet facet : body.side("top")->facets)
    touched[std::size_t(facet.cell)] = 1;
  for (std::size_t c = 0; c < touched.size(); ++c)
    EXPECT_EQ(data.oscillation[c] > 0.0, touched[c] == 1);
  EXPECT_EQ(data.caveat, "");
}

TEST_P(Spaces, OscillationIsBoundedByConstantsAtFirst)
{
  const BodyModel body = loaded({load("Pressure", {{"Side", "top"}, {"Value", "exp(x)"}}),
                                 load("Body Force", {{"X", "sin(x)"}, {"Y", "x^3*y"}})});
  StaticData data = makeStaticData(body, degree, {}, OscillationBound::ByConstants);
  const auto coarse = data.oscillation;
  const auto sharp = makeStaticData(body, degree, {}).oscillation;
  double ofCoarse = 0.0, ofSharp = 0.0;
  for (std::size_t c = 0; c < sharp.size(); ++c) {
    EXPECT_GE(coarse[c], sharp[c]);
    ofCoarse += coarse[c];
    ofSharp += sharp[c];
  }
  if (degree < (dim == 2 ? 3 : 2)) { // else no stress is richer
    EXPECT_GT(ofCoarse, 1.2 * ofSharp);
  }
  for (int again = 0; again < 2; ++again) {
    sharpenOscillation(body, data);
    EXPECT_EQ(data.oscillation, sharp);
  }
}

TEST_P(Spaces, FacetsWithoutSupportsAndLoadsAreNotListed)
{
  const BodyModel body = test::makeBody(
      sampleMesh(dim), order, {{test::onSide("Clamp", "left")}, {load("Pressure", {{"Side", "top"}, {"Value", "1"}})}});
  const StaticData data = makeStaticData(body, degree, body.side("right")->facets);
  EXPECT_EQ(data.boundary.size(), body.side("left")->facets.size() + body.side("top")->facets.size());
  EXPECT_EQ(data.contact.size(), body.side("right")->facets.size());
  EXPECT_TRUE(data.cellShares.empty());
  EXPECT_EQ(std::count_if(data.boundary.begin(), data.boundary.end(),
                          [this](const BoundaryFacet& facet) { return facet.supported == dim; }),
            std::ptrdiff_t(body.side("left")->facets.size()));
  EXPECT_EQ(data.facetShares.size(), data.boundary.size() * std::size_t(dim * facetBasis(dim, degree).size() * dim));
}

TEST_P(Spaces, SeveralLoadsAddUp)
{
  const auto first = load("Pressure", {{"Side", "top"}, {"Value", "exp(x)"}}),
             second = load("Traction", {{"Side", "top"}, {"X", "x*y"}});
  const auto shares = [&](std::vector<Condition> loads) {
    return makeStaticData(loaded(std::move(loads)), degree, {}).facetShares;
  };
  const auto one = shares({first}), two = shares({second}), both = shares({first, second});
  for (std::size_t i = 0; i < both.size(); ++i)
    EXPECT_NEAR(both[i], one[i] + two[i], 1e-15);
}

namespace
{

/// The share that is largest in its projection on a direction.
double largestAlong(const StaticData& data, const Direction& direction)
{
  double largest = 0.0;
  const auto dim = std::size_t(data.dim);
  for (std::size_t i = 0; i < data.facetShares.size(); i += dim) {
    double along = 0.0;
    for (std::size_t k = 0; k < dim; ++k)
      along += data.facetShares[i + k] * direction[k];
    largest = std::max(largest, std::abs(along));
  }
  return largest;
}

} // namespace

TEST(SupportedFacets, TakeTheLoadsAlongTheirDirections)
{
  const Direction tangent{std::cos(M_PI / 6), std::sin(M_PI / 6), 0.0}, normal{tangent[1], -tangent[0], 0.0};
  const auto traction = load("Traction", {{"Side", "bottom"}, {"X", "exp(y)"}, {"Y", "2"}});
  const BodyModel body = test::makeBody(sampleMesh(2, 30.0), 2, {{test::onSide("Roller", "bottom")}, {traction}});
  const StaticData data = makeStaticData(body, 2, {});
  for (const auto& facet : data.boundary) {
    EXPECT_EQ(facet.supported, 1);
    EXPECT_NEAR(std::abs(dotProduct(facet.directions[0], normal)), 1.0, 1e-14);
  }
  EXPECT_LT(largestAlong(data, normal), 1e-15);
  EXPECT_GT(largestAlong(data, tangent), 0.1);

  const BodyModel clamped = test::makeBody(sampleMesh(2, 30.0), 2, {{test::onSide("Clamp", "bottom")}, {traction}});
  const StaticData held = makeStaticData(clamped, 2, {});
  EXPECT_EQ(held.boundary.front().supported, 2);
  EXPECT_LT(std::max(largestAlong(held, normal), largestAlong(held, tangent)), 1e-15);
  EXPECT_EQ(test::largest(held.oscillation), 0.0);
}

TEST(SupportedFacets, CombineTheDirectionsOfSeveralSupports)
{
  auto pulled = test::onSide("Displacement", "bottom");
  pulled.entries.emplace_back("X", "0.1*x");
  for (const double rotation : {0.0, 30.0}) {
    const BodyModel body =
        test::makeBody(test::box({3, 2}, "Right", rotation), 1, {{test::onSide("Roller", "bottom"), pulled}, {}});
    for (const auto& facet : makeStaticData(body, 1, {}).boundary) {
      ASSERT_EQ(facet.supported, 2);
      EXPECT_NEAR(dotProduct(facet.directions[0], facet.directions[1]), 0.0, 1e-15);
      EXPECT_NEAR(dotProduct(facet.directions[1], facet.directions[1]), 1.0, 1e-15);
    }
  }
}

TEST(Caveats, NameALoadWithARootAlongACurveAndThePlace)
{
  const BodyModel body =
      test::makeBody(sampleMesh(2), 2, {{}, {load("Body Force", {{"Y", "sqrt(max(0, x^2 + y^2 - 0.4))"}})}});
  EXPECT_THAT(makeStaticData(body, 2, {}).caveat,
              testing::AllOf(testing::HasSubstr("integrals of the body force of body"), testing::HasSubstr("near ("),
                             testing::HasSubstr("on both sides of its jumps and kinks. ")));
}

TEST(Caveats, OfASolidSayThatJumpsInsideShouldBePlanes)
{
  const BodyModel body = test::makeBody(sampleMesh(3), 2, {{}, {load("Body Force", {{"Z", "x^2 + y^2 + z^2 > 0.4"}})}});
  EXPECT_THAT(makeStaticData(body, 2, {}).caveat, testing::HasSubstr("should be planes"));
}

TEST(Caveats, AreNotNeededForAJumpAlongACurveInAPlaneOrOnASolid)
{
  const BodyModel plate = test::makeBody(sampleMesh(2), 2, {{}, {load("Body Force", {{"Y", "x^2 + y^2 > 0.4"}})}});
  EXPECT_EQ(makeStaticData(plate, 2, {}).caveat, "");
  const BodyModel solid =
      test::makeBody(sampleMesh(3), 2, {{}, {load("Pressure", {{"Side", "top"}, {"Value", "x^2 + y^2 > 0.4"}})}});
  EXPECT_EQ(makeStaticData(solid, 2, {}).caveat, "");
}

TEST(Caveats, AreNotNeededForAJumpAlongALine)
{
  const BodyModel body = test::makeBody(sampleMesh(2), 2, {{}, {load("Body Force", {{"Y", "x + 0.3*y > 0.4"}})}});
  EXPECT_EQ(makeStaticData(body, 2, {}).caveat, "");
}

TEST(Caveats, AreNotNeededForAJumpInsideAnEdge)
{
  const BodyModel body =
      test::makeBody(sampleMesh(2), 2, {{}, {load("Pressure", {{"Side", "top"}, {"Value", "x > 0.4"}})}});
  EXPECT_EQ(makeStaticData(body, 2, {}).caveat, "");
}

} // namespace ndframe
