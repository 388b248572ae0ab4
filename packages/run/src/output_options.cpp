#include "ndframe/run/output_options.hpp"

namespace ndframe
{

const Names<StepsWritten>& stepsNames()
{
  static const Names<StepsWritten> names{{"Final", StepsWritten::Final}, {"All Sweeps", StepsWritten::AllSweeps}};
  return names;
}

} // namespace ndframe
