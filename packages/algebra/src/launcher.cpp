#include "ndframe/algebra/launcher.hpp"

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

#include <unistd.h>

namespace ndframe
{
namespace
{

/// The number in a variable; nothing where there is no such variable, it is not set or no number.
std::optional<int> numberIn(const char* variable)
{
  const char* const value = variable == nullptr ? nullptr : std::getenv(variable);
  const std::string_view text(value == nullptr ? "" : value);
  int number = -1;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool isNumber = error == std::errc() && rest == text.data() + text.size() && number >= 0;
  return isNumber ? std::optional(number) : std::nullopt;
}

struct Variables
{
  const char* size; ///< nullptr: this launcher's protocol tells the size to MPI only
  const char* rank;
  const char* sizeHere; ///< nullptr: no plain number
};

/// Slurm's SLURM_NTASKS is that of the job and also set for a program that srun did not start; the step's is not.
constexpr Variables known[] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_LOCAL_SIZE"},
                               {"PMI_SIZE", "PMI_RANK", "MPI_LOCALNRANKS"},
                               {"MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK", "MV2_COMM_WORLD_LOCAL_SIZE"},
                               {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID", nullptr},
                               {nullptr, "PMIX_RANK", nullptr}};

} // namespace

bool Launcher::sharesProcessors() const
{
  return sizeHere > sysconf(_SC_NPROCESSORS_ONLN);
}

Launcher launcherOfThisProcess()
{
  for (const Variables& variables : known) {
    const auto rank = numberIn(variables.rank);
    if (variables.size == nullptr && rank)
      return {true, 0, *rank, 0, {}};
    if (const auto size = numberIn(variables.size); size && *size > 0)
      return {true, *size, rank.value_or(0), numberIn(variables.sizeHere).value_or(0), variables.size};
  }
  return {};
}

} // namespace ndframe
