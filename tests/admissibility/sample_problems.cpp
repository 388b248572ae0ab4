#include "sample_problems.hpp"

#include <map>
#include <numeric>

#include <fmt/format.h>

#include "common/test_main.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/simd/cell_distances.hpp"

namespace ndframe::test
{

namespace
{

Condition traction(const std::string& side, int dim, double size)
{
  Condition load = onSide("Traction", side);
  const std::vector<std::string> keys = {"X", "Y", "Z"};
  for (int i = 0; i < dim; ++i)
    load.entries.emplace_back(keys[std::size_t(i)], std::to_string(size * (1.0 - 0.7 * i)));
  return load;
}

Condition bodyForce(int dim)
{
  Condition load{"Body Force", {{"X", "0.4"}, {"Y", "-0.9"}}};
  if (dim == 3)
    load.entries.emplace_back("Z", "0.3");
  return load;
}

Condition pressure(const std::string& side, const std::string& value)
{
  Condition load = onSide("Pressure", side);
  load.entries.emplace_back("Value", value);
  return load;
}

Condition displacement(const std::string& side, std::vector<std::pair<std::string, std::string>> entries)
{
  Condition support = onSide("Displacement", side);
  support.entries.insert(support.entries.end(), entries.begin(), entries.end());
  return support;
}

} // namespace

Problem solved(BodyModel body, int degree)
{
  Problem problem{std::move(body), {}, {}};
  problem.displacement = solve(assemble(problem.body, comm()), comm()).whole();
  problem.data = makeStaticData(problem.body, degree, {});
  return problem;
}

std::vector<Space> allSpaces()
{
  return {{2, 1, 1}, {2, 1, 2}, {2, 2, 2}, {2, 2, 3}, {3, 1, 1}, {3, 1, 2}, {3, 2, 2}};
}

std::string spaceName(const testing::TestParamInfo<Space>& test)
{
  return fmt::format("Dim{}Order{}Degree{}", test.param.dim, test.param.order, test.param.degree);
}

const std::vector<std::string>& conditionKinds()
{
  static const std::vector<std::string> kinds = {"clamped", "rollers", "prescribed", "corner", "pinched"};
  return kinds;
}

Conditions conditions(int dim, const std::string& kind)
{
  const Condition clamp = onSide("Clamp", "left");
  std::vector<Condition> rollers = {onSide("Roller", "left"), onSide("Roller", "bottom")};
  if (dim == 3)
    rollers.push_back(onSide("Roller", "front"));
  std::vector<Condition> stretched = {displacement("left", {{"X", "0"}, {"Y", "0.01*x"}}),
                                      displacement("right", {{"X", "0.02 + 0.01*y"}})};
  std::vector<Condition> pinched = {displacement("left", {{"X", "0"}}), displacement("top", {{"Y", "0.01*x"}}),
                                    displacement("bottom", {{"Y", "0"}})};
  if (dim == 3) {
    pinched.push_back(displacement("left", {{"Z", "0"}}));
    stretched.push_back(onSide("Roller", "bottom"));
  }
  const std::map<std::string, Conditions> all = {
      {"clamped", {{clamp}, {traction("right", dim, 0.5), pressure("top", "0.3"), bodyForce(dim)}}},
      {"rollers", {rollers, {pressure("right", "0.5"), traction("top", dim, 0.2)}}},
      {"prescribed", {stretched, {bodyForce(dim)}}},
      {"corner", {{clamp, onSide("Roller", "bottom")}, {traction("right", dim, 1.0), bodyForce(dim)}}},
      {"pinched", {pinched, {traction("right", dim, 1.0)}}}};
  return all.at(kind);
}

Mesh sampleMesh(int dim, double rotation, unsigned seed)
{
  const std::vector<int> cells = dim == 2 ? std::vector<int>{4, 3} : std::vector<int>{2, 2, 2};
  const std::vector<double> upper = dim == 2 ? std::vector<double>{1.5, 1.0} : std::vector<double>{1.5, 1.0, 0.8};
  return shaken(box(cells, "Right", rotation, upper), 0.05, seed);
}

double energyOf(const BodyModel& body, const StressCorrection& correction)
{
  const Vector cells = cellDistances(body, correction, nullptr);
  return std::accumulate(cells.begin(), cells.end(), 0.0);
}

} // namespace ndframe::test
