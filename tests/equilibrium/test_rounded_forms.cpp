#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "ndframe/equilibrium/cell_forms.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t lanes = CellForms::lanes, terms = 21;

/// Positive compliances, per entry and lane; of lane l times 10^(powers l).
Vector compliances(double powers, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> any;
  Vector C(terms * lanes);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    double root[6][6];
    for (auto& row : root)
      for (double& entry : row)
        entry = 0.3 * any(random);
    std::size_t place = 0;
    for (int i = 0; i < 6; ++i)
      for (int j = i; j < 6; ++j) {
        double sum = i == j ? 1.0 : 0.0;
        for (int k = 0; k < 6; ++k)
          sum += root[i][k] * root[j][k];
        C[place++ * lanes + lane] = sum * std::pow(10.0, powers * double(lane));
      }
  }
  return C;
}

void applyRounded(const CellForms& forms, const Vector& C, const Vector& factor, const Vector& T, Vector& forces)
{
  std::vector<float> numbers(forms.roundedSize()), x(T.begin(), T.end()), result(T.size());
  double scales[lanes];
  forms.round(C.data(), factor.data(), numbers.data(), scales);
  forms.applyRounded(numbers.data(), x.data(), result.data());
  for (std::size_t i = 0; i < result.size(); ++i)
    forces[i] = double(result[i]) / scales[i % lanes];
}

/// The largest |rounded - exact| / |exact| of a lane's forces.
double largestDifference(int degree, double powersOfCompliance)
{
  const CellForms& forms = solidForms(degree);
  const auto tractions = std::size_t(referenceStress(3, degree).tractions);
  const Vector C = compliances(powersOfCompliance, unsigned(degree));
  Vector work, T(tractions * lanes), exact(T.size()), rounded(T.size());
  std::mt19937 random(11);
  std::normal_distribution<double> any;
  for (std::size_t i = 0; i < tractions; ++i)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      T[i * lanes + lane] = any(random);
  const CellForms::Condensed condensed = forms.condensed(C.data(), work);
  const Vector factor(condensed.factor, condensed.factor + forms.factorSize() * lanes);
  forms.apply(C.data(), factor.data(), T.data(), tractions, exact.data());
  applyRounded(forms, C, factor, T, rounded);
  double largest = 0.0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    double difference = 0.0, size = 0.0;
    for (std::size_t i = 0; i < tractions; ++i) {
      difference = std::hypot(difference, rounded[i * lanes + lane] - exact[i * lanes + lane]);
      size = std::hypot(size, exact[i * lanes + lane]);
    }
    largest = std::max(largest, difference / size);
  }
  return largest;
}

} // namespace

TEST(RoundedForces, HaveSixDigits)
{
  for (const int degree : {1, 2})
    EXPECT_LT(largestDifference(degree, 0.0), 3e-6) << degree;
}

TEST(RoundedForces, DoNotDependOnUnits)
{
  // Compliances that single precision does not have, 1e-140 to 1 and 1 to 1e140; tractions come scaled.
  for (const double compliance : {-20.0, 20.0})
    for (const int degree : {1, 2})
      EXPECT_LT(largestDifference(degree, compliance), 3e-6) << degree << ", " << compliance;
}

TEST(RoundedForces, OfNoTractionsAreNone)
{
  const CellForms& forms = solidForms(2);
  const Vector C = compliances(0.0, 1), T(std::size_t(referenceStress(3, 2).tractions) * lanes, 0.0);
  Vector work, forces(T.size(), 1.0);
  const CellForms::Condensed condensed = forms.condensed(C.data(), work);
  const Vector factor(condensed.factor, condensed.factor + forms.factorSize() * lanes);
  applyRounded(forms, C, factor, T, forces);
  EXPECT_EQ(forces, T);
}

} // namespace ndframe
