#include "estimation/smooth_scene.hpp"

#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "ndframe/assembly/fields.hpp"

namespace ndframe::test
{
namespace
{

constexpr double a = 1.0, c = 0.5; // the components of u
constexpr double mu = 2.0 / 2.6, lambda = 2.0 * 0.3 / (1.3 * 0.4);

std::string force(double own, double other)
{
  const double sines = M_PI * M_PI * (lambda + 3.0 * mu) * own, cosines = -M_PI * M_PI * (lambda + mu) * other;
  return fmt::format("{0} * sin({2} * x) * sin({2} * y) + {1} * cos({2} * x) * cos({2} * y)", sines, cosines, M_PI);
}

} // namespace

BodyModel smoothBody(int n, int order, const std::string& pattern)
{
  Conditions conditions;
  for (const char* side : {"left", "right", "bottom", "top"})
    conditions.supports.push_back(onSide("Clamp", side));
  conditions.loads.push_back({"Body Force", {{"X", force(a, c)}, {"Y", force(c, a)}}});
  return makeBody(box({n, n}, pattern), order, conditions);
}

Vector solution(const BodyModel& body)
{
  return solve(assemble(body, Comm::single()), Comm::single());
}

double smoothErrorSquared(const BodyModel& body, const Vector& solved)
{
  const double exact = 0.25 * M_PI * M_PI * (lambda + 3.0 * mu) * (a * a + c * c);
  return exact - energy(body, solved);
}

double sum(const Vector& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

} // namespace ndframe::test
