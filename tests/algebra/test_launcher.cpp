// Who started this process, by the variables that launchers set.

#include <cstdlib>
#include <map>
#include <optional>

#include <gtest/gtest.h>

#include "ndframe/algebra/launcher.hpp"

namespace ndframe
{
namespace
{

/// An environment in which no launcher has left anything, as long as it lives.
class NoLauncher : public testing::Test
{
protected:
  NoLauncher()
  {
    for (const char* name :
         {"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_LOCAL_SIZE", "PMI_SIZE", "PMI_RANK",
          "MPI_LOCALNRANKS", "MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK", "MV2_COMM_WORLD_LOCAL_SIZE",
          "SLURM_STEP_NUM_TASKS", "SLURM_PROCID", "SLURM_NTASKS", "PMIX_RANK"})
    {
      const char* const value = std::getenv(name);
      before_[name] = value == nullptr ? std::nullopt : std::optional<std::string>(value);
      unsetenv(name);
    }
  }
  ~NoLauncher() override
  {
    for (const auto& [name, value] : before_)
      if (value)
        setenv(name.c_str(), value->c_str(), 1);
      else
        unsetenv(name.c_str());
  }
  static void set(const char* name, const char* value) { setenv(name, value, 1); }

private:
  std::map<std::string, std::optional<std::string>> before_;
};

} // namespace

TEST_F(NoLauncher, MeansAProcessAlone)
{
  EXPECT_FALSE(launcherOfThisProcess().present);
  EXPECT_FALSE(launcherOfThisProcess().mayHaveStartedMore());
  set("SLURM_NTASKS", "4"); // of a job whose script started this process itself
  EXPECT_FALSE(launcherOfThisProcess().mayHaveStartedMore());
}

TEST_F(NoLauncher, EveryKnownLauncherIsRecognised)
{
  for (const auto& [size, rank] :
       {std::pair("OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"), std::pair("PMI_SIZE", "PMI_RANK"),
        std::pair("MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK"), std::pair("SLURM_STEP_NUM_TASKS", "SLURM_PROCID")})
  {
    set(size, "4");
    set(rank, "3");
    const Launcher several = launcherOfThisProcess();
    EXPECT_TRUE(several.mayHaveStartedMore()) << size;
    EXPECT_EQ(several.size, 4);
    EXPECT_EQ(several.rank, 3);
    EXPECT_EQ(several.sizeVariable, size);
    set(size, "1");
    EXPECT_TRUE(launcherOfThisProcess().present);
    EXPECT_FALSE(launcherOfThisProcess().mayHaveStartedMore()) << size;
    unsetenv(size);
    unsetenv(rank);
  }
}

TEST_F(NoLauncher, PmixSaysTheRankAndLeavesTheSizeToMpi)
{
  set("PMIX_RANK", "2");
  EXPECT_TRUE(launcherOfThisProcess().mayHaveStartedMore());
  EXPECT_EQ(launcherOfThisProcess().size, 0);
  EXPECT_EQ(launcherOfThisProcess().rank, 2);
  set("SLURM_STEP_NUM_TASKS", "1"); // a shell that srun started
  EXPECT_FALSE(launcherOfThisProcess().mayHaveStartedMore());
}

TEST_F(NoLauncher, MpirunWithinAStepOfSlurmIsTheLauncher)
{
  set("SLURM_STEP_NUM_TASKS", "1");
  set("SLURM_PROCID", "0");
  set("OMPI_COMM_WORLD_SIZE", "2");
  set("OMPI_COMM_WORLD_RANK", "1");
  EXPECT_EQ(launcherOfThisProcess().size, 2);
  EXPECT_EQ(launcherOfThisProcess().rank, 1);
}

TEST_F(NoLauncher, ProcessesOfThisMachineAreCountedWhereTheLauncherSaysSo)
{
  EXPECT_FALSE(launcherOfThisProcess().startedAllHere());
  for (const auto& [size, here] :
       {std::pair("OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_LOCAL_SIZE"), std::pair("PMI_SIZE", "MPI_LOCALNRANKS"),
        std::pair("MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_LOCAL_SIZE")})
  {
    set(size, "100000"); // more than any machine has processors
    EXPECT_FALSE(launcherOfThisProcess().startedAllHere()) << "it may be on several";
    EXPECT_FALSE(launcherOfThisProcess().sharesProcessors());
    set(here, "1");
    EXPECT_FALSE(launcherOfThisProcess().startedAllHere()) << here;
    EXPECT_FALSE(launcherOfThisProcess().sharesProcessors());
    set(here, "100000");
    EXPECT_TRUE(launcherOfThisProcess().startedAllHere()) << here;
    EXPECT_TRUE(launcherOfThisProcess().sharesProcessors());
    unsetenv(size);
    unsetenv(here);
  }
}

TEST_F(NoLauncher, VariablesThatAreNoNumbersSayNothing)
{
  for (const char* text : {"", "two", "2x", "-3", "0"}) {
    set("PMI_SIZE", text);
    EXPECT_FALSE(launcherOfThisProcess().mayHaveStartedMore()) << text;
  }
}

} // namespace ndframe
