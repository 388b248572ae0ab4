#include "sample_laws.hpp"

#include <fmt/format.h>

#include "ndframe/base/deck.hpp"

namespace ndframe::test
{

std::unique_ptr<MaterialLaw> material(const std::string& type, const Entries& entries, const std::string& hypothesis)
{
  const auto text = [](const std::string& name, const std::string& value) {
    return fmt::format("<Parameter name=\"{}\" type=\"string\" value=\"{}\"/>\n", name, value);
  };
  std::string xml = "<ParameterList name=\"deck\">" + text("Type", type) + text("Hypothesis", hypothesis);
  for (const auto& [key, value] : entries)
    xml += fmt::format("<Parameter name=\"{}\" type=\"double\" value=\"{:.17g}\"/>\n", key, value);
  Registry<MaterialLaw> registry("material");
  registerMaterials(registry);
  ListSpec spec;
  spec.choices = registry.choices();
  Diagnostics diagnostics;
  const Params params = validate(parseDeck(xml + "</ParameterList>", "material.xml"), spec, diagnostics);
  diagnostics.throwIfAny();
  return registry.build(params);
}

std::string complaint(const std::string& type, const Entries& entries)
{
  try {
    material(type, entries);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

Elasticity isotropic(double young, double poisson, const std::string& hypothesis)
{
  return material("Isotropic", {{"Young Modulus", young}, {"Poisson Ratio", poisson}}, hypothesis)->elasticity();
}

Entries woodEntries(double angle, double unit)
{
  return {{"Young Modulus 1", 10.0 * unit}, {"Young Modulus 2", 0.8 * unit},
          {"Young Modulus 3", 0.5 * unit},  {"Poisson Ratio 12", 0.4},
          {"Poisson Ratio 23", 0.45},       {"Poisson Ratio 13", 0.35},
          {"Shear Modulus 12", 0.7 * unit}, {"Shear Modulus 23", 0.1 * unit},
          {"Shear Modulus 13", 0.6 * unit}, {"Angle", angle}};
}

Entries with(Entries entries, const std::string& key, double value)
{
  for (auto& entry : entries)
    if (entry.first == key)
      entry.second = value;
  return entries;
}

SpatialStiffness wood(double angle)
{
  return material("Orthotropic", woodEntries(angle), "Three Dimensional")->elasticity().D;
}

std::vector<double> apply(const Elasticity& law, const std::vector<double>& strain)
{
  std::vector<double> stress(strain.size(), 0.0);
  for (int i = 0; i < law.strains(); ++i)
    for (int j = 0; j < law.strains(); ++j)
      stress[std::size_t(i)] += law(i, j) * strain[std::size_t(j)];
  return stress;
}

} // namespace ndframe::test
