#include "error_fields.hpp"

#include <limits>

#include "ndframe/assembly/fields.hpp"
#include "ndframe/equilibrium/equilibrated_stress.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "stress_fields.hpp"

namespace ndframe
{
namespace
{

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

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

/// What recovery gives, (xx, yy, xy) in the plane, as a whole tensor.
std::array<double, 6> wholeTensor(const std::array<double, 6>& given, const std::array<double, 3>& outOfPlane)
{
  const double zz = outOfPlane[0] * given[0] + outOfPlane[1] * given[1] + outOfPlane[2] * given[2];
  return {given[0], given[1], zz, given[2], 0.0, 0.0};
}

/// Means of the equilibrated stress over the cells.
std::vector<std::array<double, 6>> equilibratedMeans(const Run& run, std::size_t body)
{
  const BodyModel& model = run.model.bodies[body];
  const Certificate& certificate = *run.certificate;
  const StressCorrection& correction = certificate.corrections[body];
  const auto rule = simplexRule(model.mesh.dim, correction.degree);
  const bool plane = model.mesh.dim == 2;
  std::vector<std::array<double, 3>> outOfPlane; // per law
  for (const Elasticity& law : model.laws.all())
    outOfPlane.push_back(plane ? outOfPlaneOfStress(law) : std::array<double, 3>{});
  std::vector<std::array<double, 6>> means;
  for (int cell = 0; cell < model.mesh.numCells(); ++cell) {
    const auto mean = meanOf(equilibratedStress(model, certificate.intermediate[body], correction, cell), rule);
    means.push_back(plane ? wholeTensor(mean, outOfPlane[std::size_t(model.laws.number(cell))]) : mean);
  }
  return means;
}

/// Their means with the stress of the admissible displacement.
std::vector<std::array<double, 6>> centreMeans(const Run& run, std::size_t body,
                                               std::vector<std::array<double, 6>> means)
{
  const auto computed = cellStress(run.model.bodies[body], run.certificate->admissible[body]);
  for (std::size_t cell = 0; cell < computed.size(); ++cell)
    for (std::size_t k = 0; k < means[cell].size(); ++k)
      means[cell][k] = 0.5 * (means[cell][k] + computed[cell][k]);
  return means;
}

} // namespace

std::vector<NamedField> elementErrorFields(const Run& run, const OutputOptions& output, std::size_t body, bool isFinal)
{
  if (!run.certificate)
    return {};
  const Certificate& certificate = *run.certificate;
  const Mesh& mesh = run.model.bodies[body].mesh;
  std::vector<NamedField> fields;
  const auto add = [&](const char* name, const std::vector<CellValues>& eta) {
    if (!eta.empty())
      fields.push_back({name, eta[body]});
  };
  add("eta_glob", certificate.etaGlobal);
  add("eta_dis", certificate.etaDiscretization);
  add("eta_nda", certificate.etaAlgorithm);
  const bool writesEquilibrated = output.equilibratedStress, writesMean = output.meanStress;
  if (writesEquilibrated || writesMean) {
    auto means = equilibratedMeans(run, body);
    if (writesEquilibrated)
      append(fields, tensorFields("sigma_hat_", means));
    if (writesMean)
      append(fields, tensorFields("mean_stress_", centreMeans(run, body, std::move(means))));
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
    field.values.push_back(isFinal ? -force / run.certificate->patches[std::size_t(f)].measure : unknown);
  }
  return {field};
}

} // namespace ndframe
