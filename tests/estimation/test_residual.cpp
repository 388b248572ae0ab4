#include "ndframe/estimation/residual.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "estimation/smooth_scene.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/mechanics/kernels.hpp"

namespace ndframe
{
namespace
{

using namespace test;

/// u = strain . x (+ a quadratic part for order 2), the stress it makes in a body of law `law`:
/// sigma(x) = constant + sum_k slope_k x_k.
struct ExactField
{
  int dim, order;

  void displacement(const double* x, double* u) const
  {
    for (int k = 0; k < dim; ++k)
      u[k] = 0.2 * x[k] - 0.7 * x[(k + 1) % dim] + (order == 2 ? 0.3 * (k + 1) * x[k] * x[dim - 1] : 0.0);
  }
};

/// The stress of a field that a single cell carries exactly, at a point of the cell.
std::vector<double> stressOf(const ExactField& field, const Elasticity& law, const std::vector<double>& x)
{
  return withDimAndOrder(field.dim, 2, [&](auto d, auto p) {
    // A unit simplex at x: the field's quadratic interpolant there is the field.
    const Mesh mesh = [&] {
      Mesh simplex{d(), {}, {}, {}, {}};
      for (int v = 0; v <= d(); ++v) {
        simplex.cells.push_back(v);
        for (int k = 0; k < d(); ++k)
          simplex.points.push_back(x[std::size_t(k)] + (v == k + 1 ? 1.0 : 0.0));
      }
      return simplex;
    }();
    const NodeMap nodes = makeNodeMap(mesh, 2);
    const Vector u = interpolate(nodes, [&](const double* y, double* v) { field.displacement(y, v); });
    Vector local;
    for (int a = 0; a < nodes.nodesPerCell; ++a)
      local.insert(local.end(), u.begin() + nodes.cell(0)[a] * d(), u.begin() + (nodes.cell(0)[a] + 1) * d());
    double lambda[4] = {1.0}, strain[6], gradients[(d() + 1) * d()];
    barycentricGradients<d()>(mesh.points.data(), gradients);
    std::vector<double> stress(std::size_t(law.strains()));
    stressAt<d(), p()>(gradients, law, lambda, local.data(), strain, stress.data());
    return stress;
  });
}

/// constant + slopes . x of every component of a stress, as texts of a deck.
struct LinearStress
{
  std::vector<double> constant;
  std::vector<std::vector<double>> slope;

  LinearStress(const ExactField& field, const Elasticity& law)
  {
    std::vector<double> x(std::size_t(field.dim), 0.0);
    constant = stressOf(field, law, x);
    for (std::size_t k = 0; k < x.size(); ++k) {
      x[k] = 1.0;
      slope.push_back(stressOf(field, law, x));
      for (std::size_t i = 0; i < constant.size(); ++i)
        slope.back()[i] -= constant[i];
      x[k] = 0.0;
    }
  }

  int dim() const { return int(slope.size()); }
  /// sigma . n for a constant normal, and with `slope` its derivative: force per unit normal.
  std::vector<double> along(const std::vector<double>& stress, const std::vector<double>& normal) const
  {
    std::vector<double> t(normal.size());
    if (dim() == 2)
      divergenceForce<2>(normal.data(), stress.data(), t.data());
    else
      divergenceForce<3>(normal.data(), stress.data(), t.data());
    return t;
  }
  std::vector<std::pair<std::string, std::string>> traction(const std::vector<double>& normal) const
  {
    std::vector<std::pair<std::string, std::string>> entries;
    for (std::size_t i = 0; i < normal.size(); ++i) {
      std::string text = fmt::format("{:.17g}", along(constant, normal)[i]);
      for (std::size_t k = 0; k < slope.size(); ++k)
        text += fmt::format(" + {:.17g} * {}", along(slope[k], normal)[i], "xyz"[k]);
      entries.emplace_back(std::string(1, "XYZ"[i]), text);
    }
    return entries;
  }
  /// b = - div sigma.
  std::vector<std::pair<std::string, std::string>> bodyForce() const
  {
    std::vector<double> b(slope.size(), 0.0), unit(slope.size(), 0.0);
    for (std::size_t k = 0; k < slope.size(); ++k) {
      unit.assign(slope.size(), 0.0);
      unit[k] = 1.0;
      const auto part = along(slope[k], unit);
      for (std::size_t i = 0; i < b.size(); ++i)
        b[i] -= part[i];
    }
    std::vector<std::pair<std::string, std::string>> entries;
    for (std::size_t i = 0; i < b.size(); ++i)
      entries.emplace_back(std::string(1, "XYZ"[i]), fmt::format("{:.17g}", b[i]));
    return entries;
  }
};

/// A box whose exact solution is an ExactField: held on the left, loaded everywhere else.
BodyModel loadedBody(const std::vector<int>& cells, int order, Conditions conditions = {})
{
  const int dim = int(cells.size());
  const LinearStress stress({dim, order}, elastic(dim));
  conditions.supports.push_back(onSide("Clamp", "left"));
  const auto load = [&](const char* side, std::vector<double> normal) {
    Condition traction = onSide("Traction", side);
    for (auto& entry : stress.traction(normal))
      traction.entries.push_back(entry);
    conditions.loads.push_back(traction);
  };
  if (dim == 2) {
    load("right", {1, 0}), load("bottom", {0, -1}), load("top", {0, 1});
  } else {
    load("right", {1, 0, 0}), load("front", {0, -1, 0}), load("back", {0, 1, 0});
    load("bottom", {0, 0, -1}), load("top", {0, 0, 1});
  }
  if (order == 2)
    conditions.loads.push_back({"Body Force", stress.bodyForce()});
  return makeBody(renumbered(shaken(box(cells, "Alternating"), 0.05, 3), 4), order, conditions);
}

Vector exactSolution(const BodyModel& body)
{
  const ExactField field{body.mesh.dim, body.nodes.order};
  return interpolate(body.nodes, [&](const double* x, double* u) { field.displacement(x, u); });
}

std::vector<BodyModel> loadedBodies()
{
  std::vector<BodyModel> bodies;
  for (const int order : {1, 2})
    for (const std::vector<int>& cells : {std::vector<int>{3, 2}, std::vector<int>{2, 2, 1}})
      bodies.push_back(loadedBody(cells, order));
  return bodies;
}

TEST(ResidualIndicator, SeesNoErrorInExactSolutions)
{
  for (const BodyModel& body : loadedBodies())
    for (int degree = body.nodes.order; degree <= 2; ++degree) {
      const Vector u = exactSolution(body);
      const StaticData data = makeStaticData(body, degree, {});
      EXPECT_LT(sum(residualIndicator(body, data, {&u, nullptr})), 1e-24 * sum(cellEnergies(body, u)))
          << body.mesh.dim << ' ' << body.nodes.order << ' ' << degree;
    }
}

/// 1/(2 mu) sum_f h_f |f| |sigma n|^2 for a triangle with constant stress and nothing around it.
TEST(ResidualIndicator, IsItsFormulaOnATriangle)
{
  const BodyModel body = makeBody(randomCell(2, 5), 1);
  const Vector u = Random(2).vector(6);
  const auto stress = cellStress(body, u).front();
  const double voigt[3] = {stress[0], stress[1], stress[3]};
  double expected = 0.0;
  for (int f = 0; f < 3; ++f) {
    double n[2], t[2];
    const double h = facetNormal(body.mesh, {0, f}, n);
    divergenceForce<2>(n, voigt, t);
    expected += h * h * (t[0] * t[0] + t[1] * t[1]);
  }
  const StaticData data = makeStaticData(body, 1, {});
  EXPECT_NEAR(residualIndicator(body, data, {&u, nullptr}).front(), expected * 1.3 / 2.0, 1e-10 * expected);
}

/// Two triangles, the first one at rest: all it has is its half of the jump on the facet between them.
TEST(ResidualIndicator, DividesAJumpBetweenTheTwoCells)
{
  const Mesh square{2, {0, 0, 1, 0, 0, 1, 1, 1}, {0, 1, 2, 1, 3, 2}, {}, {}};
  const BodyModel body = makeBody(square, 1);
  const Vector u{0, 0, 0, 0, 0, 0, 0.2, -0.1};
  const auto stress = cellStress(body, u)[1];
  const double voigt[3] = {stress[0], stress[1], stress[3]};
  double n[2], t[2];
  const double h = facetNormal(body.mesh, {0, 0}, n);
  divergenceForce<2>(n, voigt, t);
  const double jump = h * h * (t[0] * t[0] + t[1] * t[1]) * 1.3 / 2.0;
  const StaticData data = makeStaticData(body, 1, {});
  EXPECT_NEAR(residualIndicator(body, data, {&u, nullptr}).front(), 0.5 * jump, 1e-10 * jump);
}

TEST(ResidualIndicator, CountsAContactTractionLikeALoad)
{
  const BodyModel loaded = loadedBody({3, 2}, 2);
  const StaticData data = makeStaticData(loaded, 2, {});
  // The same tractions, those of the top given as contact.
  StaticData other = data;
  Vector contact;
  other.boundary.clear(), other.facetShares.clear();
  const std::size_t size = data.facetShares.size() / data.boundary.size();
  for (std::size_t f = 0; f < data.boundary.size(); ++f) {
    double normal[2];
    facetNormal(loaded.mesh, data.boundary[f].facet, normal);
    const bool onTop = normal[1] > 0.9;
    const auto first = data.facetShares.begin() + std::ptrdiff_t(f * size);
    auto& shares = onTop ? contact : other.facetShares;
    shares.insert(shares.end(), first, first + std::ptrdiff_t(size));
    if (onTop)
      other.contact.push_back(data.boundary[f].facet);
    else
      other.boundary.push_back(data.boundary[f]);
  }
  ASSERT_EQ(other.contact.size(), 3U);
  const Vector u = Random(3).vector(std::size_t(loaded.numDofs()));
  const Vector expected = residualIndicator(loaded, data, {&u, nullptr});
  const Vector found = residualIndicator(loaded, other, {&u, &contact});
  for (std::size_t c = 0; c < expected.size(); ++c)
    EXPECT_NEAR(found[c], expected[c], 1e-12 * expected[c]);
}

/// A roller takes the pressure on it, but no shear.
TEST(ResidualIndicator, CountsOnlyTheDirectionsThatASupportLeavesFree)
{
  BodyModel body = makeBody(box({2, 2}), 1, {{onSide("Roller", "bottom")}, {}});
  const auto estimate = [&](double exx, double eyy, double exy) {
    const Vector u = interpolate(body.nodes, [&](const double* x, double* v) {
      v[0] = exx * x[0] + exy * x[1];
      v[1] = eyy * x[1] + exy * x[0];
    });
    const StaticData data = makeStaticData(body, 1, {});
    Vector bottom, squared = residualIndicator(body, data, {&u, nullptr});
    // Of the cells at the bottom those that touch no other side.
    for (int c = 0; c < body.mesh.numCells(); ++c) {
      bool atBottom = false, elsewhere = false;
      for (const Side& side : body.mesh.sides)
        for (const Facet facet : side.facets)
          if (facet.cell == c)
            (side.name == "bottom" ? atBottom : elsewhere) = true;
      if (atBottom && !elsewhere)
        bottom.push_back(squared[std::size_t(c)]);
    }
    EXPECT_FALSE(bottom.empty());
    return sum(bottom);
  };
  EXPECT_LT(estimate(0.1, 0.2, 0.0), 1e-28);
  EXPECT_GT(estimate(0.0, 0.0, 0.1), 1e-3);
}

TEST(ResidualIndicator, ConvergesLikeTheError)
{
  for (const int order : {1, 2}) {
    double ratio[2];
    for (int k = 0; k < 2; ++k) {
      const BodyModel body = smoothBody((k + 1) * (order == 1 ? 8 : 4), order);
      const Vector u = solution(body);
      const StaticData data = makeStaticData(body, order, {});
      ratio[k] = std::sqrt(sum(residualIndicator(body, data, {&u, nullptr})) / smoothErrorSquared(body, u));
    }
    EXPECT_NEAR(ratio[1] / ratio[0], 1.0, 0.1) << order;
    EXPECT_GT(ratio[1], 1.0);
    EXPECT_LT(ratio[1], 30.0);
  }
}

TEST(ResidualIndicator, IsAnEnergyInAllUnits)
{
  for (const BodyModel& body : loadedBodies()) {
    const StaticData data = makeStaticData(body, 2, {});
    const Vector u = Random(4).vector(std::size_t(body.numDofs()));
    const Vector squared = residualIndicator(body, data, {&u, nullptr});
    // Stresses a million times as large: loads and stiffness; then displacements a thousand times as large.
    BodyModel stiff{"stiff", body.mesh, body.nodes, body.laws, {}, {}};
    StaticData heavy = data;
    Vector longer = u;
    Elasticity law = stiff.laws(0);
    for (double& D : law.D)
      D *= 1e6;
    stiff.laws = law;
    for (auto* values : {&heavy.facetShares, &heavy.cellShares})
      for (double& value : *values)
        value *= 1e9;
    for (double& value : longer)
      value *= 1e3;
    const Vector scaled = residualIndicator(stiff, heavy, {&longer, nullptr});
    for (std::size_t c = 0; c < squared.size(); ++c)
      EXPECT_NEAR(scaled[c] / 1e12, squared[c], 1e-11 * squared[c]);
  }
}

} // namespace
} // namespace ndframe
