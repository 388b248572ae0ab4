#pragma once

#include <cstddef>

#include <mpi.h>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// For calls of MPI; a single process has itself only.
inline MPI_Comm mpiComm(const Comm& comm)
{
  return comm.size() == 1 ? MPI_COMM_SELF : MPI_Comm_f2c(comm.communicator());
}

/// That all ranks got so many bytes from all of them: see countReductions().
void tellReduction(std::size_t bytes);

} // namespace ndframe
