#pragma once

#include <string>

namespace ndframe
{

/// What the environment says of the launcher that started this process (mpirun, srun, Hydra, ...).
struct Launcher
{
  bool present = false;     ///< somebody started this process as one of possibly several
  int size = 1;             ///< how many; 0: it does not say, MPI will (PMIx)
  int rank = 0;             ///< of this process, as far as the launcher says
  int sizeHere = 0;         ///< how many of them on this machine; 0: it does not say
  std::string sizeVariable; ///< the variable that says `size`; empty where none does

  /// True where only MPI can tell who else was started.
  bool mayHaveStartedMore() const { return present && size != 1; }
  /// True where the launcher says that all its processes are on this machine.
  bool startedAllHere() const { return size > 0 && sizeHere == size; }
  /// True where processes of this machine must wait for each other's processors (those that the system has online).
  bool sharesProcessors() const;
};

/// Reads the variables of Open MPI, PMI (Hydra: MPICH, Intel MPI), MVAPICH2, Slurm and PMIx, in this order: the first
/// one that names a size counts, for a launcher within another's job is the one that started this process.
Launcher launcherOfThisProcess();

} // namespace ndframe
