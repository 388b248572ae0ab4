#include "ndframe/interface/traction_transfer.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "interface/box_bodies.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

/// Cells from 1 down to 1e-5 and up again.
std::vector<double> gradedLine()
{
  std::vector<double> x{0.0};
  for (const double h : {1.0, 0.1, 1e-3, 1e-5, 1e-5, 1e-2, 0.4, 1.0})
    x.push_back(x.back() + h);
  return x;
}

/// Each cell cut into `parts[its number modulo the size]` equal ones.
std::vector<double> cut(const std::vector<double>& x, const std::vector<int>& parts)
{
  std::vector<double> finer{x.front()};
  for (std::size_t e = 0; e + 1 < x.size(); ++e) {
    const int n = parts[e % parts.size()];
    for (int k = 1; k <= n; ++k)
      finer.push_back(k == n ? x[e + 1] : x[e] + (x[e + 1] - x[e]) * k / n);
  }
  return finer;
}

/// Moves the nodes of a straight interface: (s, 0) -> origin + s direction.
InterfaceMesh placed(InterfaceMesh interface, const Direction& origin, const Direction& direction)
{
  for (int i = 0; i < interface.numNodes(); ++i)
    for (std::size_t k = 2; k-- > 0;)
      interface.points[std::size_t(2 * i) + k] = origin[k] + interface.point(i)[0] * direction[k];
  return interface;
}

InterfaceMesh turned(const std::vector<double>& x, int order)
{
  return placed(straightInterface(x, order), {3.0, -7.0, 0.0}, {std::cos(0.7), std::sin(0.7), 0.0});
}

InterfaceMesh flat(const std::string& cells, int order)
{
  return pairSides(interfaceEntry("bottom", "top"), boxBody("upper", box("0, 0, 0", "2, 1, 1", cells), order),
                   boxBody("lower", box("0, 0, -1", "2, 1, 0", cells), order));
}

/// A closed polygon with these vertices on the unit circle.
InterfaceMesh ring(int cells, double phase)
{
  InterfaceMesh interface;
  interface.dim = 2;
  interface.order = 1;
  for (int i = 0; i < cells; ++i) {
    const double angle = phase + 2.0 * M_PI * i / cells;
    interface.points.insert(interface.points.end(), {std::cos(angle), std::sin(angle)});
    interface.sides[0].nodes.push_back(i);
    interface.facets.insert(interface.facets.end(), {i, (i + 1) % cells});
    interface.measures.push_back(2.0 * std::sin(M_PI / cells));
  }
  return interface;
}

/// A linear (order 1) or quadratic function of the place.
double polynomial(const double* x, int dim, int order)
{
  const double z = dim == 3 ? x[2] : 0.0, linear = 1.5 - 0.7 * x[0] + 0.4 * x[1] + z;
  return order == 1 ? linear : linear + 0.3 * x[0] * x[0] - 0.8 * x[0] * x[1] + 0.2 * x[1] * x[1];
}

Vector polynomialOn(const InterfaceMesh& mesh, int order)
{
  Vector values;
  for (int i = 0; i < mesh.numNodes(); ++i)
    values.push_back(polynomial(mesh.point(i), mesh.dim, order));
  return values;
}

Vector carried(const std::vector<InterfaceMesh>& from, Vector traction, const std::vector<InterfaceMesh>& to)
{
  return transferTraction(from, atInterface(std::move(traction)), to);
}

void expectNear(const Vector& a, const Vector& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_NEAR(a[i], b[i], tolerance * std::max(1.0, largestEntry(b))) << i;
}

/// Bernstein coefficients of the polynomial on a facet of a line.
std::vector<double> bernstein(const InterfaceMesh& mesh, const Vector& values, int facet)
{
  const int n = mesh.nodesPerFacet();
  const auto value = [&](int a) { return values[std::size_t(mesh.facets[std::size_t(facet * n + a)])]; };
  if (n == 2)
    return {value(0), value(1)};
  return {value(0), 2.0 * value(2) - 0.5 * (value(0) + value(1)), value(1)};
}

/// Nodal values whose Bernstein coefficients are random, none above 0, and many equal to 0.
Vector pressing(const InterfaceMesh& mesh, unsigned seed)
{
  Vector values = randomVector(std::size_t(mesh.numNodes()), seed);
  for (double& value : values)
    value = std::min(value, 0.0);
  for (int f = 0; mesh.order == 2 && f < mesh.numFacets(); ++f) {
    const int* nodes = mesh.facets.data() + 3 * f;
    double& middle = values[std::size_t(nodes[2])];
    middle = 0.5 * middle + 0.25 * (values[std::size_t(nodes[0])] + values[std::size_t(nodes[1])]);
  }
  return values;
}

const std::vector<int> bisected{2, 1, 4, 2, 3};

} // namespace

TEST(TractionTransfer, KeepsPolynomialsOfItsOrderOnAnyMesh)
{
  for (const int order : {1, 2}) {
    const InterfaceMesh from = turned(gradedLine(), order);
    const double length = gradedLine().back();
    for (const int newOrder : {1, 2})
      for (const auto& line : {cut(gradedLine(), bisected), cut({0.0, length}, {7}), cut({0.0, length}, {300})}) {
        const InterfaceMesh to = turned(line, newOrder);
        expectNear(carried({from}, polynomialOn(from, order), {to}), polynomialOn(to, order), 1e-13);
      }
  }
}

TEST(TractionTransfer, KeepsPolynomialsOnPlaneSidesOfSolids)
{
  for (const int order : {1, 2}) {
    const InterfaceMesh from = flat("3, 2, 1", order), to = flat("4, 5, 1", order);
    expectNear(carried({from}, polynomialOn(from, order), {to}), polynomialOn(to, order), 1e-13);
  }
}

TEST(TractionTransfer, KeepsTheWorkOnOldPolynomialsWhereMeshesAreNested)
{
  // Resultant and moment among them.
  for (const int order : {1, 2}) {
    const InterfaceMesh from = turned(gradedLine(), order), to = turned(cut(gradedLine(), bisected), order);
    const ContactMatrix oldC({from}), newC({to});
    for (unsigned seed = 0; seed < 10; ++seed) {
      const Vector traction = randomVector(std::size_t(oldC.size()), seed);
      const Vector motion = randomVector(std::size_t(oldC.size()), seed + 50);
      const double before = dot(motion, oldC.apply(traction));
      const double after = dot(carried({from}, motion, {to}), newC.apply(carried({from}, traction, {to})));
      EXPECT_NEAR(after, before, 1e-11); // positions of cells of 1e-5 have 1e-11 of their size
    }
  }
}

TEST(TractionTransfer, KeepsBernsteinCoefficientsOfOneSign)
{
  for (const int order : {1, 2}) {
    const InterfaceMesh from = straightInterface(gradedLine(), order);
    const InterfaceMesh to = straightInterface(cut(gradedLine(), bisected), order);
    for (unsigned seed = 0; seed < 10; ++seed) {
      const Vector values = carried({from}, pressing(from, seed), {to});
      for (int f = 0; f < to.numFacets(); ++f)
        for (const double coefficient : bernstein(to, values, f))
          EXPECT_LE(coefficient, 1e-11);
    }
  }
}

TEST(TractionTransfer, ToTheSameMeshChangesNothing)
{
  for (const auto& mesh : {turned(gradedLine(), 1), turned(gradedLine(), 2), flat("3, 2, 1", 1), flat("3, 2, 1", 2)}) {
    const Vector values = randomVector(std::size_t(mesh.numNodes()), 1);
    expectNear(carried({mesh}, values, {mesh}), values, 1e-10);
  }
}

TEST(TractionTransfer, DoesNotMixInterfacesThatLieAtTheSamePlace)
{
  const std::vector<InterfaceMesh> from{straightInterface({0.0, 1.0, 3.0}, 2), straightInterface({0.0, 2.0, 3.0}, 1)};
  const std::vector<InterfaceMesh> to{straightInterface({0.0, 0.5, 3.0}, 2),
                                      straightInterface({0.0, 1.0, 2.0, 3.0}, 1)};
  expectNear(carried(from, {-1.0, -1.0, -1.0, -1.0, -1.0, -2.0, -4.0, -3.0}, to),
             {-1.0, -1.0, -1.0, -1.0, -1.0, -2.0, -3.0, -4.0, -3.0}, 1e-14);
}

TEST(TractionTransfer, FindsItsFacetBetweenNearbyBranchesOfOneInterface)
{
  // Two sides of a slot of width 1e-3, one with cells of 1, the other with cells of 1e-2: the nearest node is often
  // one of the other side.
  const auto slot = [](int lowerCells, int upperCells) {
    InterfaceMesh both = straightInterface(cut({0.0, 4.0}, {lowerCells}), 1);
    const InterfaceMesh upper =
        placed(straightInterface(cut({0.0, 4.0}, {upperCells}), 1), {0.0, 1e-3, 0.0}, {1.0, 0.0, 0.0});
    for (const int node : upper.facets)
      both.facets.push_back(node + both.numNodes());
    both.points.insert(both.points.end(), upper.points.begin(), upper.points.end());
    both.measures.insert(both.measures.end(), upper.measures.begin(), upper.measures.end());
    both.sides[0].nodes.resize(both.points.size() / 2);
    return both;
  };
  const auto sideValues = [](const InterfaceMesh& mesh) {
    Vector values;
    for (int i = 0; i < mesh.numNodes(); ++i)
      values.push_back((mesh.point(i)[1] > 0.0 ? -5.0 : -1.0) * (1.0 + mesh.point(i)[0]));
    return values;
  };
  const InterfaceMesh from = slot(4, 400), to = slot(37, 3);
  expectNear(carried({from}, sideValues(from), {to}), sideValues(to), 1e-14);
}

TEST(TractionTransfer, FollowsACurveThatIsMeshedAnew)
{
  const auto onRing = [](const InterfaceMesh& mesh) {
    Vector values;
    for (int i = 0; i < mesh.numNodes(); ++i)
      values.push_back(mesh.point(i)[0] * mesh.point(i)[1]);
    return values;
  };
  for (const int cells : {40, 80}) {
    const InterfaceMesh from = ring(cells, 0.1), to = ring(3 * cells / 2 + 1, 0.2);
    // sin(2 a) / 2 has the curvature 2; linear interpolation errs by h^2 / 8 of it.
    const double h = 2.0 * M_PI / cells;
    expectNear(carried({from}, onRing(from), {to}), onRing(to), 1.1 * h * h / 4.0);
  }
}

TEST(ClosedTransfer, KeepsTheStatusesOfNodesThatStay)
{
  for (const int order : {1, 2}) {
    const InterfaceMesh from = turned(gradedLine(), order), to = turned(cut(gradedLine(), {2, 1, 4}), order);
    std::vector<char> closed;
    for (const double number : randomVector(std::size_t(from.numNodes()), 4))
      closed.push_back(number > 0.0);
    const auto finer = transferClosed({from}, closed, {to});
    ASSERT_EQ(int(finer.size()), to.numNodes());
    int kept = 0;
    for (int i = 0; i < from.numNodes(); ++i)
      for (int j = 0; j < to.numNodes(); ++j)
        if (std::hypot(from.point(i)[0] - to.point(j)[0], from.point(i)[1] - to.point(j)[1]) < 1e-9) {
          EXPECT_EQ(finer[std::size_t(j)], closed[std::size_t(i)]);
          ++kept;
        }
    EXPECT_EQ(kept, from.numNodes());
  }
}

TEST(ClosedTransfer, TakesTheNearestNodeOfTheFacetAndClosesHalfway)
{
  const InterfaceMesh from = straightInterface({0.0, 1.0, 2.0, 10.0}, 1);
  const InterfaceMesh to = straightInterface({0.0, 1.0, 1.4, 1.5, 1.6, 2.0, 5.9, 6.1, 10.0}, 1);
  EXPECT_EQ(transferClosed({from}, {1, 1, 0, 1}, {to}), (std::vector<char>{1, 1, 1, 1, 0, 0, 0, 1, 1}));
  const InterfaceMesh quadratic = straightInterface({0.0, 1.0, 2.0}, 2);
  const InterfaceMesh finer = straightInterface({0.0, 0.5, 1.0, 1.5, 2.0}, 2);
  EXPECT_EQ(transferClosed({quadratic}, {1, 1, 0, 0, 0}, {finer}), (std::vector<char>{1, 1, 1, 1, 0, 0, 0, 0, 0}));
}

TEST(ClosedTransfer, StatusesOfUnknownsAndOfNodesAreTranslated)
{
  InterfaceSystem system;
  system.nodeOfUnknown = {1, 3, 2};
  system.C = std::make_shared<ContactMatrix>(std::vector<InterfaceMesh>{straightInterface({0.0, 1.0, 2.0, 3.0}, 1)});
  EXPECT_EQ(statusesOfNodes(system, {1, 0, 0}), (std::vector<char>{1, 1, 0, 0}));
  EXPECT_EQ(statusesOfUnknowns(system, {1, 0, 1, 0}), (std::vector<char>{0, 0, 1}));
}
