#pragma once

#include <functional>

namespace ndframe
{

/// OpenMP loops of this thread run on it alone, as long as the object lives. CHOLMOD 3 opens loops of four threads
/// whatever OMP_NUM_THREADS says, one for every pair of supernodes: on two busy processors the threads were measured to
/// cost a sixth of a run's processor time, and a team of one thread, which libgomp makes and wakes by a system call, an
/// eighth of the factorisation (180 000 loops at 250 000 dofs). So such a loop is called as a function (GOMP_parallel
/// in serial_openmp.cpp); in a program that hides that function libgomp is asked for teams of one.
class SerialOpenMp
{
public:
  /// onRegion: called after each loop of this thread, where loops are called as functions.
  explicit SerialOpenMp(std::function<void()> onRegion = {});
  ~SerialOpenMp();
  SerialOpenMp(const SerialOpenMp&) = delete;
  SerialOpenMp& operator=(const SerialOpenMp&) = delete;

private:
  int levelsBefore_;
  std::function<void()> onRegion_;
  const std::function<void()>* observerBefore_;
};

} // namespace ndframe
