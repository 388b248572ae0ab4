#pragma once

#include "ndframe/algebra/comm.hpp"

namespace ndframe::test
{

/// The processes this test program runs on: one, or those that mpirun started.
const Comm& comm();

/// Whether the program is one with the address sanitizer, whose shadow memory fits under no limit of memory.
bool isSanitized();

} // namespace ndframe::test
