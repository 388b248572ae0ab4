#include "batched_pass.hpp"

namespace ndframe
{
namespace
{

/// target := matrix * source (modes x 2), written to one lane.
void permute(const double* matrix, const double* source, int modes, int lanes, double* target)
{
  for (int mode = 0; mode < modes; ++mode)
    for (int i = 0; i < 2; ++i, target += lanes) {
      *target = 0.0;
      for (int j = 0; j < modes; ++j)
        *target += matrix[mode * modes + j] * source[2 * j + i];
    }
}

} // namespace

// All lanes of a number stand side by side: loops over lanes are the innermost ones.

void BatchedPass::gatherSpokes()
{
  const Mesh& mesh = stars_.body.mesh;
  for (int spoke = 0; spoke <= batch_.cells; ++spoke)
    for (int lane = 0; lane < lanes_; ++lane) {
      const int end =
          spoke < batch_.cells ? Rings::next(corner(lane, spoke)) : Rings::previous(corner(lane, batch_.cells - 1));
      const double* from = mesh.point(mesh.cells[std::size_t(corner(lane, 0))]);
      const double* to = mesh.point(mesh.cells[std::size_t(end)]);
      for (int i = 0; i < 2; ++i)
        batch_.spokes[place(2 * spoke + i, lane)] = to[i] - from[i];
    }
}

void BatchedPass::gatherLaws()
{
  for (int c = 0; c < batch_.cells; ++c)
    for (int lane = 0; lane < lanes_; ++lane) {
      const auto& law = stars_.laws[std::size_t(stars_.body.laws.number(corner(lane, c) / 3))];
      for (int i = 0; i < 6; ++i)
        batch_.compliance[place(6 * c + i, lane)] = law.compliance[i];
    }
}

void BatchedPass::gatherStress()
{
  for (int k = 0; k < fields_; ++k) {
    const double* stress = inputs_->stress[std::size_t(k)].data();
    for (int c = 0; c < batch_.cells; ++c)
      for (int lane = 0; lane < lanes_; ++lane) {
        double* target = batch_.stress + place((k * batch_.cells + c) * 9, lane);
        const int here = corner(lane, c);
        for (const int vertex : {here, Rings::next(here), Rings::previous(here)})
          for (int i = 0; i < 3; ++i, target += lanes_)
            *target = stress[3 * std::ptrdiff_t(vertex) + i];
      }
  }
}

void BatchedPass::gatherBodyLoad()
{
  const int modes = batch_.loads->modes;
  for (int c = 0; c < batch_.cells; ++c)
    for (int lane = 0; lane < lanes_; ++lane) {
      const int here = corner(lane, c);
      const int rank = stars_.rings.rank(here), next = stars_.rings.rank(Rings::next(here));
      const double* share = stars_.data.cellShares.data() + (std::ptrdiff_t(here / 3) * 3 + rank) * 2 * modes;
      permute(stars_.permutations.of(rank, next), share, modes, lanes_, batch_.bodyLoad + place(2 * c * modes, lane));
    }
}

void BatchedPass::gatherTotals()
{
  const int loads = 2 * loadModesOf(stars_.data.degree), total = totalsPerCell(stars_.data.degree);
  const auto take = [this](const CornerFacet& facet, const double* tractions, double* target) {
    for (int i = 0; i < facetData_; ++i)
      target[std::ptrdiff_t(i) * lanes_] = facet.sign(i / 2) * tractions[facet.number * facetData_ + i];
  };
  for (int k = 0; k < fields_; ++k)
    for (int c = 0; c < batch_.cells; ++c)
      for (int lane = 0; lane < lanes_; ++lane) {
        const int here = corner(lane, c);
        const StressCorrection& correction = corrections_[std::size_t(k)];
        const double* tractions = correction.tractions.data() + std::ptrdiff_t(here / 3) * 3 * facetData_;
        double* target = batch_.total + place((k * batch_.cells + c) * total, lane);
        const CornerFacets facets = facetsOf(stars_.rings, here);
        take(facets.first, tractions, target);
        take(facets.second, tractions, target + std::ptrdiff_t(facetData_) * lanes_);
        take(facets.rim, tractions, target + (std::ptrdiff_t(2) * facetData_ + loads) * lanes_);
        const int rank = stars_.rings.rank(here), next = stars_.rings.rank(Rings::next(here));
        permute(stars_.permutations.of(rank, next), correction.loads.data() + std::ptrdiff_t(here / 3) * loads,
                loads / 2, lanes_, target + std::ptrdiff_t(2) * facetData_ * lanes_);
      }
}

void BatchedPass::scatter()
{
  for (int c = 0; c < batch_.cells; ++c)
    for (int lane = 0; lane < count_; ++lane) {
      const int here = corner(lane, c);
      const CornerFacets facets = facetsOf(stars_.rings, here);
      for (int k = 0; k < fields_; ++k) {
        double* tractions = corrections_[std::size_t(k)].tractions.data() + std::ptrdiff_t(here / 3) * 3 * facetData_;
        const double* source = batch_.tractions + place((k * batch_.cells + c) * 2 * facetData_, lane);
        for (const CornerFacet& facet : {facets.first, facets.second}) {
          double* target = tractions + std::ptrdiff_t(facet.number) * facetData_;
          for (int mode = 0; mode <= stars_.data.degree; ++mode, source += std::ptrdiff_t(2) * lanes_, target += 2) {
            const double sign = facet.sign(mode);
            target[0] += sign * source[0];
            target[1] += sign * source[lanes_];
          }
        }
      }
    }
}

/// Minus the vertex's shares of div sigma~ and of the body force.
void BatchedPass::addLoads()
{
  const int modes = loadModesOf(stars_.data.degree);
  for (int c = 0; c < batch_.cells; ++c)
    for (int lane = 0; lane < count_; ++lane) {
      const std::ptrdiff_t cell = corner(lane, c) / 3;
      const int rank = stars_.rings.rank(corner(lane, c));
      const double* share = stars_.loadShares.ofOne(rank);
      for (int k = 0; k < fields_; ++k) {
        const double* divergence = batch_.divergence + place((k * batch_.cells + c) * 2, lane);
        const double x = divergence[0], y = divergence[lanes_];
        double* loads = corrections_[std::size_t(k)].loads.data() + cell * 2 * modes;
        for (int mode = 0; mode < modes; ++mode) {
          loads[std::ptrdiff_t(2) * mode] -= share[mode] * x;
          loads[2 * mode + 1] -= share[mode] * y;
        }
        if (batch_.bodyLoad == nullptr)
          continue;
        const double* bodyLoad = stars_.data.cellShares.data() + (3 * cell + rank) * 2 * modes;
        for (int i = 0; i < 2 * modes; ++i)
          loads[i] -= bodyLoad[i];
      }
    }
}

} // namespace ndframe
