#pragma once

#include "ndframe/run/run_steps.hpp"

namespace ndframe
{

/// Everything that the checks of a model find, of one that these ranks have. Collective among them.
void checkModel(Model& model, const RunTools& tools, const Comm& having);

} // namespace ndframe
