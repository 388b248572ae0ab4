#pragma once

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// The body that a probe names, as the deck does or as tied interfaces have joined it; -1 if there is none.
int probedBody(const Model& model, const ProbeOptions& probe);

/// The side of it, if it is one of integrals; null if there is none of that name.
const Side* probedSide(const BodyModel& body, const ProbeOptions& probe);

/// How far from the mesh a probe's points may be, a length.
double reachOf(const ProbeOptions& probe, const Model& model, int body);

/// Refuses probes of the list Output that are of no body, point or side of the model, or that contradict themselves.
void checkProbes(const Model& model, const std::vector<ProbeOptions>& probes, Diagnostics& diagnostics);

/// The probes before anything is solved: names, points, all values zero. Those that checkProbes refuses may be missing.
std::vector<ProbeSummary> outlineProbes(const Model& model, const std::vector<ProbeOptions>& probes);

/// The same with the values of a solved run. Collective.
std::vector<ProbeSummary> sampleProbes(const Run& run, const std::vector<ProbeOptions>& probes, const Comm& comm);

} // namespace ndframe
