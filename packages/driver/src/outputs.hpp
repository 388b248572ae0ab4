#pragma once

#include "ndframe/base/params.hpp"

namespace ndframe
{

/// Which states NAME.e holds.
enum class StepsWritten
{
  Final,
  AllSweeps
};

const Names<StepsWritten>& stepsNames();

/// Refuses an output folder that cannot be made or written in, before anything is computed. `output`: the list Output.
void checkOutputFolder(const Params& output);

} // namespace ndframe
