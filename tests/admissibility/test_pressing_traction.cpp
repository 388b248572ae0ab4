// The projection that asks for t <= 0 at the nodes and nothing else, TractionSign::Values: the paper's.

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "admissibility/sample_chains.hpp"

namespace ndframe
{

namespace
{

using test::Chain;

Vector project(const Chain& chain, const Vector& mean, const BalanceConditions& balance, TractionSign sign)
{
  return projectTraction(chain.patches, chain.numNodes(), chain.order, mean, balance, sign);
}

double largestValue(const Vector& t)
{
  return *std::max_element(t.begin(), t.end());
}

double largestCoefficient(const Chain& chain, const Vector& t)
{
  return largestBernstein(tractionFromNodes(chain.patches, t, chain.order, 2), chain.patches);
}

/// -(a + b s)^2 on every facet, continuous along the chain: touches zero inside some of them.
Vector touchingNodes(const Chain& chain, std::mt19937& random)
{
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  Vector root(std::size_t(chain.numNodes())), t(root.size());
  for (double& value : root)
    value = any(random);
  for (std::size_t i = 0; i < t.size(); ++i)
    t[i] = -root[i] * root[i];
  for (const ContactPatch& patch : chain.patches)
    if (chain.order == 2) {
      const double middle = 0.5 * (root[std::size_t(patch.nodes[0])] + root[std::size_t(patch.nodes[1])]);
      t[std::size_t(patch.nodes[2])] = -middle * middle;
    }
  return t;
}

BalanceConditions balanceOf(const Chain& chain, const Vector& load)
{
  const Vector one(load.size(), 1.0);
  return test::resultantAndMoment(chain, test::innerProduct(chain, load, one),
                                  test::innerProduct(chain, load, chain.x));
}

/// A square of 2 n^2 triangles with the nodes of order 2.
std::vector<ContactPatch> squarePatches(int n)
{
  const int row = 2 * n + 1;
  std::vector<ContactPatch> patches;
  for (int cell = 0; cell < n * n; ++cell)
    for (const int second : {1, row}) { // to the right first, or up
      ContactPatch patch;
      patch.dim = 3;
      patch.normal = {0.0, 0.0, 1.0};
      patch.measure = 0.5 / n / n;
      const int corner = 2 * (cell / n) * row + 2 * (cell % n);
      const std::array<int, 3> vertices{corner, corner + 2 * second, corner + 2 + 2 * row};
      for (std::size_t i = 0; i < 3; ++i) {
        patch.nodes[i] = vertices[i];
        patch.nodes[3 + i] = (vertices[i] + vertices[(i + 1) % 3]) / 2;
      }
      patch.pairs = patch.nodes;
      patches.push_back(patch);
    }
  return patches;
}

} // namespace

TEST(PressingTraction, IsTheIdentityOnTractionsThatPress)
{
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial)
    for (const Chain& chain : test::sampleChains(random)) {
      const Vector t = touchingNodes(chain, random);
      const Vector change = difference(project(chain, t, {}, TractionSign::Values), t);
      EXPECT_LT(std::sqrt(test::innerProduct(chain, change, change)), 1e-13);
    }
}

TEST(PressingTraction, PressesAtTheNodes)
{
  std::mt19937 random(2);
  int inside = 0;
  for (int trial = 0; trial < 100; ++trial)
    for (const Chain& chain : test::sampleChains(random)) {
      const Vector t = project(chain, test::randomNodes(chain.numNodes(), random), {}, TractionSign::Values);
      EXPECT_LT(largestValue(t), 1e-13);
      inside += largestCoefficient(chain, t) > 1e-3;
    }
  EXPECT_GT(inside, 100) << "coefficients above zero are allowed, and often nearest";
}

TEST(PressingTraction, NothingThatPressesIsNearer)
{
  // t is the nearest of a convex set exactly if (mean - t, s - t) <= 0 for every s of the set
  std::mt19937 random(3);
  for (const Chain& chain : test::sampleChains(random))
    for (const bool floating : {false, true}) {
      const Vector load = touchingNodes(chain, random);
      const BalanceConditions balance = floating ? balanceOf(chain, load) : BalanceConditions{};
      const Vector mean = test::randomNodes(chain.numNodes(), random);
      const Vector t = project(chain, mean, balance, TractionSign::Values);
      EXPECT_LT(largestValue(t), 1e-13);
      EXPECT_LT(test::innerProduct(chain, difference(mean, t), difference(load, t)), 1e-11);
      for (int other = 0; other < 20; ++other) {
        const auto sign = TractionSign::Values;
        const Vector s = project(chain, test::randomNodes(chain.numNodes(), random), balanceOf(chain, load), sign);
        EXPECT_LT(test::innerProduct(chain, difference(mean, t), difference(s, t)), 1e-11);
      }
    }
}

TEST(PressingTraction, IsNotFartherThanTheOneWithCoefficients)
{
  std::mt19937 random(4);
  int nearer = 0;
  for (const Chain& chain : test::sampleChains(random)) {
    const Vector mean = test::randomNodes(chain.numNodes(), random);
    const Vector all = difference(project(chain, mean, {}, TractionSign::Values), mean);
    const Vector some = difference(project(chain, mean, {}, TractionSign::Coefficients), mean);
    const double distance = test::innerProduct(chain, all, all), farther = test::innerProduct(chain, some, some);
    EXPECT_LT(distance, farther * (1.0 + 1e-12));
    nearer += distance < 0.999 * farther;
  }
  EXPECT_GT(nearer, 0);
}

TEST(PressingTraction, ResultantAndMomentAreKept)
{
  std::mt19937 random(5);
  for (const int order : {1, 2}) {
    const Chain chain = test::straightChain(test::randomLengths(30, random), order);
    const Vector load = touchingNodes(chain, random), one(load.size(), 1.0);
    const Vector t =
        project(chain, test::randomNodes(chain.numNodes(), random), balanceOf(chain, load), TractionSign::Values);
    EXPECT_NEAR(test::innerProduct(chain, t, one) / test::innerProduct(chain, load, one), 1.0, 1e-12);
    EXPECT_NEAR(test::innerProduct(chain, t, chain.x) / test::innerProduct(chain, load, chain.x), 1.0, 1e-12);
    EXPECT_LT(largestValue(t), 1e-13);
  }
}

TEST(PressingTraction, LargeInterfacesAreSolved)
{
  std::mt19937 random(6);
  const Chain chain = test::straightChain(test::randomLengths(20000, random), 2);
  const Vector mean = test::randomNodes(chain.numNodes(), random);
  const Vector t = project(chain, mean, {}, TractionSign::Values);
  EXPECT_LT(largestValue(t), 1e-13);
  EXPECT_LT(std::abs(test::innerProduct(chain, difference(mean, t), t)), 1e-11 * test::innerProduct(chain, t, t));
}

/// Where tractions vanish over a region, signs there are those of what decays into it: exchanged one by one they would
/// take thousands of factors.
TEST(PressingTraction, ThatVanishesOverARegionIsFoundSoon)
{
  constexpr int n = 20, row = 2 * n + 1;
  const auto patches = squarePatches(n);
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-0.01, 0.01);
    Vector mean(std::size_t(row) * row, 0.0), twice;
    for (std::size_t node = 0; node < mean.size(); ++node) {
      const double x = double(node % row) / (row - 1), y = double(node / row) / (row - 1),
                   pressure = 1.0 - 4.0 * (x * x + y * y);
      if (pressure > 0.0)
        mean[node] = noise(random) - pressure;
      twice.push_back(2.0 * mean[node]);
    }
    const auto nearest = [&](const Vector& t) { return projectTraction(patches, row * row, 2, t, {}); };
    const Vector found = nearest(mean), ofTwice = nearest(twice), again = nearest(found);
    EXPECT_LE(largestBernstein(tractionFromNodes(patches, found, 2, 2), patches), 1e-13) << seed;
    for (std::size_t node = 0; node < mean.size(); ++node) { // tractions are a cone
      EXPECT_NEAR(ofTwice[node], 2.0 * found[node], 1e-11) << seed;
      EXPECT_NEAR(again[node], found[node], 1e-11) << seed;
    }
  }
}

} // namespace ndframe
