#include "stress_fields.hpp"

#include <iterator>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/assembly/nodal_stress.hpp"

namespace ndframe
{
namespace
{

constexpr std::array componentNames{"xx", "yy", "zz", "xy", "yz", "zx"};

std::vector<NamedField> stressFields(const std::vector<std::array<double, 6>>& stress)
{
  auto fields = tensorFields("stress_", stress);
  fields.push_back({"von_mises", {}});
  for (const auto& value : stress)
    fields.back().values.push_back(vonMises(value));
  return fields;
}

} // namespace

void append(std::vector<NamedField>& fields, std::vector<NamedField> more)
{
  fields.insert(fields.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<NamedField> tensorFields(const std::string& prefix, const std::vector<std::array<double, 6>>& values)
{
  std::vector<NamedField> fields;
  for (std::size_t c = 0; c < componentNames.size(); ++c) {
    fields.push_back({prefix + componentNames[c], Vector(values.size())});
    for (std::size_t i = 0; i < values.size(); ++i)
      fields.back().values[i] = values[i][c];
  }
  return fields;
}

std::vector<NamedField> cellStressFields(const BodyModel& body, const Vector& displacement)
{
  return stressFields(cellStress(body, displacement));
}

std::vector<NamedField> nodalStressFields(const BodyModel& body, const Vector& displacement)
{
  return stressFields(nodalStress(body, displacement));
}

std::array<double, 3> outOfPlaneOfStress(const Elasticity& law)
{
  DenseMatrix D(3, 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      D(i, j) = law(i, j);
  const Vector solved = DenseCholesky(D).solve({law.outOfPlane.begin(), law.outOfPlane.end()});
  return {solved[0], solved[1], solved[2]};
}

} // namespace ndframe
