#include "ndframe/driver/main.hpp"
#include "ndframe/base/build_info.hpp"
#include "ndframe_commit.hpp"

int main(int argc, char** argv)
{
  ndframe::setBuildCommit(NDFRAME_COMMIT);
  return ndframe::runMain(argc, argv);
}
