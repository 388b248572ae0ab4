#include <gtest/gtest.h>

#include <type_traits>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/algebra/field.hpp"

namespace ndframe
{

TEST(Field, HasItsWidthAtEveryNumberOfTheRank)
{
  NodalField u(IndexMap(9, {2, 4}, {8}), 3);
  EXPECT_EQ(u.size(), 9u);
  u.at(2)[1] = 5.0;
  EXPECT_EQ(u[7], 5.0);
  EXPECT_EQ(u.map().global(2), 8);
}

// Replication is a property of the map: values that are shared out are nobody's whole.
TEST(Field, OnlyAWholeFieldIsAVector)
{
  const NodalField whole = atNodes({1.0, 2.0, 3.0, 4.0}, 2);
  const Vector& values = whole;
  EXPECT_EQ(values.size(), 4u);
  EXPECT_EQ(whole.map().globalSize(), 2);
  const NodalField shared(IndexMap(3, {0}, {1}), 2);
  EXPECT_THROW(shared.whole(), InternalError);
}

// A traction is no force, and one value a node none of an unknown.
TEST(Field, OfOneKindIsNotTakenForAnother)
{
  EXPECT_FALSE((std::is_convertible_v<InterfaceValues, UnknownValues>));
  EXPECT_FALSE((std::is_convertible_v<UnknownValues, InterfaceValues>));
  EXPECT_FALSE((std::is_convertible_v<Vector, UnknownValues>)); // which says of what it has values
  EXPECT_TRUE((std::is_convertible_v<UnknownValues, Vector>));
  const UnknownValues shared(IndexMap(3, {0}, {1}), 1, {1.0, 2.0});
  EXPECT_THROW(norm(shared), InternalError);
}

TEST(Field, ValuesMustFitTheMap)
{
  EXPECT_THROW(NodalField(IndexMap::whole(2), 2, {1.0, 2.0, 3.0}), InternalError);
  EXPECT_THROW(CellValues(IndexMap(4, {1}, {0}), 1, {1.0, 2.0, 3.0, 4.0}), InternalError);
}

TEST(Field, AFieldThatEndsGivesItsValuesAway)
{
  CellValues eta = ofCells({1.0, 2.0});
  const double* const values = eta.data();
  const Vector taken = std::move(eta);
  EXPECT_EQ(taken.data(), values);
}

} // namespace ndframe
