#include "error_fields.hpp"

#include <limits>

#include "ndframe/assembly/fields.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "ndframe/recovery/cell_energy.hpp"

namespace ndframe
{
namespace
{

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The components that recovery knows, in its order, with their place in cellStress().
struct StressComponents
{
  std::vector<const char*> names;
  std::vector<std::size_t> place;
};

const StressComponents& componentsOf(int dim)
{
  static const StressComponents plane{{"xx", "yy", "xy"}, {0, 1, 3}};
  static const StressComponents spatial{{"xx", "yy", "zz", "xy", "yz", "xz"}, {0, 1, 2, 3, 4, 5}};
  return dim == 2 ? plane : spatial;
}

/// Mean over the cell of a stress that is a polynomial on each of the dim + 1 sub-cells, which are of equal size.
std::array<double, 6> meanOf(const SplitStress& stress, const QuadratureRule& rule)
{
  const int corners = stress.dim + 1;
  std::array<double, 6> mean{}, value{};
  for (int sub = 0; sub < corners; ++sub)
    for (int q = 0; q < rule.size(); ++q) {
      // The sub-cell's vertex number `sub` is the barycentre of the cell.
      const double* inSub = rule.point(q);
      std::array<double, 4> lambda{};
      for (int i = 0; i < corners; ++i)
        lambda[std::size_t(i)] = (i == sub ? 0.0 : inSub[i]) + inSub[sub] / corners;
      stress.stress(sub, lambda.data(), value.data());
      for (std::size_t i = 0; i < mean.size(); ++i)
        mean[i] += rule.weights[std::size_t(q)] / corners * value[i];
    }
  return mean;
}

/// Means of the equilibrated stress, per component and cell.
std::vector<Vector> equilibratedMeans(const Run& run, std::size_t body)
{
  const BodyModel& model = run.model.bodies[body];
  const Certificate& certificate = *run.certificate;
  const StressCorrection& correction = certificate.corrections[body];
  const auto rule = simplexRule(model.mesh.dim, correction.degree);
  std::vector<Vector> means(componentsOf(model.mesh.dim).names.size(), Vector(std::size_t(model.mesh.numCells())));
  for (int cell = 0; cell < model.mesh.numCells(); ++cell) {
    const auto mean = meanOf(equilibratedStress(model, certificate.intermediate[body], correction, cell), rule);
    for (std::size_t k = 0; k < means.size(); ++k)
      means[k][std::size_t(cell)] = mean[k];
  }
  return means;
}

/// Their means with the stress of the admissible displacement.
std::vector<Vector> centreMeans(const Run& run, std::size_t body, std::vector<Vector> means)
{
  const auto& place = componentsOf(run.model.bodies[body].mesh.dim).place;
  const auto computed = cellStress(run.model.bodies[body], run.certificate->admissible[body]);
  for (std::size_t k = 0; k < means.size(); ++k)
    for (std::size_t cell = 0; cell < computed.size(); ++cell)
      means[k][cell] = 0.5 * (means[k][cell] + computed[cell][place[k]]);
  return means;
}

void append(std::vector<NamedField>& fields, const std::string& prefix, const std::vector<Vector>& values, int dim)
{
  for (std::size_t k = 0; k < values.size(); ++k)
    fields.push_back({prefix + componentsOf(dim).names[k], values[k]});
}

} // namespace

std::vector<NamedField> elementErrorFields(const Run& run, const Params& output, std::size_t body, bool isFinal)
{
  if (!run.certificate)
    return {};
  const Certificate& certificate = *run.certificate;
  const Mesh& mesh = run.model.bodies[body].mesh;
  std::vector<NamedField> fields;
  const auto add = [&](const char* name, const std::vector<Vector>& eta) {
    if (!eta.empty())
      fields.push_back({name, eta[body]});
  };
  add("eta_glob", certificate.etaGlobal);
  add("eta_dis", certificate.etaDiscretization);
  add("eta_nda", certificate.etaAlgorithm);
  const bool writesEquilibrated = output.get<bool>("Equilibrated Stress"), writesMean = output.get<bool>("Mean Stress");
  if (writesEquilibrated || writesMean) {
    auto means = equilibratedMeans(run, body);
    if (writesEquilibrated)
      append(fields, "sigma_hat_", means, mesh.dim);
    if (writesMean)
      append(fields, "mean_stress_", centreMeans(run, body, std::move(means)), mesh.dim);
  }
  if (!isFinal)
    for (auto& field : fields)
      field.values.assign(std::size_t(mesh.numCells()), unknown);
  return fields;
}

std::vector<NamedField> admissiblePressure(const Run& run, std::size_t interface, bool isFinal)
{
  if (!run.certificate || run.certificate->traction.shares.empty())
    return {};
  int first = 0;
  for (std::size_t i = 0; i < interface; ++i)
    first += run.model.interfaces[i].numFacets();
  NamedField field{"admissible_pressure", {}};
  for (int f = first; f < first + run.model.interfaces[interface].numFacets(); ++f) {
    const double force = run.certificate->traction.moments(f).front();
    field.values.push_back(isFinal ? -force / run.certificate->facets[std::size_t(f)].measure : unknown);
  }
  return {field};
}

} // namespace ndframe
