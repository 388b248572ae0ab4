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

} // namespace ndframe
