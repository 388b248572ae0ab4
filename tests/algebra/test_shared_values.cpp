// Values that several ranks hold and one of them owns.

#include <gtest/gtest.h>

#include "common/test_main.hpp"
#include "ndframe/algebra/dense.hpp"
#include "ndframe/algebra/shared_values.hpp"

namespace ndframe
{
namespace
{

/// A ring of ranks: every rank owns thing 0, which it lends to the next rank as its thing 1. Things have two values
/// each, that of others first.
class Ring
{
public:
  Ring() : values_(list(), test::comm()) {}

  static SharedValues::Place place(int thing) { return {thing == 0 ? 2U : 0U, 2U}; }
  const SharedValues& operator*() const { return values_; }
  static int ranks() { return test::comm().size(); }
  static int before() { return (test::comm().rank() + ranks() - 1) % ranks(); }

private:
  static std::vector<SharedWith> list()
  {
    const int next = (test::comm().rank() + 1) % ranks();
    if (ranks() == 1)
      return {};
    std::vector<SharedWith> all;
    for (int rank = 0; rank < ranks(); ++rank)
      if (rank == next || rank == before())
        all.push_back({rank, rank == next ? std::vector<int>{0} : std::vector<int>(),
                       rank == before() ? std::vector<int>{1} : std::vector<int>()});
    return all;
  }

  SharedValues values_;
};

} // namespace

TEST(SharedValues, BorrowersGetWhatOwnersHave)
{
  const Ring ring;
  const double own = test::comm().rank();
  Vector values{-1.0, -1.0, own, own + 0.5};
  (*ring).fetch(Ring::place, values);
  const double other = Ring::ranks() == 1 ? -1.0 : Ring::before();
  EXPECT_EQ(values, (Vector{other, Ring::ranks() == 1 ? -1.0 : other + 0.5, own, own + 0.5}));
  EXPECT_EQ((*ring).messages(), Ring::ranks() == 1 ? 0 : 1);
  EXPECT_EQ((*ring).bytes(), Ring::ranks() == 1 ? 0 : 16);
}

TEST(SharedValues, OwnersGetTheSumsAndBorrowersNothing)
{
  const Ring ring;
  const double own = test::comm().rank();
  Vector values{1.0, 10.0, own, own};
  (*ring).add(Ring::place, values);
  EXPECT_EQ(values, Ring::ranks() == 1 ? (Vector{1.0, 10.0, own, own}) : (Vector{0.0, 0.0, own + 1.0, own + 10.0}));
}

TEST(SharedValues, RanksLearnWhatOthersWant)
{
  std::vector<std::vector<std::int64_t>> wanted(std::size_t(Ring::ranks()));
  for (int rank = 0; rank < Ring::ranks(); ++rank)
    wanted[std::size_t(rank)].assign(std::size_t(rank), 100 * test::comm().rank() + rank);
  const auto asked = askedFor(wanted, test::comm());
  for (int rank = 0; rank < Ring::ranks(); ++rank)
    EXPECT_EQ(asked[std::size_t(rank)],
              std::vector<std::int64_t>(std::size_t(test::comm().rank()), 100 * rank + test::comm().rank()));
}

TEST(SharedValues, GatheredAndLargestAreTheSameOnAllRanks)
{
  const int rank = test::comm().rank(), ranks = Ring::ranks();
  const Vector all = gatheredFrom(Vector(std::size_t(rank), double(rank)), test::comm());
  Vector expected;
  for (int r = 0; r < ranks; ++r)
    expected.insert(expected.end(), std::size_t(r), double(r));
  EXPECT_EQ(all, expected);
  Vector largest{double(rank), -double(rank)};
  takeLargest(largest, test::comm());
  EXPECT_EQ(largest, (Vector{double(ranks - 1), 0.0}));
}

TEST(Reductions, AreCountedWithTheLargestOfThem)
{
  const int ranks = Ring::ranks();
  Ledger ledger;
  countReductions(ledger); // of the tests before
  ledger.restart();
  Vector values(5, 1.0);
  test::comm().sum(values);
  test::comm().sum(std::int64_t(1));
  takeLargest(values, test::comm());
  countReductions(ledger);
  gatheredFrom(Vector(4, 1.0), test::comm());
  countReductions(ledger);
  countReductions(ledger);
  const std::map<std::string, std::int64_t> counts{{"reductions", 5},
                                                   {"reduction bytes", 40 + 8 + 40 + 4 * ranks + 32 * ranks},
                                                   {"largest reduction", std::max(40, 32 * ranks)}};
  EXPECT_EQ(ledger.counts(), ranks > 1 ? counts : decltype(counts)());
}

TEST(SharedValues, AMatrixThatIsNotDefiniteOnOneRankIsSoOnAll)
{
  const int last = test::comm().size() - 1;
  const auto fail = [&](int row) {
    return [&test = test::comm(), last, row] {
      if (test.rank() == last)
        throw NotPositiveDefinite(row);
    };
  };
  for (const int row : {-1, 0, 7}) {
    int found = -2;
    try {
      definiteOnEveryRank(test::comm(), fail(row));
    } catch (const NotPositiveDefinite& failure) {
      found = failure.row;
    }
    EXPECT_EQ(found, row);
  }
  EXPECT_NO_THROW(definiteOnEveryRank(test::comm(), [] {}));
}

} // namespace ndframe
