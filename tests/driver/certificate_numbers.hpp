#pragma once

#include <string>
#include <vector>

#include "driver/scene.hpp"

namespace ndframe::test
{

/// A number of the certificate with its name.
struct NamedNumber
{
  std::string name;
  double value = 0.0;
};

/// Every absolute number (in the energy norm) that a certificate holds, in an order of its own.
std::vector<NamedNumber> energyNorms(const ErrorSummary& errors);

/// What a run says about its error.
const ErrorSummary& errorsOf(const Outcome& outcome);

/// All numbers are those of `expected` times `factor`, compared by their squares relative to the square of the bound:
/// parts that vanish are known to the square root of round-off only. Verdict and advice are the same.
void expectSameErrors(const ErrorSummary& found, const ErrorSummary& expected, double tolerance, double factor = 1.0);

/// All estimators but the reference, which is a scene of its own.
constexpr const char* allEstimators =
    "Error Estimation/Estimators={Global, Algorithm, Discretization, Split, Zienkiewicz-Zhu, Residual}";

/// The punch and the punch with contact loss on few triangles, with all estimators.
Scene smallScene(const std::string& deck);

} // namespace ndframe::test
