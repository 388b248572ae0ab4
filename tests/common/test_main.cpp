#include "common/test_main.hpp"

#include <optional>

#include <gtest/gtest.h>

namespace
{
std::optional<ndframe::Comm> worldComm;
}

const ndframe::Comm& ndframe::test::comm()
{
  return *worldComm;
}

bool ndframe::test::isSanitized()
{
#if defined(__SANITIZE_ADDRESS__)
  return true;
#else
  return false;
#endif
}

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  worldComm = ndframe::Comm::world(argc, argv);
  // Ranks fail together or not at all: one rank's failure must not leave the others waiting in a collective call.
  const int failures = worldComm->sum(std::int64_t(RUN_ALL_TESTS() != 0)) > 0 ? 1 : 0;
  ndframe::finishMpi();
  return failures;
}
