#pragma once

#include <omp.h>

namespace ndframe
{

/// OpenMP loops of this thread run on it alone, as long as the object lives. CHOLMOD 3 opens loops of four threads
/// whatever OMP_NUM_THREADS says; on two busy processors they were measured to cost a sixth of a run's processor time,
/// and where memory is limited libgomp ends the process when their stacks do not fit.
class SerialOpenMp
{
public:
  SerialOpenMp() { omp_set_max_active_levels(0); }
  ~SerialOpenMp() { omp_set_max_active_levels(before_); }
  SerialOpenMp(const SerialOpenMp&) = delete;
  SerialOpenMp& operator=(const SerialOpenMp&) = delete;

private:
  int before_ = omp_get_max_active_levels();
};

} // namespace ndframe
