#include "driver/certificate_numbers.hpp"

#include <map>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace ndframe::test
{
namespace
{

struct Mesh2
{
  const char *first, *firstCells, *second, *secondCells;
};

const std::map<std::string, Mesh2>& smallMeshes()
{
  static const std::map<std::string, Mesh2> all{{"punch", {"punch", "{4, 4}", "foundation", "{8, 4}"}},
                                                {"contact-loss", {"upper", "{10, 8}", "lower", "{20, 6}"}},
                                                {"patch", {"upper", "{2, 2}", "lower", "{2, 3}"}}};
  return all;
}

} // namespace

std::vector<NamedNumber> energyNorms(const ErrorSummary& errors)
{
  std::vector<NamedNumber> all;
  const auto addMeasure = [&](const std::string& name, const std::optional<ErrorMeasureSummary>& measure) {
    if (measure)
      all.insert(all.end(), {{name + "/absolute", measure->absolute},
                             {name + "/elements", measure->elements},
                             {name + "/contact", measure->contact},
                             {name + "/projection", measure->projection},
                             {name + "/oscillation", measure->oscillation}});
  };
  const auto add = [&](const std::string& name, const std::optional<double>& number) {
    if (number)
      all.push_back({name, *number});
  };
  addMeasure("global", errors.global);
  addMeasure("algorithm", errors.algorithm);
  addMeasure("discretization", errors.discretization);
  add("split_stress", errors.splitStress);
  add("mean_stress", errors.meanStress);
  add("zienkiewicz_zhu", errors.zienkiewiczZhu);
  add("residual", errors.residual);
  return all;
}

const ErrorSummary& errorsOf(const Outcome& outcome)
{
  return outcome.run.summary.errors.value();
}

void expectSameErrors(const ErrorSummary& found, const ErrorSummary& expected, double tolerance, double factor)
{
  const auto a = energyNorms(found), b = energyNorms(expected);
  ASSERT_EQ(a.size(), b.size());
  const double scale = expected.global->absolute * factor;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a[i].value / scale, y = b[i].value * factor / scale;
    EXPECT_NEAR(x * x, y * y, tolerance * std::max(1.0, y * y)) << a[i].name;
  }
  EXPECT_NEAR(found.global->relative, expected.global->relative, tolerance * expected.global->relative);
  EXPECT_EQ(found.guaranteed, expected.guaranteed) << found.reason << expected.reason;
  EXPECT_EQ(found.advice, expected.advice);
}

Scene smallScene(const std::string& deck)
{
  const Mesh2& mesh = smallMeshes().at(deck);
  Scene scene(deck);
  scene.set(fmt::format("Bodies/{}/Mesh/Cells={}", mesh.first, mesh.firstCells));
  scene.set(fmt::format("Bodies/{}/Mesh/Cells={}", mesh.second, mesh.secondCells));
  return scene.set(allEstimators);
}

} // namespace ndframe::test
