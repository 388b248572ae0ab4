#pragma once

#include "ndframe/algebra/comm.hpp"

namespace ndframe::test
{

/// The processes this test program runs on: one, or those that mpirun started.
const Comm& comm();

} // namespace ndframe::test
