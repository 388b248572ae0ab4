#pragma once

#include "ndframe/run/run.hpp"

namespace ndframe
{

// The checks behind the warnings, one source file each; they look at their arguments and add what they find.

// Of the scene.
void findDifferentHypotheses(const Model& model, const Params& deck, Diagnostics& found);
void findDifferentModuli(const Model& model, const Params& deck, Diagnostics& found);
void findLocking(const Model& model, const Params& deck, Diagnostics& found);
void findUnconnectedParts(const Model& model, const Params& deck, Diagnostics& found);
void findLoadsOnSupports(const Model& model, const Params& deck, Diagnostics& found);
void findTouchingBodies(const Model& model, const Params& deck, Diagnostics& found);

// Of the answer.
void findStrangeStrain(const Run& run, const Params& deck, Diagnostics& found);
void findFewContactNodes(const Run& run, const Params& deck, Diagnostics& found);
void findContactAtEnds(const Run& run, const Params& deck, Diagnostics& found);
void findOverlaps(const Run& run, const Params& deck, Diagnostics& found);

} // namespace ndframe
