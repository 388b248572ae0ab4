#pragma once

#include <functional>
#include <optional>

#include "ndframe/base/ledger.hpp"
#include "ndframe/simd/batched_stars.hpp"
#include "star_system.hpp"

namespace ndframe
{

/// Which solver takes the stars of a body; the results are the same to round-off.
enum class StarKernels
{
  Batched, ///< in two dimensions BatchedStars takes what it can
  General  ///< StarSystem takes all
};

/// All stars of one body: the initial pass and the sweeps. Model and data must outlive it.
///
/// Each rank solves a share of the stars; the corrections are replicated on all ranks. All functions are collective.
class BodyStars
{
public:
  BodyStars(const BodyModel& model, const StaticData& data, StarKernels kernels = StarKernels::Batched);

  const StarBody& body() const { return body_; }

  /// The sum of all stars' corrections, one per field. Counts "stars".
  std::vector<StressCorrection> solve(const std::vector<FieldInput>& fields, const Comm& comm, Ledger& ledger) const;

  /// One block Gauss-Seidel sweep, colour by colour: on each star the energy of the total falls to its minimum over the
  /// fields without data. Counts "stars".
  void sweep(std::vector<StressCorrection>& corrections, const Comm& comm, Ledger& ledger);

private:
  /// Does `work` for this rank's share of the vertices and sums what it adds to the corrections over the ranks. A mesh
  /// that touches itself is refused on all ranks alike.
  void shareOut(const std::vector<int>& vertices, std::vector<StressCorrection>& corrections, const Comm& comm,
                const std::function<void(const std::vector<int>&)>& work) const;

  void solveGeneral(const std::vector<FieldInput>& fields, const std::vector<int>& vertices,
                    std::vector<StressCorrection>& corrections) const;
  void relaxGeneral(const std::vector<int>& vertices, std::vector<StressCorrection>& corrections) const;

  StarBody body_;
  std::optional<BatchedStars> batched_;
  std::vector<std::vector<int>> colours_; ///< found by the first sweep
};

} // namespace ndframe
