#pragma once

#include <vector>

#include "ndframe/run/run_settings.hpp"

namespace ndframe
{

/// The list Output.
ListSpec outputSpec();
OutputOptions outputOptions(const Params& deck);

/// One entry of the list Expect.
ListSpec expectationSpec();
std::vector<Expectation> expectationsOf(const Params& deck);

} // namespace ndframe
