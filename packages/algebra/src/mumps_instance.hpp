#pragma once

#include <stdexcept>
#include <string>

#include <dmumps_c.h>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// A failure that MUMPS reports; the same on all ranks.
class MumpsFailure : public std::runtime_error
{
public:
  enum class Kind
  {
    Workspace, ///< MUMPS's estimate of the memory was too small
    Memory,    ///< the machine has too little memory
    Singular,  ///< the matrix is singular or not positive definite
    Other
  };

  /// The values of INFOG(1) and INFOG(2).
  MumpsFailure(int code, int detail);
  Kind kind() const { return kind_; }

private:
  Kind kind_;
};

/// One MUMPS solver for symmetric positive definite matrices, silent. Parameters keep the numbers of MUMPS's manual.
class MumpsInstance
{
public:
  /// Starts MPI when it is not running; a single process has the instance to itself. Collective, as is all the rest.
  explicit MumpsInstance(const Comm& comm);
  MumpsInstance(const MumpsInstance&) = delete;
  MumpsInstance& operator=(const MumpsInstance&) = delete;
  ~MumpsInstance();

  DMUMPS_STRUC_C& data() { return data_; }
  const DMUMPS_STRUC_C& data() const { return data_; }
  MUMPS_INT& icntl(int i) { return data_.icntl[i - 1]; }
  int infog(int i) const { return data_.infog[i - 1]; }
  double rinfog(int i) const { return data_.rinfog[i - 1]; }

  /// Throws MumpsFailure.
  void analyse() { run(1); }
  /// Asks for more memory as long as MUMPS finds its estimate too small. Throws MumpsFailure.
  void factor();
  /// Throws MumpsFailure.
  void solve() { run(3); }

private:
  void run(int job);
  DMUMPS_STRUC_C data_{};
};

} // namespace ndframe
