#include "ndframe/base/build_info.hpp"

#include "ndframe_build.hpp"

namespace ndframe
{

namespace
{

BuildInfo& theBuildInfo()
{
  static BuildInfo info{"unknown", NDFRAME_BUILD_TYPE, NDFRAME_COMPILER, {NDFRAME_LIBRARIES}};
  return info;
}

} // namespace

const BuildInfo& buildInfo()
{
  return theBuildInfo();
}

void setBuildCommit(const std::string& commit)
{
  theBuildInfo().commit = commit;
}

} // namespace ndframe
