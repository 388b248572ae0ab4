#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "assembly/sample_body.hpp"
#include "ndframe/assembly/rigid_modes.hpp"

namespace ndframe
{

namespace
{

using testing::ElementsAre;
using testing::UnorderedElementsAre;

/// What the supports leave free, by name.
std::vector<std::string> freeMotions(const Mesh& mesh, const ConstraintSet& constraints)
{
  const NodeMap nodes = makeNodeMap(mesh, 1);
  const RigidBasis basis = rigidBasis(mesh);
  return describeMotions(basis, nullSpace(supportRows(basis, nodes, constraints), rigidTolerance));
}

std::vector<std::string> freeMotions(const Mesh& mesh, const std::vector<test::Condition>& supports)
{
  return freeMotions(mesh, test::constraintsOf(test::makeBody(mesh, 1, {supports, {}})));
}

Mesh plane(double rotation = 0.0)
{
  return test::box({4, 2}, "Right", rotation, {2.0, 1.0});
}
Mesh space(double rotation = 0.0)
{
  return test::box({2, 2, 2}, "Right", rotation);
}

/// The nodes at those points held in all directions.
ConstraintSet heldAt(const Mesh& mesh, const std::vector<std::vector<double>>& points)
{
  ConstraintSet set(mesh.dim, 1.0);
  for (int p = 0; p < mesh.numPoints(); ++p)
    if (std::count(points.begin(), points.end(), std::vector<double>(mesh.point(p), mesh.point(p) + mesh.dim)) > 0)
      for (std::size_t k = 0; k < std::size_t(mesh.dim); ++k) {
        Direction axis{};
        axis[k] = 1.0;
        set.add({p, axis, 0.0});
      }
  return set;
}

} // namespace

TEST(RigidBasis, MovesWithoutStrainAboutTheCentre)
{
  for (const Mesh& mesh : {plane(), space()}) {
    const RigidBasis basis = rigidBasis(mesh);
    EXPECT_NEAR(basis.length, mesh.dim == 2 ? std::sqrt(5.0) : std::sqrt(3.0), 1e-15);
    EXPECT_EQ(basis.centre, mesh.dim == 2 ? (Direction{1.0, 0.5, 0.0}) : (Direction{0.5, 0.5, 0.5}));
    const double a[3] = {0.1, 0.9, 0.4}, b[3] = {1.3, -0.2, 0.6};
    for (int m = 0; m < basis.size(); ++m) {
      const Direction ua = basis.displacement(m, a), ub = basis.displacement(m, b);
      double stretch = 0.0;
      for (int k = 0; k < mesh.dim; ++k)
        stretch += (ub[std::size_t(k)] - ua[std::size_t(k)]) * (b[k] - a[k]);
      EXPECT_NEAR(stretch, 0.0, 1e-15);
      const Direction centre = basis.displacement(m, basis.centre.data());
      EXPECT_NEAR(dotProduct(centre, centre), m < mesh.dim ? 1.0 : 0.0, 1e-15);
    }
  }
}

TEST(RigidBasis, TurnsCounterclockwise)
{
  const double right[3] = {2.0, 0.5, 0.5};
  EXPECT_GT(rigidBasis(plane()).displacement(2, right)[1], 0.0);
  EXPECT_GT(rigidBasis(space()).displacement(5, right)[1], 0.0);
  EXPECT_LT(rigidBasis(space()).displacement(4, right)[2], 0.0);
}

TEST(SupportRows, SayHowRigidMotionsMoveThePrescribedDirections)
{
  const Mesh mesh = plane(30.0);
  const BodyModel body = test::makeBody(mesh, 2, {{test::onSide("Roller", "left")}, {}});
  const RigidBasis basis = rigidBasis(mesh);
  const DenseMatrix rows = supportRows(basis, body.nodes, test::constraintsOf(body));
  EXPECT_EQ(rows.rows(), 5);
  const Vector slide = multiply(rows, {-std::sin(M_PI / 6), std::cos(M_PI / 6), 0.0});
  EXPECT_LT(test::largest(slide), 1e-15);
  EXPECT_NEAR(test::largest(multiply(rows, {1.0, 0.0, 0.0})), std::cos(M_PI / 6), 1e-15);
}

TEST(DescribeMotions, FreeBodies)
{
  EXPECT_THAT(freeMotions(plane(), std::vector<test::Condition>()),
              ElementsAre("translation along x", "translation along y", "rotation about (1, 0.5)"));
  EXPECT_THAT(freeMotions(space(), std::vector<test::Condition>()),
              UnorderedElementsAre("translation along x", "translation along y", "translation along z",
                                   "rotation about the axis (1, 0, 0)", "rotation about the axis (0, 1, 0)",
                                   "rotation about the axis (0, 0, 1)"));
}

TEST(DescribeMotions, RollersLeaveTheSlideAlongThem)
{
  EXPECT_THAT(freeMotions(plane(), {test::onSide("Roller", "left")}), ElementsAre("translation along y"));
  EXPECT_THAT(freeMotions(space(), {test::onSide("Roller", "bottom")}),
              ElementsAre("translation along x", "translation along y", "rotation about the axis (0, 0, 1)"));
  EXPECT_THAT(freeMotions(space(), {test::onSide("Roller", "bottom"), test::onSide("Roller", "left")}),
              ElementsAre("translation along y"));
}

TEST(DescribeMotions, InclinedRollersLeaveTheSlideAlongThem)
{
  EXPECT_THAT(freeMotions(plane(30.0), {test::onSide("Roller", "bottom")}),
              ElementsAre("translation along (0.866, 0.5)"));
  EXPECT_THAT(freeMotions(plane(-30.0), {test::onSide("Roller", "bottom")}),
              ElementsAre("translation along (0.866, -0.5)"));
  EXPECT_THAT(freeMotions(space(30.0), {test::onSide("Roller", "right")}),
              ElementsAre("translation along z", "translation along (-0.5, 0.866, 0)",
                          "rotation about the axis (0.866, 0.5, 0)"));
}

TEST(DescribeMotions, AHeldPointIsTheCentreOfTheRotation)
{
  EXPECT_THAT(freeMotions(plane(), heldAt(plane(), {{0.0, 1.0}})), ElementsAre("rotation about (0, 1)"));
  EXPECT_THAT(freeMotions(plane(), heldAt(plane(), {{2.0, 0.5}})), ElementsAre("rotation about (2, 0.5)"));
  EXPECT_EQ(freeMotions(space(), heldAt(space(), {{0.0, 0.0, 0.0}})).size(), 3u);
}

TEST(DescribeMotions, AHeldEdgeIsTheAxisOfTheRotation)
{
  EXPECT_THAT(freeMotions(space(), heldAt(space(), {{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}})),
              ElementsAre("rotation about the axis (0, 0, 1)"));
}

TEST(DescribeMotions, HeldBodiesHaveNone)
{
  EXPECT_THAT(freeMotions(plane(), {test::onSide("Clamp", "left")}), ElementsAre());
  EXPECT_THAT(freeMotions(plane(), {test::onSide("Roller", "left"), test::onSide("Roller", "bottom")}), ElementsAre());
}

TEST(DescribeMotions, DoNotDependOnTheUnitOfLength)
{
  for (const double unit : {1e-6, 1e6}) {
    const Mesh mesh = test::moved(plane(30.0), [unit](double* x) { x[0] *= unit, x[1] *= unit; });
    EXPECT_THAT(freeMotions(mesh, {test::onSide("Roller", "bottom")}), ElementsAre("translation along (0.866, 0.5)"));
  }
}

/// centre (1, 0.5), length sqrt(5): a rotation coefficient of sqrt(5) turns by 1.
TEST(RigidMotion, IsToldWithItsSense)
{
  const RigidBasis flat = rigidBasis(plane()), box = rigidBasis(space());
  EXPECT_EQ(describeMotion(flat, {-2.0, 1e-9, 0.0}), "along -x");
  EXPECT_EQ(describeMotion(flat, {0.6, -0.8, 0.0}), "along (0.6, -0.8)");
  EXPECT_EQ(describeMotion(flat, {0.0, 0.0, 1.0}), "turning counterclockwise about (1, 0.5)");
  EXPECT_EQ(describeMotion(flat, {0.5, 1.0, -flat.length}), "turning clockwise about (2, 0)");
  EXPECT_EQ(describeMotion(box, {0.0, 0.0, 1e-3, 0.0, 0.0, 0.0}), "along +z");
  EXPECT_EQ(describeMotion(box, {1.0, 0.0, 0.0, 0.0, -3.0, 0.0}), "turning about the axis (0, -1, 0)");
}

} // namespace ndframe
