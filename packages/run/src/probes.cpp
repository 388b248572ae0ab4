#include "probes.hpp"

#include <algorithm>

#include "contact_at_points.hpp"
#include "ndframe/assembly/point_values.hpp"
#include "ndframe/mechanics/elasticity.hpp"

namespace ndframe
{
namespace
{

using Triple = std::array<double, 3>;

/// Whether a body is one that tied interfaces have joined of this and others.
bool isPartOf(const std::string& joined, const std::string& name)
{
  const std::string between = " + ", all = between + joined + between;
  return all.find(between + name + between) != std::string::npos;
}

std::vector<double> firstOf(const Triple& values, int dim)
{
  return {values.begin(), values.begin() + dim};
}

/// About z in the plane, about x, y and z in space.
std::vector<double> momentOf(const Triple& moment, int dim)
{
  return dim == 2 ? std::vector<double>{moment[2]} : firstOf(moment, dim);
}

/// Nodal values, interpolated on the facet; waves below zero between them are none. Where several interfaces meet, the
/// one that presses most; without values the first.
void addContact(PointSummary& point, const std::vector<ContactPlace>& places, const std::vector<ContactNode>& contact)
{
  for (const ContactPlace& place : places) {
    const double pressure = contact.empty() ? 0.0 : std::max(0.0, place.value(contact, &ContactNode::pressure));
    if (point.contactPressure && *point.contactPressure >= pressure)
      continue;
    point.contactPressure = pressure;
    point.contactGap = contact.empty() ? 0.0 : place.value(contact, &ContactNode::gap);
  }
}

/// The last state of a body.
struct Fields
{
  Fields(const Run& run, std::size_t b)
      : displacement(run.solved.fields[b].displacement.back()),
        strained(run.condensed.systems[b].dofs.frames.toGlobal(run.solved.fields[b].u.back()))
  {}

  const Vector& displacement;
  NodalField strained; ///< but for a rigid motion
};

ProbeSummary outlineOf(const Model& model, int number, const ProbeOptions& probe,
                       const std::vector<ContactNode>& contact)
{
  const BodyModel& body = model.bodies[std::size_t(number)];
  const std::vector<double> zero(std::size_t(body.mesh.dim), 0.0);
  ProbeSummary summary;
  summary.name = probe.name;
  summary.body = body.name;
  summary.isLine = probe.isLine();
  for (auto& wanted : probe.wanted()) {
    PointSummary point;
    addContact(point, contactPlaces(model, number, wanted, reachOf(probe, model, number)), contact);
    point.point = std::move(wanted);
    point.displacement = zero;
    summary.points.push_back(std::move(point));
  }
  if (!probe.side.empty())
    summary.side = SideSummary{probe.side, 0.0, zero, zero, momentOf({}, body.mesh.dim), zero};
  return summary;
}

void addValues(ProbeSummary& summary, const BodyModel& body, const Fields& fields, const ProbeOptions& probe,
               double reach, const Comm& comm)
{
  const auto values = valuesAtPoints(body, fields.displacement, fields.strained, probe.wanted(), reach, comm);
  for (std::size_t i = 0; i < values.size(); ++i) {
    summary.points[i].displacement = firstOf(values[i].displacement, body.mesh.dim);
    summary.points[i].stress = values[i].stress;
    summary.points[i].vonMises = vonMises(values[i].stress);
  }
}

void addIntegrals(SideSummary& summary, const BodyModel& body, const Fields& fields, const ProbeOptions& probe,
                  const Comm& comm)
{
  const SideIntegrals integrals =
      integrateSide(body, *probedSide(body, probe), fields.displacement, fields.strained, comm);
  Triple about = integrals.centre;
  std::copy(probe.about.begin(), probe.about.end(), about.begin());
  summary.measure = integrals.measure;
  summary.displacement = firstOf(integrals.displacement, body.mesh.dim);
  summary.force = firstOf(integrals.force, body.mesh.dim);
  summary.moment = momentOf(integrals.momentAbout(about), body.mesh.dim);
  summary.about = firstOf(about, body.mesh.dim);
}

/// Whether a probe has a place, and its points the body's dimension.
bool fits(const BodyModel& body, const ProbeOptions& probe)
{
  const auto wanted = probe.wanted();
  return !body.isRigid && !(wanted.empty() && probe.side.empty()) &&
         std::all_of(wanted.begin(), wanted.end(),
                     [&](const std::vector<double>& point) { return int(point.size()) == body.mesh.dim; });
}

} // namespace

int probedBody(const Model& model, const ProbeOptions& probe)
{
  const int exact = model.bodyIndex(probe.body);
  const auto part = std::find_if(model.bodies.begin(), model.bodies.end(),
                                 [&](const BodyModel& body) { return isPartOf(body.name, probe.body); });
  return exact >= 0 || part == model.bodies.end() ? exact : int(part - model.bodies.begin());
}

const Side* probedSide(const BodyModel& body, const ProbeOptions& probe)
{
  const Side* const exact = body.side(probe.side);
  return exact != nullptr ? exact : body.side(probe.body + ": " + probe.side);
}

double reachOf(const ProbeOptions& probe, const Model& model, int body)
{
  return probe.tolerance * model.diameterOf(body);
}

std::vector<ProbeSummary> outlineProbes(const Model& model, const std::vector<ProbeOptions>& probes)
{
  std::vector<ProbeSummary> summaries;
  for (const ProbeOptions& probe : probes)
    if (const int body = probedBody(model, probe); body >= 0 && fits(model.bodies[std::size_t(body)], probe))
      summaries.push_back(outlineOf(model, body, probe, {}));
  return summaries;
}

std::vector<ProbeSummary> sampleProbes(const Run& run, const std::vector<ProbeOptions>& probes, const Comm& comm)
{
  std::vector<ProbeSummary> summaries;
  for (const ProbeOptions& probe : probes) {
    const int number = probedBody(run.model, probe);
    const BodyModel& body = run.model.bodies[std::size_t(number)];
    const Fields fields(run, std::size_t(number));
    summaries.push_back(outlineOf(run.model, number, probe, run.solved.contact));
    addValues(summaries.back(), body, fields, probe, reachOf(probe, run.model, number), comm);
    if (summaries.back().side)
      addIntegrals(*summaries.back().side, body, fields, probe, comm);
  }
  return summaries;
}

} // namespace ndframe
