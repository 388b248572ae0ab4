#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "admissibility/sample_chains.hpp"

namespace ndframe
{

namespace
{

using test::Chain;

Vector project(const Chain& chain, const Vector& mean, const BalanceConditions& balance = {})
{
  return projectTraction(chain.patches, chain.numNodes(), chain.order, mean, balance);
}

/// The largest Bernstein coefficient from the nodal values themselves.
double largestCoefficient(const Chain& chain, const Vector& t)
{
  double largest = *std::max_element(t.begin(), t.end());
  for (const ContactPatch& patch : chain.patches)
    if (chain.order == 2)
      largest = std::max(largest, 2.0 * t[std::size_t(patch.nodes[2])] -
                                      0.5 * (t[std::size_t(patch.nodes[0])] + t[std::size_t(patch.nodes[1])]));
  return largest;
}

double largestDifference(const Vector& a, const Vector& b)
{
  const Vector d = difference(a, b);
  return std::abs(*std::max_element(d.begin(), d.end(), [](double x, double y) { return std::abs(x) < std::abs(y); }));
}

std::string infeasibleMotion(const Chain& chain, const BalanceConditions& balance)
{
  try {
    project(chain, Vector(std::size_t(chain.numNodes()), -1.0), balance);
    return "feasible";
  } catch (const InfeasibleTraction& failure) {
    return failure.motion;
  }
}

} // namespace

TEST(AdmissibleTraction, ProjectionIsTheIdentityOnAdmissibleTractions)
{
  std::mt19937 random(1);
  for (const Chain& chain : test::sampleChains(random)) {
    const Vector t = test::admissibleNodes(chain, random);
    EXPECT_LT(largestDifference(project(chain, t), t), 1e-14);
    const Vector one(t.size(), 1.0);
    const auto balance =
        test::resultantAndMoment(chain, test::innerProduct(chain, t, one), test::innerProduct(chain, t, chain.x));
    EXPECT_LT(largestDifference(project(chain, t, balance), t), 1e-13);
  }
}

TEST(AdmissibleTraction, NothingAdmissibleIsNearer)
{
  // t is the nearest of a convex set exactly if (mean - t, s - t) <= 0 for every s of the set
  std::mt19937 random(2);
  for (const Chain& chain : test::sampleChains(random))
    for (const bool floating : {false, true}) {
      const Vector load = test::admissibleNodes(chain, random), one(load.size(), 1.0);
      const auto balance = floating ? test::resultantAndMoment(chain, test::innerProduct(chain, load, one),
                                                               test::innerProduct(chain, load, chain.x))
                                    : BalanceConditions{};
      const Vector mean = test::randomNodes(chain.numNodes(), random), t = project(chain, mean, balance);
      EXPECT_LT(test::innerProduct(chain, difference(mean, t), difference(load, t)), 1e-12);
      for (int other = 0; other < 20; ++other) {
        const Vector s = project(chain, test::randomNodes(chain.numNodes(), random), balance);
        EXPECT_LT(test::innerProduct(chain, difference(mean, t), difference(s, t)), 1e-12);
      }
    }
}

TEST(AdmissibleTraction, BernsteinCoefficientsAreNotPositive)
{
  std::mt19937 random(3);
  for (const Chain& chain : test::sampleChains(random)) {
    const Vector t = project(chain, test::randomNodes(chain.numNodes(), random));
    EXPECT_LT(largestCoefficient(chain, t), 1e-15);
    EXPECT_LT(largestBernstein(tractionFromNodes(chain.patches, t, chain.order, chain.order + 1), chain.patches),
              1e-14);
  }
}

TEST(AdmissibleTraction, ResultantAndMomentAreKept)
{
  std::mt19937 random(4);
  for (const int order : {1, 2}) {
    const Chain chain = test::straightChain(test::randomLengths(30, random), order);
    const Vector load = test::admissibleNodes(chain, random), one(load.size(), 1.0);
    const double force = test::innerProduct(chain, load, one), moment = test::innerProduct(chain, load, chain.x);
    const Vector t =
        project(chain, test::randomNodes(chain.numNodes(), random), test::resultantAndMoment(chain, force, moment));
    EXPECT_NEAR(test::innerProduct(chain, t, one), force, 1e-12 * std::abs(force));
    EXPECT_NEAR(test::innerProduct(chain, t, chain.x), moment, 1e-12 * std::abs(moment));
    EXPECT_LT(largestCoefficient(chain, t), 1e-15);
  }
}

TEST(AdmissibleTraction, AMeanThatPullsEverywhereBecomesZero)
{
  const Chain chain = test::straightChain({1.0, 0.5, 0.25}, 2);
  EXPECT_EQ(project(chain, Vector(7, 3.0)), Vector(7, 0.0));
}

TEST(AdmissibleTraction, AForceAtTheVeryEndIsCarriedByTheEndAlone)
{
  const Chain chain = test::straightChain({1.0, 1.0}, 1);
  // only the hat of the last node has its resultant so far out
  const auto t = project(chain, {-1.0, -1.0, -1.0}, test::resultantAndMoment(chain, -1.0, -5.0 / 3.0));
  EXPECT_LT(largestDifference(t, {0.0, 0.0, -2.0}), 1e-12);
}

TEST(AdmissibleTraction, LoadsThatPullAreNamed)
{
  const Chain chain = test::straightChain({1.0, 1.0, 2.0}, 2);
  EXPECT_EQ(infeasibleMotion(chain, test::resultantAndMoment(chain, -1.0, -2.0)), "feasible");
  EXPECT_EQ(infeasibleMotion(chain, test::resultantAndMoment(chain, 1.0, 0.0)), "translation");
  EXPECT_EQ(infeasibleMotion(chain, test::resultantAndMoment(chain, -1.0, -20.0)), "translation and rotation");
}

TEST(AdmissibleTraction, AMotionAlongTheInterfaceAsksForNothing)
{
  const Chain chain = test::straightChain({1.0, 1.0, 2.0}, 2);
  const Vector mean(7, -1.0);
  BalanceConditions balance{SparseColumns(7, 1), {1e-15}, {1.0}, {"translation along x"}};
  balance.work(3, 0) = 1e-16; // what the dot product of a tangent and a normal leaves
  EXPECT_LT(largestDifference(project(chain, mean, balance), mean), 1e-14);
  balance.value = {1e-3};
  EXPECT_EQ(infeasibleMotion(chain, balance), "translation along x");
}

TEST(AdmissibleTraction, NumberingAndDirectionOfFacetsDoNotMatter)
{
  std::mt19937 random(5);
  for (const Chain& chain : test::sampleChains(random)) {
    const Vector mean = test::randomNodes(chain.numNodes(), random), load = test::admissibleNodes(chain, random);
    const auto balanced = [&](const Chain& c, const Vector& forces) {
      return test::resultantAndMoment(c, test::innerProduct(c, forces, Vector(forces.size(), 1.0)),
                                      test::innerProduct(c, forces, c.x));
    };
    std::vector<int> numbers;
    const Chain other = test::shuffled(chain, random, numbers);
    Vector otherMean(mean.size()), otherLoad(mean.size()), back(mean.size());
    for (std::size_t i = 0; i < mean.size(); ++i) {
      otherMean[std::size_t(numbers[i])] = mean[i];
      otherLoad[std::size_t(numbers[i])] = load[i];
    }
    const Vector t = project(chain, mean, balanced(chain, load)),
                 s = project(other, otherMean, balanced(other, otherLoad));
    for (std::size_t i = 0; i < mean.size(); ++i)
      back[i] = s[std::size_t(numbers[i])];
    EXPECT_LT(largestDifference(back, t), 1e-12);
  }
}

TEST(AdmissibleTraction, UnitsDoNotMatter)
{
  std::mt19937 random(6);
  const Chain chain = test::straightChain(test::randomLengths(12, random), 2);
  Chain scaled = chain;
  const double length = 1e-9, stress = 1e11;
  for (ContactPatch& patch : scaled.patches)
    patch.measure *= length;
  Vector mean = test::randomNodes(chain.numNodes(), random), load = test::admissibleNodes(chain, random);
  const double force = test::innerProduct(chain, load, Vector(load.size(), 1.0)),
               moment = test::innerProduct(chain, load, chain.x); // per unit of length, as RigidBasis scales rotations
  const Vector t = project(chain, mean, test::resultantAndMoment(chain, force, moment));
  for (double& value : mean)
    value *= stress;
  Vector s = project(scaled, mean, test::resultantAndMoment(scaled, force * length * stress, moment * length * stress));
  for (double& value : s)
    value /= stress;
  EXPECT_LT(largestDifference(s, t), 1e-12);
}

TEST(AdmissibleTraction, LargeInterfacesAreSolved)
{
  std::mt19937 random(7);
  const Chain chain = test::straightChain(test::randomLengths(20000, random), 2);
  const Vector mean = test::randomNodes(chain.numNodes(), random), t = project(chain, mean);
  EXPECT_LT(largestCoefficient(chain, t), 1e-15);
  EXPECT_LT(std::abs(test::innerProduct(chain, difference(mean, t), t)), 1e-12 * test::innerProduct(chain, t, t));
}

} // namespace ndframe
