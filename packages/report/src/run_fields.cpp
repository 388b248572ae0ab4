#include "run_fields.hpp"

#include <algorithm>
#include <array>

#include "error_fields.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "ndframe/run/summarize.hpp"
#include "ndframe/scene/gap_offset.hpp"
#include "stress_fields.hpp"

namespace ndframe
{
namespace
{

constexpr std::array<const char*, 3> axisNames{"x", "y", "z"};

/// A vector as the variables PREFIXx, PREFIXy(, PREFIXz).
std::vector<NamedField> vectorFields(const std::string& prefix, const Vector& values, std::size_t dim)
{
  std::vector<NamedField> fields;
  for (std::size_t k = 0; k < dim; ++k) {
    fields.push_back({prefix + axisNames.at(k), {}});
    for (std::size_t i = k; i < values.size(); i += dim)
      fields.back().values.push_back(values[i]);
  }
  return fields;
}

/// Means of the basis functions over a facet: int N_a dS / measure.
std::vector<double> facetWeights(const InterfaceMesh& interface)
{
  const auto rule = simplexRule(interface.dim - 1, interface.order);
  return withDimAndOrder(interface.dim, interface.order, [&](auto d, auto p) {
    using Basis = Lagrange<d() - 1, p()>;
    std::vector<double> weights(std::size_t(Basis::nodes), 0.0);
    double N[Basis::nodes];
    for (int q = 0; q < rule.size(); ++q) {
      Basis::values(rule.point(q), N);
      for (int a = 0; a < Basis::nodes; ++a)
        weights[std::size_t(a)] += rule.weights[std::size_t(q)] * N[a];
    }
    return weights;
  });
}

/// Mean pressure of one side (`traction`: Lambda_dir or Lambda_neu) and mean gap of every facet; status 1 where all
/// nodes are closed.
std::vector<NamedField> contactFields(const InterfaceMesh& interface, const std::vector<ContactNode>& contact,
                                      std::size_t firstNode, double ContactNode::*traction)
{
  std::vector<NamedField> fields{{"contact_pressure", {}}, {"contact_gap", {}}, {"contact_status", {}}};
  const auto weights = facetWeights(interface);
  for (std::size_t f = 0; f < std::size_t(interface.numFacets()); ++f) {
    double pressure = 0.0, gap = 0.0, closed = 1.0;
    for (std::size_t a = 0; a < weights.size(); ++a) {
      const auto& node = contact[firstNode + std::size_t(interface.facets[f * weights.size() + a])];
      pressure -= weights[a] * node.*traction;
      gap += weights[a] * node.gap;
      closed = node.closed ? closed : 0.0;
    }
    fields[0].values.push_back(pressure);
    fields[1].values.push_back(gap);
    fields[2].values.push_back(closed);
  }
  return fields;
}

/// Contact pressure at the interface nodes of one body, the same on both sides; zero elsewhere.
NamedField nodalPressure(const Run& run, std::size_t body, const std::vector<ContactNode>& contact)
{
  NamedField field{"contact_pressure", Vector(std::size_t(run.model.bodies[body].nodes.numNodes()), 0.0)};
  std::size_t firstNode = 0;
  for (const auto& interface : run.model.interfaces) {
    for (std::size_t i = 0; i < std::size_t(interface.numNodes()); ++i) {
      for (const InterfaceSide& side : interface.sides)
        if (side.body == int(body)) {
          double& value = field.values[std::size_t(side.nodes[i])];
          value = std::max(value, contact[firstNode + i].pressure); // a corner has one on each side of it
        }
    }
    firstNode += std::size_t(interface.numNodes());
  }
  return field;
}

std::vector<ExodusPart> partsOf(const BodyModel& body)
{
  std::vector<ExodusPart> parts;
  for (const BodyRegion& region : body.regions)
    parts.push_back({region.name.empty() ? body.name : body.name + ":" + region.name, {}});
  for (std::size_t c = 0; c < body.regionOfCell.size(); ++c)
    parts[std::size_t(body.regionOfCell[c])].cells.push_back(int(c));
  return parts;
}

} // namespace

ExodusStep exodusStep(const Run& run, const OutputOptions& output, std::size_t step)
{
  ExodusStep out;
  const bool touches = !run.model.interfaces.empty();
  const bool isFinal = step + 1 == run.solved.states.size();
  const std::size_t sweep = !touches ? 0 : (isFinal ? run.solved.coupling.history.size() : step + 1);
  out.time = double(sweep);
  const auto contact = contactNodes(run.model, run.condensed, run.solved.states[step], run.solved.fields, step);
  const auto offsets = gapOffsets(run.model);
  for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
    const BodyModel& body = run.model.bodies[b];
    const NodalField u = run.condensed.systems[b].dofs.frames.toGlobal(run.solved.fields[b].u[step]);
    out.nodal.push_back(vectorFields("disp_", run.solved.fields[b].displacement[step], std::size_t(body.mesh.dim)));
    if (!offsets.empty())
      append(out.nodal.back(), vectorFields("offset_", offsets[b], std::size_t(body.mesh.dim)));
    if (touches)
      out.nodal.back().push_back(nodalPressure(run, b, contact));
    append(out.nodal.back(), nodalStressFields(body, u));
    if (body.share) // means over cells are complete at own nodes
      for (NamedField& field : out.nodal.back())
        body.share->fetch(field.values, 1);
    out.element.push_back(cellStressFields(body, u));
    append(out.element.back(), elementErrorFields(run, output, b, isFinal));
  }
  std::size_t firstNode = 0;
  for (std::size_t i = 0; i < run.model.interfaces.size(); ++i) {
    const auto& interface = run.model.interfaces[i];
    for (const auto traction : {&ContactNode::tractionDirichlet, &ContactNode::tractionNeumann}) {
      out.contactSide.push_back(contactFields(interface, contact, firstNode, traction));
      append(out.contactSide.back(), admissiblePressure(run, i, isFinal));
    }
    firstNode += std::size_t(interface.numNodes());
  }
  if (touches)
    out.global = {{"eps_tau", {run.solved.coupling.history[sweep - 1].epsTau}},
                  {"converged", {isFinal && run.solved.coupling.converged ? 1.0 : 0.0}}};
  return out;
}

ExodusScene exodusScene(const Run& run)
{
  ExodusScene scene{run.summary.title, {}, {}, {}, run.condensed.ranks};
  for (const auto& body : run.model.bodies) {
    scene.bodies.push_back({body.name, &body.mesh, &body.nodes, partsOf(body)});
    if (run.model.told)
      scene.shares.push_back(body.share);
  }
  for (const auto& interface : run.model.interfaces) {
    scene.sides.push_back({interface.name + ":dirichlet", interface.dirichlet().body, interface.dirichlet().facets});
    scene.sides.push_back({interface.name + ":neumann", interface.neumann().body, interface.neumann().facets});
  }
  return scene;
}

std::vector<std::string> exodusRecords(const std::string& deckName)
{
  return {"ndframe " + versionText(), "deck " + deckName};
}

} // namespace ndframe
