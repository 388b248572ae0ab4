#include "batched_pass.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

const LoadModes& loadModesOfPass(const BatchedStarData& stars, bool isSweep)
{
  const StarTables& tables = stars.tables.tables();
  if (isSweep)
    return tables.withRim;
  return stars.data.cellShares.empty() ? tables.constant : tables.full;
}

} // namespace

BatchedPass::BatchedPass(const BatchedStarData& stars, const StarFieldInputs* inputs, int maxCells,
                         std::vector<StressCorrection>& corrections)
    : stars_(stars), inputs_(inputs), corrections_(corrections), fields_(int(corrections.size())),
      facetData_(2 * (stars.data.degree + 1)), lanes_(stars.kernels.lanes),
      workspace_(stars.data.degree, stars.kernels.lanes, maxCells, fields_, loadModesOfPass(stars, inputs == nullptr),
                 inputs == nullptr ? totalsPerCell(stars.data.degree) : 0, !stars.laws.empty()),
      corners_(std::size_t(lanes_))
{}

void BatchedPass::run(const int* vertices, int count)
{
  const DegreeKernels& kernels = stars_.kernelsOfDegree();
  const StarTables& tables = stars_.tables.tables();
  const Rings& rings = stars_.rings;
  count_ = count;
  for (int lane = 0; lane < lanes_; ++lane)
    corners_[std::size_t(lane)] = rings.corners(vertices[lane < count ? lane : 0]);
  batch_ = workspace_.batch(rings.valence(vertices[0]), rings.kind(vertices[0]) == Rings::Kind::Closed);
  if (stars_.data.cellShares.empty())
    batch_.bodyLoad = nullptr;
  gatherSpokes();
  if (batch_.compliance != nullptr)
    gatherLaws();
  if (inputs_ == nullptr) {
    gatherTotals();
    kernels.takeTotals(tables, batch_);
  } else {
    gatherStress();
    if (batch_.bodyLoad != nullptr)
      gatherBodyLoad();
    kernels.prepare(tables, batch_);
  }
  kernels.condense(tables, batch_);
  if (batch_.closed)
    kernels.close(batch_);
  else
    for (int lane = 0; lane < count_; ++lane)
      closeFan(lane);
  kernels.expand(tables, batch_);
  scatter();
  if (inputs_ == nullptr)
    return;
  addLoads();
  for (int lane = 0; lane < count_; ++lane)
    noteForces(lane);
}

/// The ends of a fan in one lane: the border's unknowns by a small dense problem, whatever is prescribed there.
void BatchedPass::closeFan(int lane)
{
  const int degree = stars_.data.degree, n = cellUnknowns(degree), last = batch_.cells;
  const int *vertices = stars_.body.mesh.cells.data(), first = corner(lane, 0), final = corner(lane, last - 1);
  const auto end = [&](int towards, int opposite, int spoke) {
    FanEnd facet = fanEnd(stars_, vertices[first], vertices[towards], opposite, inputs_, fields_);
    for (int k = 0; k < fields_; ++k)
      for (int i = 0; i < facetData_; ++i)
        facet.given[std::size_t(k) * std::size_t(facetData_) + std::size_t(i)] -=
            batch_.jumps[place((k * (last + 1) + spoke) * facetData_ + i, lane)];
    return facet;
  };
  FanProblem fan{degree,
                 stars_.tables.tables().arm,
                 end(Rings::next(first), Rings::previous(first), 0),
                 end(Rings::previous(final), Rings::next(final), last),
                 DenseMatrix(n, n),
                 DenseMatrix(n, fields_),
                 DenseMatrix(3, fields_)};
  for (int i = 0; i < n; ++i)
    for (int j = i; j < n; ++j)
      fan.energy(i, j) = fan.energy(j, i) = batch_.border[place(i * n + j, lane)];
  for (int k = 0; k < fields_; ++k) {
    for (int i = 0; i < n; ++i)
      fan.gradient(i, k) = batch_.gradient[place(k * n + i, lane)];
    for (int i = 0; i < 3; ++i)
      fan.offset(i, k) = batch_.offsets[place((k * (last + 1) + last) * 3 + i, lane)];
  }
  const FanSolution solution = solveFan(fan);
  for (int k = 0; k < fields_; ++k) {
    for (int i = 0; i < n; ++i)
      batch_.solution[place(k * n + i, lane)] = solution.x(i, k);
    StressCorrection& correction = corrections_[std::size_t(k)];
    correction.imbalance = std::max(correction.imbalance, solution.defect[std::size_t(k)]);
  }
}

void BatchedPass::noteForces(int lane)
{
  const auto spoke = [&](int i) { return batch_.spokes[place(i, lane)]; };
  const double size = std::hypot(spoke(0), spoke(1));
  for (int k = 0; k < fields_; ++k) {
    StressCorrection& correction = corrections_[std::size_t(k)];
    correction.force = std::max(correction.force, batch_.scale[place(k, lane)]);
    const auto left = [&](int i) {
      return std::abs(batch_.offsets[place((k * (batch_.cells + 1) + batch_.cells) * 3 + i, lane)]);
    };
    if (batch_.closed)
      correction.imbalance = std::max({correction.imbalance, left(0), left(1), left(2) / size});
  }
}

} // namespace ndframe
