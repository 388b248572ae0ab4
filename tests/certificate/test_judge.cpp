#include <cmath>
#include <limits>

#include <gmock/gmock.h>

#include "certificate/sharpness.hpp"
#include "certificate/trial.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace
{

/// Every error a hair below its bound.
ErrorSummary trueCertificate()
{
  ErrorSummary errors;
  errors.global = ErrorMeasureSummary{5.2, 0.1, 3.0, 4.0, 0.1, 0.1};
  errors.meanStress = 3.3;
  errors.equilibrium = 1e-13;
  errors.reference = ReferenceSummary{3, 1000, "", 5.199, 0.1, 5.099, 3.299, 1.0, 1.0};
  return errors;
}

Sharpness sharpness(int scene, double bound)
{
  Sharpness one;
  one.scene = scene;
  one.variant = "any";
  one.bound = bound;
  one.error = one.reference = 1.0;
  return one;
}

Variant limited(double median, double worst)
{
  Variant variant;
  variant.name = "any";
  variant.median = median;
  variant.worst = worst;
  return variant;
}

} // namespace

TEST(Judge, ErrorsBelowTheirBoundsAreRight)
{
  EXPECT_THAT(judge(trueCertificate()), IsEmpty());
}

TEST(Judge, ADisplacementErrorAboveTheBoundIsAViolation)
{
  auto errors = trueCertificate();
  errors.reference->displacement = 5.2 * (1.0 + 1e-6);
  EXPECT_THAT(judge(errors), ElementsAre(HasSubstr("displacement: error")));
}

TEST(Judge, AStressErrorAboveTheBoundIsAViolation)
{
  auto errors = trueCertificate();
  errors.reference->stress = 5.2 * (1.0 + 1e-6);
  EXPECT_THAT(judge(errors), ElementsAre(HasSubstr("stress: error")));
}

TEST(Judge, AMeanStressErrorAboveItsBoundIsAViolation)
{
  auto errors = trueCertificate();
  errors.reference->meanStress = 3.3 * (1.0 + 1e-6);
  EXPECT_THAT(judge(errors), ElementsAre(HasSubstr("mean stress: error")));
}

TEST(Judge, AStressOutOfBalanceIsAViolation)
{
  auto errors = trueCertificate();
  errors.equilibrium = 1e-6;
  EXPECT_THAT(judge(errors), ElementsAre(HasSubstr("equilibrium")));
}

TEST(Judge, ANumberThatIsNoneIsAViolation)
{
  auto errors = trueCertificate();
  errors.global->absolute = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(judge(errors), ElementsAre(HasSubstr("displacement"), HasSubstr("stress")));
}

TEST(Judge, AReferenceThatIsNotEightTimesFinerIsRefused)
{
  auto errors = trueCertificate();
  errors.reference->refinements = 2;
  EXPECT_THAT(judge(errors), ElementsAre(HasSubstr("h/4")));
}

TEST(JudgeSharpness, LimitsThatHoldAreRight)
{
  EXPECT_THAT(judgeSharpness(limited(1.1, 1.3), {sharpness(0, 1.05), sharpness(1, 1.1), sharpness(2, 1.3)}), IsEmpty());
}

TEST(JudgeSharpness, MedianAndLargestHaveTheirOwnLimits)
{
  const std::vector<Sharpness> all{sharpness(0, 1.05), sharpness(1, 1.15), sharpness(2, 1.2)};
  EXPECT_THAT(judgeSharpness(limited(1.1, 1.3), all), ElementsAre(HasSubstr("median effectivity 1.150")));
  EXPECT_THAT(judgeSharpness(limited(1.2, 1.19), all), ElementsAre(HasSubstr("largest effectivity 1.200")));
}

TEST(JudgeSharpness, ABoundBelowTheErrorIsNoGoodSharpness)
{
  EXPECT_THAT(judgeSharpness(limited(1.1, 1.3), {sharpness(7, 0.99)}), ElementsAre(HasSubstr("scene 7")));
}

TEST(ExtrapolatedError, IsExactWhereSquaresConvergeGeometrically)
{
  const auto error = [](int k) { return std::sqrt(2.0 - std::pow(0.4, k)); };
  EXPECT_NEAR(extrapolatedError(error(1), error(2), error(3)), std::sqrt(2.0), 1e-14);
}

TEST(ExtrapolatedError, IsTheLastErrorWhereTheyDoNotConvergeGeometrically)
{
  EXPECT_EQ(extrapolatedError(1.0, 1.1, 1.3), 1.3);
  EXPECT_EQ(extrapolatedError(1.0, 1.1, 1.05), 1.05);
  EXPECT_EQ(extrapolatedError(1.0, 1.0, 1.0), 1.0);
}
