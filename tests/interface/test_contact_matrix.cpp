#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "interface/box_bodies.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

double total(const Vector& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

Vector unitVector(std::size_t size, std::size_t i)
{
  Vector e(size, 0.0);
  e[i] = 1.0;
  return e;
}

/// Cells from 1 down to 1e-5.
std::vector<double> gradedLine()
{
  std::vector<double> x{0.0};
  for (double h = 1e-5; h < 2.0; h *= 10.0)
    for (int i = 0; i < 3; ++i)
      x.push_back(x.back() + h);
  return x;
}

/// The side x-axis turned by 30 degrees, length 2.
InterfaceMesh turnedInterface(int order)
{
  const std::string turn = "<Parameter name=\"Rotation\" type=\"double\" value=\"30\"/>\n";
  const std::string grading = doubles("Grading", "20, 1");
  return pairSides(interfaceEntry("bottom", "top"),
                   boxBody("upper", box("0, 0", "2, 1", "5, 2") + grading + turn, order),
                   boxBody("lower", box("0, -1", "2, 0", "5, 2") + grading + turn, order));
}

InterfaceMesh flatInterface(int order)
{
  return pairSides(interfaceEntry("bottom", "top"), boxBody("upper", box("0, 0, 0", "2, 1, 1", "3, 2, 2"), order),
                   boxBody("lower", box("0, 0, -1", "2, 1, 0", "3, 2, 1"), order));
}

/// int x^k y^k dS by the contact matrix.
double moment(const InterfaceMesh& interface, int k)
{
  Vector x, y;
  for (int i = 0; i < interface.numNodes(); ++i) {
    x.push_back(std::pow(interface.point(i)[0], k));
    y.push_back(std::pow(interface.point(i)[1], k));
  }
  return dot(x, ContactMatrix({interface}).apply(y));
}

} // namespace

TEST(ContactMatrix, IsSymmetric)
{
  for (const int order : {1, 2}) {
    const auto interface = turnedInterface(order);
    const ContactMatrix C({interface});
    const Vector v = randomVector(std::size_t(C.size()), 1), w = randomVector(std::size_t(C.size()), 2);
    EXPECT_NEAR(dot(v, C.apply(w)), dot(w, C.apply(v)), 1e-15);
  }
}

TEST(ContactMatrix, RowSumsAreTheIntegralsOfTheShapeFunctions)
{
  const ContactMatrix linear({straightInterface({0.0, 1.0, 4.0}, 1)});
  const Vector P1 = linear.apply(Vector(3, 1.0)), expectedP1{0.5, 2.0, 1.5};
  const ContactMatrix quadratic({straightInterface({0.0, 1.0, 4.0}, 2)});
  const Vector P2 = quadratic.apply(Vector(5, 1.0)), expectedP2{1.0 / 6, 4.0 / 6, 4.0 / 6, 2.0, 0.5};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(P1[i], expectedP1[i], 1e-15);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(P2[i], expectedP2[i], 1e-15);
}

TEST(ContactMatrix, SumIsTheMeasureOfTheSide)
{
  for (const int order : {1, 2})
    for (const auto& interface : {turnedInterface(order), flatInterface(order)}) {
      const ContactMatrix C({interface});
      EXPECT_NEAR(total(C.apply(Vector(std::size_t(C.size()), 1.0))), 2.0, 1e-14);
    }
}

TEST(ContactMatrix, IntegratesProductsOfItsPolynomialsExactly)
{
  // Along the line (cos 30, sin 30) s, 0 <= s <= 2, and on the rectangle 2 x 1.
  const double cs = std::sqrt(3.0) / 4.0;
  EXPECT_NEAR(moment(turnedInterface(1), 1), cs * 8.0 / 3.0, 1e-14);
  EXPECT_NEAR(moment(turnedInterface(2), 2), cs * cs * 32.0 / 5.0, 1e-14);
  EXPECT_NEAR(moment(flatInterface(1), 1), 1.0, 1e-14);
  EXPECT_NEAR(moment(flatInterface(2), 2), 8.0 / 9.0, 1e-14);
}

TEST(ContactMatrix, SolveUndoesApplyOnAnyMesh)
{
  for (const int order : {1, 2})
    for (const auto& interface : {turnedInterface(order), flatInterface(order), straightInterface(gradedLine(), order)})
    {
      const ContactMatrix C({interface});
      const Vector x = randomVector(std::size_t(C.size()), 3);
      EXPECT_LT(relativeDifference(C.solve(C.apply(x)), x), 1e-14);
    }
}

TEST(ContactMatrix, SolveOfNothingIsNothing)
{
  const ContactMatrix C({straightInterface({0.0, 1.0, 4.0}, 2)});
  EXPECT_EQ(C.solve(Vector(5, 0.0)), Vector(5, 0.0));
}

TEST(ContactMatrix, InterfacesDoNotTouchEachOther)
{
  const auto first = straightInterface({0.0, 1.0, 4.0}, 1), second = straightInterface({0.0, 0.5}, 1);
  const ContactMatrix both({first, second}), one({first}), other({second});
  ASSERT_EQ(both.size(), 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const Vector column = both.apply(unitVector(5, i));
    Vector expected = i < 3 ? one.apply(unitVector(3, i)) : Vector(3, 0.0);
    const Vector rest = i < 3 ? Vector(2, 0.0) : other.apply(unitVector(2, i - 3));
    expected.insert(expected.end(), rest.begin(), rest.end());
    EXPECT_EQ(column, expected);
  }
}
