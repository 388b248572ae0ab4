#include "body_stars.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/equilibrium/self_touching.hpp"
#include "ndframe/equilibrium/settle_balance.hpp"

namespace ndframe
{
namespace
{

BodyCorrections pointersTo(std::vector<StressCorrection>& corrections)
{
  BodyCorrections pointers;
  for (StressCorrection& correction : corrections)
    pointers.push_back(&correction);
  return pointers;
}

std::vector<int> shareOfRank(const std::vector<int>& vertices, const Comm& comm)
{
  const auto border = [&](int rank) { return vertices.begin() + std::ptrdiff_t(vertices.size()) * rank / comm.size(); };
  return {border(comm.rank()), border(comm.rank() + 1)};
}

/// values = before + sum over the ranks of what each has added.
void sumChanges(Vector& values, const Vector& before, const Comm& comm)
{
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] -= before[i];
  comm.sum(values);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] += before[i];
}

} // namespace

void BodyStars::shareOut(const std::vector<int>& vertices, std::vector<StressCorrection>& corrections, const Comm& comm,
                         const std::function<void(const std::vector<int>&)>& work) const
{
  const std::vector<int> own = shareOfRank(vertices, comm);
  if (comm.size() == 1)
    return work(own);
  const std::vector<StressCorrection> before = corrections;
  Vector refused{-1.0}; // the largest vertex
  try {
    work(own);
  } catch (const SelfTouching& place) {
    refused[0] = place.vertex;
  }
  takeLargest(refused, comm);
  if (refused[0] >= 0.0)
    throw SelfTouching(body_.model(), int(refused[0]));
  for (std::size_t field = 0; field < corrections.size(); ++field) {
    StressCorrection& correction = corrections[field];
    sumChanges(correction.tractions, before[field].tractions, comm);
    sumChanges(correction.loads, before[field].loads, comm);
    agreeOnImbalance(correction, comm);
  }
}

BodyStars::BodyStars(const BodyModel& model, const StaticData& data, StarKernels kernels) : body_(model, data)
{
  if (kernels == StarKernels::Batched)
    batched_.emplace(model, data);
}

std::vector<StressCorrection> BodyStars::solve(const std::vector<FieldInput>& fields, const Comm& comm,
                                               Ledger& ledger) const
{
  std::vector<StressCorrection> corrections(fields.size(), zeroCorrection(body_.model().mesh, body_.data().degree));
  std::vector<int> all(std::size_t(body_.model().mesh.numPoints()));
  std::iota(all.begin(), all.end(), 0);
  shareOut(all, corrections, comm, [&](const std::vector<int>& vertices) {
    solveGeneral(fields, batched_ ? batched_->add(fields, vertices, corrections) : vertices, corrections);
  });
  ledger.count("stars", std::int64_t(all.size()));
  return corrections;
}

void BodyStars::solveGeneral(const std::vector<FieldInput>& fields, const std::vector<int>& vertices,
                             std::vector<StressCorrection>& corrections) const
{
  const StarLoads loads(body_, fields);
  for (const int vertex : vertices) {
    const StarSystem system(body_, body_.star(vertex));
    Vector force;
    StarFields x = loads.initial(system.star(), force);
    const Vector imbalance = system.balance(x);
    system.relax(x);
    add(body_, system.star(), x, pointersTo(corrections));
    for (std::size_t field = 0; field < fields.size(); ++field) {
      corrections[field].imbalance = std::max(corrections[field].imbalance, imbalance[field]);
      corrections[field].force = std::max(corrections[field].force, force[field]);
    }
  }
}

void BodyStars::sweep(std::vector<StressCorrection>& corrections, const Comm& comm, Ledger& ledger)
{
  if (colours_.empty())
    colours_ = colourVertices(body_.model().mesh, body_.around());
  for (const std::vector<int>& colour : colours_)
    shareOut(colour, corrections, comm, [&](const std::vector<int>& vertices) {
      relaxGeneral(batched_ ? batched_->relax(vertices, corrections) : vertices, corrections);
    });
  ledger.count("stars", body_.model().mesh.numPoints());
}

void BodyStars::relaxGeneral(const std::vector<int>& vertices, std::vector<StressCorrection>& corrections) const
{
  for (const int vertex : vertices) {
    const StarSystem system(body_, body_.star(vertex));
    StarFields x = gather(body_, system.star(), pointersTo(corrections));
    system.relax(x);
    scatter(body_, system.star(), x, pointersTo(corrections));
  }
}

} // namespace ndframe
