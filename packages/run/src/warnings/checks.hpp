#pragma once

#include "ndframe/run/run.hpp"
#include "ndframe/run/run_settings.hpp"

namespace ndframe
{

// The checks behind the warnings, one source file each; they look at their arguments and add what they find.

// Of the scene.
void findDifferentHypotheses(const Model& model, const SceneSettings& scene, Diagnostics& found);
void findDifferentModuli(const Model& model, const SceneSettings& scene, Diagnostics& found);
void findLocking(const Model& model, const SceneSettings& scene, Diagnostics& found);
void findUnconnectedParts(const Model& model, const SceneSettings& scene, Diagnostics& found);
void findLoadsOnSupports(const Model& model, const SceneSettings& scene, Diagnostics& found);
void findTouchingBodies(const Model& model, const SceneSettings& scene, Diagnostics& found);

/// A run with a solution, and what its summary says of the bodies.
struct Answer
{
  const Run& run;
  const std::vector<BodySummary>& bodies;
  const Comm& comm; ///< each of them makes the checks, and finds the same
};

// Of the answer.
void findStrangeStrain(const Answer& answer, const RunSettings& settings, Diagnostics& found);
void findFewContactNodes(const Answer& answer, const RunSettings& settings, Diagnostics& found);
void findContactAtEnds(const Answer& answer, const RunSettings& settings, Diagnostics& found);
void findOverlaps(const Answer& answer, const RunSettings& settings, Diagnostics& found);

} // namespace ndframe
