#include "ndframe/accuracy/bound_fall.hpp"

#include <cmath>

#include <gtest/gtest.h>

using namespace ndframe;

TEST(BoundFall, InThePlaneWhatIsPredictedIsExpected)
{
  BoundFall fall(2, 2);
  fall.learn(1.0, 0.25, 0.5);
  EXPECT_EQ(fall.expected(0.7, 0.3), 0.3);
  EXPECT_EQ(fall.predicted(0.7, 0.3), 0.3);
  EXPECT_EQ(fall.power(), 1.0);
}

TEST(BoundFall, InSpaceTheSameIsExpectedOfWhatIsPredictedForIt)
{
  for (const int degree : {1, 2}) {
    BoundFall fall(3, degree);
    for (const double found : {0.9, 0.5, 0.4}) {
      const double predicted = fall.predicted(2.0, 0.6);
      EXPECT_LE(predicted, 0.6);
      EXPECT_NEAR(fall.expected(2.0, predicted), 0.6, 1e-14);
      fall.learn(1.0, 0.25, found);
    }
  }
}

TEST(BoundFall, ComesToThePowerOfAllSteps)
{
  BoundFall fall(3, 2);
  for (int level = 0; level < 20; ++level)
    fall.learn(1.0, 0.3, std::pow(0.3, 0.62));
  EXPECT_NEAR(fall.power(), 0.62, 1e-5);
  EXPECT_NEAR(fall.expected(5.0, 1.0), 5.0 * std::pow(0.2, 0.62), 1e-4);
}

TEST(BoundFall, ComesNearerToThePredictionWithKnownEdges)
{
  BoundFall fall(3, 2);
  fall.learn(1.0, 0.3, std::pow(0.3, 0.5));
  fall.edgesBecameKnown();
  const double first = fall.power();
  EXPECT_GT(first, 0.5);
  fall.learn(1.0, 0.3, std::pow(0.3, first));
  EXPECT_NEAR(1.0 - fall.power(), 0.5 * (1.0 - first), 1e-12);
}

TEST(BoundFall, StaysBetweenNoiseAndThePrediction)
{
  BoundFall fall(3, 2);
  for (int level = 0; level < 20; ++level)
    fall.learn(1.0, 0.3, 1.1); // the bound rises
  EXPECT_GT(fall.power(), 0.3);
  for (int level = 0; level < 20; ++level)
    fall.learn(1.0, 0.3, 0.01);
  EXPECT_EQ(fall.power(), 1.0);
}

TEST(BoundFall, OnMeshesMadeAnewAFactorIsLeftOnceEdgesAreKnown)
{
  BoundFall fall(3, 2);
  fall.meshesAreMadeAnew();
  fall.learn(1.0, 0.3, std::pow(0.3, 0.5));
  EXPECT_NEAR(fall.expected(1.0, 0.25), 0.5, 1e-14); // a power until then
  fall.edgesBecameKnown();
  EXPECT_EQ(fall.power(), 1.0);
  for (const double found : {1.2, 1.1, 0.95}) {
    fall.learn(1.0, 0.5, 0.5 * found);
    for (const double before : {1.0, 7.0}) { // however far it falls
      const double factor = fall.expected(before, 0.3) / 0.3;
      EXPECT_GE(factor, std::min(1.0, found)) << "as found, or nearer to 1";
      EXPECT_LE(factor, std::max(1.0, found));
      EXPECT_NEAR(fall.expected(before, fall.predicted(before, 0.6)), 0.6, 1e-14);
    }
  }
  fall.learn(1.0, 0.5, 5.0); // a spike
  EXPECT_LE(fall.expected(1.0, 0.3), 0.4);
  fall.learn(1.0, 0.5, 0.01);
  EXPECT_GE(fall.expected(1.0, 0.3), 0.25);
}
