#include <cmath>

#include <gtest/gtest.h>

#include "assembly/sample_body.hpp"
#include "common/test_main.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/assembly/rigid_modes.hpp"

namespace ndframe
{

namespace
{

struct Case
{
  int dim, order;
  double rotation; ///< turns the box, so that its rollers are inclined and their nodes have axes of their own
};

std::string caseName(const testing::TestParamInfo<Case>& test)
{
  return "Dim" + std::to_string(test.param.dim) + "Order" + std::to_string(test.param.order) +
         (test.param.rotation == 0.0 ? "Straight" : "Turned");
}

std::vector<Case> allCases()
{
  std::vector<Case> cases;
  for (const int dim : {2, 3})
    for (const int order : {1, 2})
      for (const double rotation : {0.0, 25.0})
        cases.push_back({dim, order, rotation});
  return cases;
}

Mesh sampleMesh(const Case& kind)
{
  const std::vector<int> cells = kind.dim == 2 ? std::vector<int>{4, 3} : std::vector<int>{2, 2, 2};
  return test::shaken(test::box(cells, "Right", kind.rotation), 0.03, 6);
}

} // namespace

struct Assembled : testing::TestWithParam<Case>
{
  const Comm& comm = test::comm();
  BodyModel body = test::makeBody(sampleMesh(GetParam()), GetParam().order, {{test::onSide("Roller", "left")}, {}});
  BodySystem system = test::assemble(body, comm);
  std::size_t numDofs = std::size_t(body.numDofs());

  Vector product(const Vector& x) const { return multiply(system.K, x, comm); }
};

TEST_P(Assembled, IsSymmetricOverAllRanks)
{
  test::Random random(1);
  for (int sample = 0; sample < 3; ++sample) {
    const Vector x = random.vector(numDofs), y = random.vector(numDofs);
    const double xKy = dot(x, product(y)), yKx = dot(y, product(x));
    EXPECT_NEAR(xKy, yKx, 1e-13 * norm(x) * norm(product(y)));
  }
}

/// Bit by bit.
TEST_P(Assembled, IsTheSameOnceItsMemoryWasGivenBack)
{
  const std::vector<double> before = system.K.values;
  const double largest = system.largestDiagonal(comm);
  giveBackStiffness(system);
  EXPECT_EQ(system.K.values.capacity(), 0);
  assembleAgain(system, body);
  EXPECT_EQ(system.K.values, before);
  EXPECT_EQ(system.largestDiagonal(comm), largest);
  assembleAgain(system, body); // is there
  EXPECT_EQ(system.K.values, before);
}

TEST_P(Assembled, AnnulsTheRigidMotionsInTheNodesOwnAxes)
{
  EXPECT_EQ(system.dofs.frames.anyTurned(), GetParam().rotation != 0.0);
  const DenseMatrix modes = rigidModes(rigidBasis(body.mesh), body.nodes, system.dofs.frames);
  EXPECT_EQ(modes.cols(), body.mesh.dim == 2 ? 3 : 6);
  for (int m = 0; m < modes.cols(); ++m) {
    EXPECT_GT(norm(modes.column(m)), 0.1 * std::sqrt(double(body.nodes.numNodes())));
    EXPECT_LT(test::largest(product(modes.column(m))), 1e-13);
  }
}

TEST_P(Assembled, HasRowsThatAddUpToZeroInEveryDirection)
{
  const Vector x = test::Random(2).vector(numDofs);
  const Vector force = system.dofs.frames.toGlobal(product(x));
  for (int k = 0; k < body.mesh.dim; ++k) {
    double sum = 0.0;
    for (std::size_t dof = std::size_t(k); dof < numDofs; dof += std::size_t(body.mesh.dim))
      sum += force[dof];
    EXPECT_NEAR(sum, 0.0, 1e-13 * norm(force));
  }
}

TEST_P(Assembled, IsTheSameOnAnyNumberOfRanks)
{
  const BodySystem alone = test::assemble(body, Comm::single());
  const Vector x = test::Random(3).vector(numDofs);
  const Vector expected = multiply(alone.K, x, Comm::single()), computed = product(x);
  for (std::size_t i = 0; i < numDofs; ++i)
    EXPECT_NEAR(computed[i], expected[i], 1e-14 * norm(expected));
  EXPECT_EQ(comm.sum(std::int64_t(system.K.numRows())), body.nodes.numNodes());
  EXPECT_EQ(comm.sum(system.K.numBlocks()), alone.K.numBlocks());
}

TEST_P(Assembled, HasTheEnergyOfTheFieldWhateverTheAxes)
{
  const auto turnedAxes = test::Random(4).vector(numDofs);
  const BodyModel floating = test::makeBody(sampleMesh(GetParam()), GetParam().order);
  const BodySystem straight = test::assemble(floating, comm);
  EXPECT_FALSE(straight.dofs.frames.anyTurned());
  const double expected = energy(floating, turnedAxes);
  const auto product = [this](const BodySystem& s, const Vector& u) { return dot(u, multiply(s.K, u, comm)); };
  EXPECT_NEAR(product(straight, turnedAxes), expected, 1e-12 * expected);
  EXPECT_NEAR(product(system, system.dofs.frames.toLocal(turnedAxes)), expected, 1e-12 * expected);
}

INSTANTIATE_TEST_SUITE_P(Boxes, Assembled, testing::ValuesIn(allCases()), caseName);

namespace
{

/// Every component of every side prescribed to the affine field u = (0.01 (1 + x - 2 y), 0.02 (3 x + y), ...).
test::Conditions affineOnAllSides(const Mesh& mesh)
{
  test::Conditions conditions;
  for (const Side& side : mesh.sides) {
    auto support = test::onSide("Displacement", side.name);
    support.entries.insert(support.entries.end(), {{"X", "0.01*(1 + x - 2*y)"}, {"Y", "0.02*(3*x + y)"}});
    if (mesh.dim == 3)
      support.entries.emplace_back("Z", "0.01*(x + z)");
    conditions.supports.push_back(support);
  }
  return conditions;
}

void affine(const double* x, double* u, int dim)
{
  u[0] = 0.01 * (1.0 + x[0] - 2.0 * x[1]);
  u[1] = 0.02 * (3.0 * x[0] + x[1]);
  if (dim == 3)
    u[2] = 0.01 * (x[0] + x[2]);
}

} // namespace

struct PatchTest : testing::TestWithParam<Case>
{};

TEST_P(PatchTest, AffineBoundaryValuesGiveTheAffineField)
{
  const Mesh mesh = sampleMesh(GetParam());
  const BodyModel body = test::makeBody(mesh, GetParam().order, affineOnAllSides(mesh));
  const Vector u = test::solve(test::assemble(body, test::comm()), test::comm());
  const Vector exact =
      test::interpolate(body.nodes, [&](const double* x, double* value) { affine(x, value, mesh.dim); });
  for (std::size_t i = 0; i < u.size(); ++i)
    EXPECT_NEAR(u[i], exact[i], 1e-14);
}

TEST_P(PatchTest, UniformPressureBetweenInclinedRollersIsUniformStress)
{
  const int dim = GetParam().dim;
  test::Conditions conditions{{test::onSide("Roller", "left"), test::onSide("Roller", "bottom")}, {}};
  if (dim == 3)
    conditions.supports.push_back(test::onSide("Roller", "front"));
  conditions.loads.push_back({"Pressure", {{"Side", "right"}, {"Value", "0.5"}}});
  const BodyModel body = test::makeBody(sampleMesh(GetParam()), GetParam().order, conditions);
  const Vector u = test::solve(test::assemble(body, test::comm()), test::comm());
  const double c = std::cos(GetParam().rotation * M_PI / 180.0), s = std::sin(GetParam().rotation * M_PI / 180.0);
  for (const auto& stress : cellStress(body, u)) {
    const std::array<double, 6> exact = {-0.5 * c * c, -0.5 * s * s, dim == 2 ? -0.15 : 0.0, -0.5 * c * s, 0.0, 0.0};
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(stress[i], exact[i], 1e-13);
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, PatchTest, testing::ValuesIn(allCases()), caseName);

TEST(EffectiveLoad, IsTheLoadWithoutThePrescribedPart)
{
  const Comm& comm = test::comm();
  auto support = test::onSide("Displacement", "left");
  support.entries.emplace_back("X", "0.1 + y");
  const BodyModel body = test::makeBody(test::box({3, 2}), 2, {{support}, {{"Body Force", {{"X", "1"}, {"Y", "x"}}}}});
  const BodySystem system = test::assemble(body, comm);
  Vector prescribed(system.load.size(), 0.0);
  system.dofs.addPrescribed(prescribed);
  const Vector moved = multiply(system.K, prescribed, comm);
  const NodalField effective = system.effectiveLoad(comm).all(), load = system.load.all();
  EXPECT_GT(norm(moved), 0.1);
  for (std::size_t i = 0; i < effective.size(); ++i)
    EXPECT_NEAR(effective[i] + moved[i], load[i], 1e-15);
}

TEST(EffectiveLoad, IsTheLoadWhenNothingMoves)
{
  const BodyModel body = test::makeBody(test::box({3, 2}), 1,
                                        {{test::onSide("Clamp", "left")}, {{"Body Force", {{"X", "1"}, {"Y", "x"}}}}});
  const BodySystem system = test::assemble(body, test::comm());
  EXPECT_EQ(system.effectiveLoad(test::comm()).all(), system.load.all());
}

} // namespace ndframe
