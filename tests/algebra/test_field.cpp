#include <gtest/gtest.h>

#include <type_traits>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/algebra/field.hpp"
#include "ndframe/algebra/sparse_field.hpp"

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
  const Vector taken = std::move(eta).operator Vector();
  EXPECT_EQ(taken.data(), values);
}

TEST(SparseField, HasTheValuesThatItWasMadeFrom)
{
  const NodalField some = atNodes({0.0, 0.0, 0.0, -3.0, 0.0, 0.0, 2.0, 1.0}, 2);
  const SparseField sparse(some);
  EXPECT_EQ(sparse.all(), some);
  EXPECT_EQ(sparse.size(), some.size());
  EXPECT_EQ(sparse.largest(), 3.0);
  Vector x(some.size(), 1.0);
  sparse.addTo(x, 2.0);
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_EQ(x[i], 1.0 + 2.0 * some[i]);
}

// What a load on a side takes does not grow with the inside of the body.
TEST(SparseField, StoresOnlyNodesThatHaveSomething)
{
  std::vector<int> stored;
  const auto note = [&](IndexMap::Global node, const double*) { stored.push_back(int(node)); };
  SparseField(atNodes({0.0, 0.0, 0.0, -3.0, 0.0, 0.0, 2.0, 0.0}, 2)).each(note);
  EXPECT_EQ(stored, (std::vector<int>{1, 3}));
  const SparseField nothing(atNodes(Vector(6, 0.0), 3));
  nothing.each(note);
  EXPECT_EQ(stored.size(), 2u);
  EXPECT_TRUE(nothing.isZero());
  EXPECT_EQ(nothing.all(), atNodes(Vector(6, 0.0), 3));
}

} // namespace ndframe
