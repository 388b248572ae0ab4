// What rigid motions say about a network of bodies before the solve: closed forms, units and order, brute force.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gmock/gmock.h>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/coupling/rigid_network.hpp"

using namespace ndframe;
using testing::DoubleNear;
using testing::IsEmpty;
using testing::Pointwise;

namespace
{

struct RigidVerdict
{
  Vector pulledOff, loose;
};

RigidVerdict judge(const RigidNetwork& network)
{
  return {pulledOff(network), loose(network)};
}

struct Point
{
  double x, y;
};

constexpr int ground = -1;

/// Plane bodies with motions x, y and a rotation about a point of their own.
class Bodies
{
public:
  explicit Bodies(std::vector<Point> centres) : centres_(std::move(centres))
  {
    const std::size_t motions = 3 * centres_.size();
    network.work.assign(motions, 0.0);
    network.magnitude.assign(motions, 0.0);
    network.reluctance.assign(motions, 1.0);
    for (std::size_t b = 0; b < centres_.size(); ++b)
      network.reluctance[3 * b + 2] = 10.0;
  }

  /// `body` touches another one (or the ground) from a to b; normal: out of `body`.
  void touch(int body, int other, Point a, Point b, Point normal)
  {
    for (const Point& at : {a, b}) {
      SparseRow row;
      append(row, body, at, normal, 1.0);
      append(row, other, at, normal, -1.0);
      network.approach.push_back(row);
    }
  }

  /// Held against x: contact on both sides.
  void guide(int body)
  {
    const Point c = centres_[std::size_t(body)];
    touch(body, ground, c, c, {1.0, 0.0});
    touch(body, ground, c, c, {-1.0, 0.0});
  }

  void load(int body, Point at, Point force)
  {
    const Vector parts = motionsAlong(body, at, force);
    for (std::size_t m = 0; m < 3; ++m) {
      const std::size_t motion = 3 * std::size_t(body) + m;
      network.work[motion] += parts[m];
      network.magnitude[motion] += std::hypot(force.x, force.y);
    }
  }

  RigidNetwork network;

private:
  Vector motionsAlong(int body, Point at, Point n) const
  {
    const Point c = centres_[std::size_t(body)];
    return {n.x, n.y, (at.x - c.x) * n.y - (at.y - c.y) * n.x};
  }

  void append(SparseRow& row, int body, Point at, Point normal, double sign)
  {
    if (body == ground)
      return;
    const Vector parts = motionsAlong(body, at, normal);
    for (int m = 0; m < 3; ++m)
      if (parts[std::size_t(m)] != 0.0)
        row.emplace_back(3 * body + m, sign * parts[std::size_t(m)]);
  }

  std::vector<Point> centres_;
};

/// Unit boxes on each other on the ground, which guides keep from sliding; the stack's axis is x = 0.
Bodies stack(int boxes)
{
  std::vector<Point> centres;
  for (int b = 0; b < boxes; ++b)
    centres.push_back({0.0, b + 0.5});
  Bodies bodies(centres);
  for (int b = 0; b < boxes; ++b) {
    bodies.touch(b, b - 1, {-0.5, double(b)}, {0.5, double(b)}, {0.0, -1.0});
    bodies.guide(b);
  }
  return bodies;
}

/// Four boxes round a unit core that is held, each along a side of the core and the end of the next box: box 0 below,
/// then counterclockwise. Pressed from outside, and onto the box before by `end` on the free end.
Bodies ring(const std::vector<double>& pressures, double end)
{
  const Point outward[] = {{0.0, -1.0}, {1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}};
  std::vector<Point> centres;
  for (const Point& n : outward) // two long, one thick
    centres.push_back({1.0 * n.x - 0.5 * n.y, 1.0 * n.y + 0.5 * n.x});
  Bodies bodies(centres);
  for (int b = 0; b < 4; ++b) {
    const Point n = outward[b], t{-n.y, n.x};
    const auto at = [&](double out, double along) { return Point{out * n.x + along * t.x, out * n.y + along * t.y}; };
    bodies.touch(b, ground, at(0.5, -0.5), at(0.5, 0.5), {-n.x, -n.y});
    bodies.touch(b, (b + 1) % 4, at(0.5, 0.5), at(0.5, 1.5), {-n.x, -n.y});
    bodies.load(b, at(1.5, 0.5), {-pressures[std::size_t(b)] * n.x, -pressures[std::size_t(b)] * n.y});
    bodies.load(b, at(1.0, 1.5), {-end * t.x, -end * t.y});
  }
  return bodies;
}

/// Bricks of 2 x 1 in running bond between walls, pressed on top from the left up to x = loaded. Row by row.
Bodies wall(int rows, int columns, double loaded)
{
  std::vector<Point> centres;
  std::vector<std::vector<double>> cuts;
  for (int r = 0; r < rows; ++r) {
    cuts.push_back({0.0});
    for (int x = r % 2 == 0 ? 2 : 1; x < 2 * columns; x += 2)
      cuts.back().push_back(x);
    cuts.back().push_back(2.0 * columns);
    for (std::size_t k = 0; k + 1 < cuts.back().size(); ++k)
      centres.push_back({(cuts.back()[k] + cuts.back()[k + 1]) / 2.0, r + 0.5});
  }
  Bodies bodies(centres);
  int brick = 0, below = 0;
  for (int r = 0; r < rows; ++r) {
    const std::vector<double>& cut = cuts[std::size_t(r)];
    const int bricks = int(cut.size()) - 1, firstBelow = below;
    for (int k = 0; k < bricks; ++k, ++brick) {
      const double start = cut[std::size_t(k)], end = cut[std::size_t(k) + 1];
      bodies.touch(brick, k > 0 ? brick - 1 : ground, {start, double(r)}, {start, r + 1.0}, {-1.0, 0.0});
      if (k == bricks - 1)
        bodies.touch(brick, ground, {end, double(r)}, {end, r + 1.0}, {1.0, 0.0});
      if (r == 0)
        bodies.touch(brick, ground, {start, 0.0}, {end, 0.0}, {0.0, -1.0});
      for (std::size_t b = 0; r > 0 && b + 1 < cuts[std::size_t(r) - 1].size(); ++b) {
        const double from = std::max(start, cuts[std::size_t(r) - 1][b]),
                     to = std::min(end, cuts[std::size_t(r) - 1][b + 1]);
        if (from < to)
          bodies.touch(brick, firstBelow + int(b), {from, double(r)}, {to, double(r)}, {0.0, -1.0});
      }
      if (r == rows - 1 && start < loaded)
        bodies.load(brick, {(start + std::min(end, loaded)) / 2.0, r + 1.0}, {0.0, start - std::min(end, loaded)});
    }
    below = brick - bricks;
  }
  return bodies;
}

std::vector<int> moving(const Vector& motion)
{
  std::vector<int> bodies;
  for (std::size_t b = 0; 3 * b < motion.size(); ++b)
    if (largestEntry(Vector(motion.begin() + 3 * std::ptrdiff_t(b), motion.begin() + 3 * std::ptrdiff_t(b) + 3)) > 1e-6)
      bodies.push_back(int(b));
  return bodies;
}

auto isMotion(const Vector& motion)
{
  return Pointwise(DoubleNear(1e-8), motion);
}

double parting(const SparseRow& row, const Vector& a)
{
  return -std::accumulate(row.begin(), row.end(), 0.0, [&](double sum, const auto& entry) {
    return sum + entry.second * a[std::size_t(entry.first)];
  });
}

/// Rows that some direction of the cone B R a <= 0 without work opens, and whether one has work: over all extreme
/// directions, each of which leaves size - 1 independent rows at zero.
struct Enumerated
{
  bool pulled = false;
  std::vector<char> opens;
};

void tryDirection(const RigidNetwork& network, Vector a, Enumerated& result)
{
  std::vector<char> opens;
  for (const auto& row : network.approach) {
    if (parting(row, a) < -1e-9)
      return;
    opens.push_back(parting(row, a) > 1e-9);
  }
  const double work = dot(network.work, a);
  result.pulled = result.pulled || work > 1e-9;
  for (std::size_t i = 0; std::abs(work) <= 1e-9 && i < opens.size(); ++i)
    result.opens[i] = char(result.opens[i] || opens[i]);
}

Enumerated enumerate(const RigidNetwork& network)
{
  const int n = network.size(), rows = int(network.approach.size());
  Enumerated result{false, std::vector<char>(std::size_t(rows), 0)};
  for (int set = 0; set < 1 << rows; ++set) {
    std::vector<int> tight;
    for (int i = 0; i < rows; ++i)
      if ((set >> i & 1) != 0)
        tight.push_back(i);
    if (int(tight.size()) != n - 1)
      continue;
    DenseMatrix A(n - 1, n);
    for (int i = 0; i < n - 1; ++i)
      for (const auto& [j, value] : network.approach[std::size_t(tight[std::size_t(i)])])
        A(i, j) = value;
    const DenseMatrix line = nullSpace(A, 1e-9);
    if (line.cols() != 1)
      continue;
    Vector a = line.column(0);
    tryDirection(network, a, result);
    for (double& value : a)
      value = -value;
    tryDirection(network, a, result);
  }
  return result;
}

/// Small whole numbers, so that directions without work are common.
RigidNetwork randomNetwork(std::mt19937& random, int motions, int rows)
{
  std::uniform_int_distribution<int> entry(-2, 2);
  RigidNetwork network;
  for (int i = 0; i < rows; ++i) {
    SparseRow row;
    for (int j = 0; j < motions; ++j)
      if (const int value = entry(random); value != 0)
        row.emplace_back(j, 0.5 * value);
    network.approach.push_back(row);
  }
  for (int j = 0; j < motions; ++j) {
    network.work.push_back(entry(random));
    network.magnitude.push_back(std::max(1.0, std::abs(network.work.back())));
    network.reluctance.push_back(1.0);
  }
  return network;
}

bool hasFullRank(const RigidNetwork& network)
{
  DenseMatrix A(int(network.approach.size()), network.size());
  for (int i = 0; i < A.rows(); ++i)
    for (const auto& [j, value] : network.approach[std::size_t(i)])
      A(i, j) = value;
  return nullSpace(A, 1e-9).cols() == 0;
}

} // namespace

TEST(RigidNetwork, APressedBoxIsHeld)
{
  Bodies box = stack(1);
  box.load(0, {0.2, 1.0}, {0.3, -1.0});
  const RigidVerdict verdict = judge(box.network);
  EXPECT_THAT(verdict.pulledOff, IsEmpty());
  EXPECT_THAT(verdict.loose, IsEmpty());
}

TEST(RigidNetwork, ALiftedBoxIsPulledOff)
{
  Bodies box = stack(1);
  box.load(0, {0.0, 1.0}, {0.0, 1e-5});
  EXPECT_THAT(judge(box.network).pulledOff, isMotion({0.0, 1.0, 0.0}));
}

TEST(RigidNetwork, ABoxPressedBesideItsBaseTopples)
{
  Bodies box({{0.0, 0.5}});
  box.touch(0, ground, {-0.5, 0.0}, {0.5, 0.0}, {0.0, -1.0});
  box.touch(0, ground, {0.5, 0.0}, {0.5, 0.0}, {1.0, 0.0}); // a kerb at its lower corner,
  box.touch(0, ground, {-0.5, 0.0}, {-0.5, 0.0}, {-1.0, 0.0});
  box.load(0, {0.6, 1.0}, {0.0, -1.0});
  EXPECT_THAT(judge(box.network).pulledOff, isMotion({0.5, 0.5, -1.0})) << "about (0.5, 0)";
}

TEST(RigidNetwork, ABoxPushedAwayFromItsOnlyWallIsPulledOff)
{
  Bodies box({{0.0, 0.5}});
  box.touch(0, ground, {-0.5, 0.0}, {0.5, 0.0}, {0.0, -1.0});
  box.touch(0, ground, {-0.5, 0.0}, {-0.5, 1.0}, {-1.0, 0.0});
  box.load(0, {0.0, 1.0}, {0.0, -1.0});
  EXPECT_THAT(judge(box.network).loose, isMotion({1.0, 0.0, 0.0})) << "not pushed, it may stand anywhere";
  box.load(0, {-0.5, 0.5}, {0.1, 0.0});
  EXPECT_THAT(judge(box.network).pulledOff, isMotion({1.0, 0.0, 0.0}));
}

TEST(RigidNetwork, AStackPulledInTheMiddleTakesAlongWhatStandsOnIt)
{
  Bodies boxes = stack(3);
  boxes.load(1, {0.0, 1.5}, {0.0, 1.0});
  boxes.load(2, {0.0, 3.0}, {0.0, -0.1});
  EXPECT_THAT(judge(boxes.network).pulledOff, isMotion({0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0}));
  boxes.load(2, {0.0, 3.0}, {0.0, -1.0});
  const RigidVerdict held = judge(boxes.network);
  EXPECT_THAT(held.pulledOff, IsEmpty());
  EXPECT_THAT(moving(held.loose), IsEmpty()) << "the pull ends in the middle, the lowest box cannot move";
}

TEST(RigidNetwork, UnloadedBricksAreLoose)
{
  Bodies boxes = stack(4);
  boxes.load(1, {0.0, 2.0}, {0.0, -1.0});
  const RigidVerdict verdict = judge(boxes.network);
  EXPECT_THAT(verdict.pulledOff, IsEmpty());
  EXPECT_THAT(moving(verdict.loose), testing::ElementsAre(2, 3));
  EXPECT_EQ(verdict.loose[7], verdict.loose[10] / 2.0) << "the upper one parts from the lower one";
}

TEST(RigidNetwork, ARingHoldsWhileItsBoxesArePressed)
{
  const RigidVerdict pressed = judge(ring({1.0, 1.0, 1.0, 1.0}, 0.2).network);
  EXPECT_THAT(pressed.pulledOff, IsEmpty());
  EXPECT_THAT(pressed.loose, IsEmpty());
  EXPECT_THAT(moving(judge(ring({1.0, 1.0, 1.0, 1.0}, 0.0).network).loose), testing::ElementsAre(0, 1, 2, 3))
      << "without pressure on the free ends all can slide on";
  EXPECT_THAT(moving(judge(ring({1.0, 1.0, 1.0, -1.0}, 0.2).network).pulledOff), testing::Contains(3));
}

TEST(RigidNetwork, AWallIsLooseWhereNothingPressesIt)
{
  const RigidVerdict full = judge(wall(8, 8, 16.0).network);
  EXPECT_THAT(full.pulledOff, IsEmpty());
  EXPECT_THAT(full.loose, IsEmpty());
  // Row 4: half a brick, three bricks, half a brick.
  const RigidVerdict half = judge(wall(4, 4, 4.0).network);
  EXPECT_THAT(half.pulledOff, IsEmpty());
  EXPECT_THAT(moving(half.loose), testing::IsSupersetOf({16, 17}));
  EXPECT_THAT(moving(half.loose), testing::Each(testing::Gt(4)))
      << "the lower bricks do not move before the upper ones";
  for (const int brick : moving(half.loose))
    EXPECT_GT(half.loose[3 * std::size_t(brick) + 1], 0.0);
  EXPECT_THAT(judge(wall(12, 12, 7.0).network).pulledOff, IsEmpty());
  Bodies pulled = wall(12, 12, 24.0);
  pulled.load(40, {8.0, 4.0}, {0.0, 24.1});
  EXPECT_THAT(moving(judge(pulled.network).pulledOff), testing::Contains(40));
}

TEST(RigidNetwork, UnitsDoNotMatter)
{
  for (const double unit : {1e-12, 1e15}) {
    for (const double pull : {1.0, -1.0}) {
      Bodies boxes = stack(3);
      boxes.load(1, {0.0, 1.5}, {0.0, pull * unit});
      const RigidVerdict verdict = judge(boxes.network);
      EXPECT_EQ(verdict.pulledOff.empty(), pull < 0.0) << unit;
      EXPECT_EQ(moving(verdict.loose), pull < 0.0 ? std::vector<int>{2} : std::vector<int>{}) << unit;
    }
  }
}

TEST(RigidNetwork, RoundOffOfALoadIsNoWork)
{
  Bodies boxes = stack(2);
  boxes.load(0, {0.0, 1.0}, {0.0, -1.0});
  boxes.load(1, {0.5, 1.5}, {-1.0, 1e-16}); // a turned load along x
  EXPECT_THAT(judge(boxes.network).pulledOff, IsEmpty());
}

TEST(RigidNetwork, TellsWhatEnumerationTells)
{
  std::mt19937 random(7);
  int pulled = 0, loose = 0, held = 0;
  for (int scene = 0; scene < 400; ++scene) {
    const RigidNetwork network = randomNetwork(random, 2 + scene % 4, 4 + scene % 6);
    if (!hasFullRank(network))
      continue;
    const Enumerated known = enumerate(network);
    const RigidVerdict verdict = judge(network);
    EXPECT_EQ(!verdict.pulledOff.empty(), known.pulled) << scene;
    if (known.pulled) {
      ++pulled;
      EXPECT_GT(dot(network.work, verdict.pulledOff), 0.0) << scene;
      continue;
    }
    const bool opens = std::count(known.opens.begin(), known.opens.end(), 1) > 0;
    EXPECT_EQ(!verdict.loose.empty(), opens) << scene;
    (opens ? loose : held) += 1;
    for (std::size_t i = 0; opens && i < known.opens.size(); ++i)
      EXPECT_EQ(parting(network.approach[i], verdict.loose) > 1e-7, known.opens[i] != 0) << scene << " row " << i;
  }
  EXPECT_GT(std::min({pulled, loose, held}), 20) << "the scenes must be of all kinds";
}

/// Forces r >= 0 with R^T B^T r = w prove that nothing is pulled off; r > 0 that nothing is loose either.
TEST(RigidNetwork, ForcesInBalanceProveThatNothingIsPulledOff)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> force(0.0, 1.0);
  for (int scene = 0; scene < 60; ++scene) {
    RigidNetwork network = stack(2 + scene % 30).network;
    std::fill(network.magnitude.begin(), network.magnitude.end(), 1.0);
    const bool everywhere = scene % 2 == 0;
    for (const auto& row : network.approach) {
      const double r = everywhere || force(random) < 0.7 ? 1e-3 + force(random) : 0.0;
      for (const auto& [motion, value] : row)
        network.work[std::size_t(motion)] += r * value;
    }
    const RigidVerdict verdict = judge(network);
    EXPECT_THAT(verdict.pulledOff, IsEmpty()) << scene;
    EXPECT_TRUE(!everywhere || verdict.loose.empty()) << scene;
  }
}
