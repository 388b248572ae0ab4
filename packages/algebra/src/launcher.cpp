#include "ndframe/algebra/launcher.hpp"

#include <array>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace ndframe
{
namespace
{

/// The number in a variable; nothing where it is not set or no number.
std::optional<int> numberIn(const char* variable)
{
  const char* const text = std::getenv(variable);
  if (text == nullptr)
    return std::nullopt;
  int number = 0;
  const char* const end = text + std::strlen(text);
  const auto [rest, error] = std::from_chars(text, end, number);
  if (error != std::errc() || rest != end || number < 0)
    return std::nullopt;
  return number;
}

struct Variables
{
  const char* size; ///< nullptr: this launcher's protocol tells the size to MPI only
  const char* rank;
};

/// Slurm's SLURM_NTASKS is that of the job and also set for a program that srun did not start; the step's is not.
constexpr std::array<Variables, 5> known{{{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
                                          {"PMI_SIZE", "PMI_RANK"},
                                          {"MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK"},
                                          {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"},
                                          {nullptr, "PMIX_RANK"}}};

} // namespace

Launcher launcherOfThisProcess()
{
  for (const Variables& variables : known) {
    const auto rank = numberIn(variables.rank);
    if (variables.size == nullptr && rank)
      return {true, 0, *rank, {}};
    const auto size = variables.size == nullptr ? std::nullopt : numberIn(variables.size);
    if (size && *size > 0)
      return {true, *size, rank.value_or(0), variables.size};
  }
  return {};
}

} // namespace ndframe
