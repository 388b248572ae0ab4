#include "report/sample_summaries.hpp"

#include <limits>

namespace ndframe::test
{

namespace
{

ErrorSummary sampleErrors()
{
  ErrorSummary errors;
  errors.mode = "Strict";
  errors.recovery = "Star";
  errors.interfaceTraction = "Optimal";
  errors.degree = 2;
  errors.reason = "the gap is too rough to be resolved";
  errors.global = ErrorMeasureSummary{0.0625, 0.05, 0.0575, 0.01, 0.002, 0.001};
  errors.algorithm = ErrorMeasureSummary{0.05, 0.04, 0.05, 0.0, 0.0, 0.0};
  errors.discretization = ErrorMeasureSummary{0.03, 0.025, 0.03, 0.0, 0.0, 0.0};
  errors.splitStress = 0.031;
  errors.meanStress = 0.03125;
  errors.meanStressRelative = 0.025;
  errors.zienkiewiczZhu = 0.028;
  errors.residual = 0.15;
  errors.equilibrium = 3e-15;
  errors.equilibriumDiscretization = 4e-15;
  errors.reference = ReferenceSummary{3, 300000, "", 0.06, 0.048, 0.03, 0.031, 1.04, 1.01};
  errors.advice = "2 more sweeps would leave the mesh alone";
  return errors;
}

AccuracySummary sampleAccuracy()
{
  const LevelSummary first{1, 48, 6, 0.875, 2, 0.25, 0.2, 0.07, 0.24, "foundation", {0.5, -0.25}, 832, 0.01};
  const LevelSummary second{2, 910, 201, 0.5, 1, 0.0625, 0.05, 0.01, 0.06, "foundation", {1.5, 0.75}, 0, 0.04};
  return {"Displacement", 0.06, true, true, "", {first, second}, 2};
}

/// A point, a line and a side, in the plane.
std::vector<ProbeSummary> sampleProbes()
{
  PointSummary point;
  point.point = {1.0, 0.5};
  point.displacement = {0.25, -0.125};
  point.stress = {-1.0, -2.0, -0.75, 0.5, 0.0, 0.0};
  point.vonMises = 1.5;
  PointSummary touching = point;
  touching.contactPressure = 1.75;
  touching.contactGap = 0.0;
  ProbeSummary tip, line, side;
  tip.name = "tip";
  line.name = "a line, with a comma";
  side.name = "base";
  tip.body = line.body = side.body = "punch";
  line.isLine = true;
  tip.points = {point};
  line.points = {point, touching};
  side.side = SideSummary{"bottom", 2.0, {0.0, -0.25}, {0.5, 1.0}, {-0.125}, {1.0, -1.0}};
  return {tip, line, side};
}

} // namespace

RunSummary singleBodySummary()
{
  RunSummary summary;
  summary.version = "0.1.0";
  summary.title = "Beam";
  summary.deckJson = R"({"Title": "Beam", "Bodies": {"beam": {"Mesh": {"Type": "Box", "Cells": [4, 1, 1]}}}})";
  const SupportSummary clamp{"wall", "clamp at left", {0.0, 0.0, 1.0}, {0.5, -2.0, 0.0}, {0.0, 0.5, 0.5}};
  summary.bodies = {{"beam",
                     1986,
                     468,
                     2,
                     "Cholmod",
                     "clamp at left",
                     1.0 / 3.0,
                     {0.0, 0.0, -1.0},
                     {clamp},
                     {0.25, {4.0, 0.0, 1.0}},
                     {0.01, {0.0, 0.0, 1.0}}}};
  summary.perUnitThickness = false;
  summary.warnings = {{"large strain", "strains reach 0.06"}};
  summary.energy = 1.0 / 3.0;
  summary.residuals = {1e-15, 0.0, 0.0, 0.0};
  summary.counts = {{"factorisations", 1}, {"bytes written", 5'000'000'000}};
  summary.stages = {{"read", 0.25, 1'000'000}, {"factor", 0.5, 6'000'000'000}};
  summary.totalSeconds = 0.75;
  summary.peakBytes = 6'000'000'000;
  return summary;
}

RunSummary contactSummary()
{
  auto summary = singleBodySummary();
  summary.title = "Punch on a foundation";
  summary.ranks = 2;
  const PeakSummary peak{0.75, {1.0, 0.5}};
  const SupportSummary ground{"ground", "clamp at bottom", {0.0, 1.0}, {-0.25}, {1.0, -1.0}};
  summary.bodies = {
      {"punch", 1986, 468, 2, "Cholmod", "x: roller at left; y: contact only", 0.5, {0.0, -1.0}, {}, peak, peak},
      {"foundation", 3842, 924, 2, "Cholmod", "clamp at bottom", 1.0, {0.0, 0.0}, {ground}, peak, peak}};
  summary.perUnitThickness = true;
  summary.energy = 1.5;
  InterfaceSummary interface;
  interface.name = "contact";
  interface.dirichletBody = "punch";
  interface.neumannBody = "foundation";
  interface.nodes = 61;
  interface.closedNodes = 60;
  interface.forceOnDirichlet = {0.0, 1.0};
  interface.forceOnNeumann = {0.0, -0.9375};
  interface.contactForce = 1.0;
  interface.contactMeasure = 0.957;
  interface.endPoints = {{0.0, 1.0}, {0.957, 1.0}};
  interface.endBrackets = {{{0.957, 1.0}, {0.96, 1.0}}};
  interface.largestPressure = 1.75;
  interface.largestPenetration = 3.1e-17;
  summary.interfaces = {interface};
  summary.probes = sampleProbes();
  const SweepSummary first{1, 2.0, 0.5, 1, 2, 60, 1, -1.0, 0.0, 0.0, "first"};
  const SweepSummary second{2, std::numeric_limits<double>::quiet_NaN(), 0.5, 0, 1, 60, 1, -1.0, -0.5, 0.0, ""};
  summary.coupling = CouplingSummary{"Neumann-Dirichlet", 2, true, "eps_tau 0.091 < 0.1", {first, second}, {}};
  summary.errors = sampleErrors();
  summary.accuracy = sampleAccuracy();
  summary.expectations = {{"coupling/sweeps", 2.0, 2.0, 0.0, true}};
  return summary;
}

} // namespace ndframe::test
