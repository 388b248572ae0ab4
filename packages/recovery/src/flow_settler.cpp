#include "flow_settler.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/equilibrium/settle_balance.hpp"
#include "ndframe/flow/flow_potentials.hpp"

namespace ndframe
{
namespace
{

constexpr int wrench = 6;
/// Supports that resist a motion by less than this, relative, do not resist it.
constexpr double noResistance = 1e-10;
constexpr double roundOff = 1e-14; ///< of the largest force in a star

} // namespace

FlowSettler::FlowSettler(int body, const StressFaces& faces, const BodyPiece* piece, const Comm& comm)
    : body_(body), faces_(faces), piece_(piece), mesh_(faces.cells().body(body).model().mesh),
      flow_(mesh_, piece, comm), about_(piece == nullptr ? cellCentre(mesh_, 0) : piece->centre),
      size_(piece == nullptr ? diameter(mesh_) : piece->extent)
{
  const StarBody& star = faces.cells().body(body);
  const auto modes = std::size_t(star.loadModes());
  loadArms_.reserve(std::size_t(mesh_.numCells()) * modes);
  for (int cell = 0; cell < mesh_.numCells(); ++cell) {
    const Vector arms =
        momentArms(star.cellMeans(), corners(mesh_, sortedCell(mesh_, cell), -1), centre(cell).data(), 3);
    for (std::size_t k = 0; k < modes; ++k)
      loadArms_.push_back({arms[3 * k], arms[3 * k + 1], arms[3 * k + 2]});
  }
}

/// What the loads of a cell have and its tractions lack, about the cell's centre.
Wrench FlowSettler::lack(int cell, const StressCorrection& correction) const
{
  const StarBody& star = faces_.cells().body(body_);
  Wrench sum{};
  const double* T = correction.tractions.data() + std::ptrdiff_t(cell) * star.reference().tractions;
  for (int facet = 0; facet < 4; ++facet, T += star.facetData()) {
    const Wrench has = face(cell, facet).wrench(T, centre(cell).data(), 1.0);
    for (std::size_t i = 0; i < has.size(); ++i)
      sum[i] -= has[i];
  }
  const auto modes = std::size_t(star.loadModes());
  const double* load = correction.loads.data() + std::ptrdiff_t(cell) * star.reference().loads;
  for (std::size_t i = 0; i < 3; ++i)
    sum[i] += load[i];
  for (std::size_t k = 0; k < modes; ++k, load += 3)
    addCross(loadArms_[std::size_t(cell) * modes + k], load, 1.0, &sum[3]);
  return sum;
}

/// Per cell of this rank, about its centre; zero at ghosts.
std::vector<Wrench> FlowSettler::lacks(const StressCorrection& correction) const
{
  std::vector<Wrench> result(std::size_t(mesh_.numCells()), Wrench{});
  for (int cell = 0; cell < mesh_.numCells(); ++cell)
    if (isOwn(cell))
      result[std::size_t(cell)] = lack(cell, correction);
  return result;
}

/// The data of tractions on a cell's facet.
double* FlowSettler::tractions(int cell, int facet, StressCorrection& correction) const
{
  return correction.tractions.data() + (std::ptrdiff_t(cell) * 4 + facet) * faces_.cells().facetData();
}

/// Supports take what each part of the body lacks in all: the smallest tractions that do.
void FlowSettler::react(std::vector<Wrench>& lacks, StressCorrection& correction, const Comm& comm) const
{
  constexpr std::size_t perPart = wrench + wrench * wrench; // what it lacks, and what its supports resist
  Vector sums(perPart * std::size_t(flow_.numParts()), 0.0);
  std::vector<Support> supports;
  for (int cell = 0; cell < mesh_.numCells(); ++cell) {
    if (!isOwn(cell))
      continue;
    const std::size_t part = perPart * std::size_t(flow_.partOf(cell));
    const Wrench moved = movedWrench(lacks[std::size_t(cell)], centre(cell), 1.0, about_, size_);
    std::transform(moved.begin(), moved.end(), sums.begin() + std::ptrdiff_t(part), sums.begin() + std::ptrdiff_t(part),
                   std::plus<>());
    for (int facet = 0; facet < 4; ++facet)
      if (const StressFace& own = face(cell, facet); own.isBoundary() && own.free->reach.cols() > 0) {
        supports.push_back({cell, facet, movedWrenches(own.free->reach, own.centre, own.size, about_, size_)});
        addSquare(supports.back().map, own.size * own.size, sums.data() + part + wrench, wrench);
      }
  }
  comm.sum(sums);
  std::vector<Vector> motions;
  for (std::size_t part = 0; part < sums.size(); part += perPart) {
    DenseMatrix resistance(wrench, wrench);
    std::copy_n(sums.data() + part + wrench, wrench * wrench, resistance.col(0));
    const Vector total(sums.data() + part, sums.data() + part + wrench);
    motions.push_back(multiply(pseudoInverse(resistance, noResistance), total));
  }
  for (const Support& support : supports)
    give(support, motions[std::size_t(flow_.partOf(support.cell))], lacks, correction);
}

/// The reactions of a support that resists a motion.
void FlowSettler::give(const Support& support, const Vector& motion, std::vector<Wrench>& lacks,
                       StressCorrection& correction) const
{
  const StressFace& own = face(support.cell, support.facet);
  Vector amounts(std::size_t(support.map.cols()), 0.0);
  Wrench taken{};
  for (int k = 0; k < support.map.cols(); ++k) {
    double& amount = amounts[std::size_t(k)];
    for (int i = 0; i < wrench; ++i)
      amount += own.size * own.size * support.map(i, k) * motion[std::size_t(i)];
    for (int i = 0; i < wrench; ++i)
      taken[std::size_t(i)] -= own.free->reach(i, k) * amount;
  }
  own.addCarried(amounts.data(), tractions(support.cell, support.facet, correction));
  taken = movedWrench(taken, own.centre, own.size, centre(support.cell), 1.0);
  for (std::size_t i = 0; i < taken.size(); ++i)
    lacks[std::size_t(support.cell)][i] += taken[i];
}

void FlowSettler::pass(std::vector<Wrench> lacks, StressCorrection& correction, const Comm& comm) const
{
  react(lacks, correction, comm);
  const std::vector<Wrench> through = flow_.through(lacks);
  const int first = faces_.cells().number(body_, 0), size = faces_.cells().facetData();
  for (int cell = 0; cell < mesh_.numCells(); ++cell)
    for (int facet = 0; facet < 4 && isOwn(cell); ++facet) {
      const StressFace& passed = face(cell, facet);
      const std::size_t side = passed.sideOf(first + cell);
      if (!passed.isInside() || (side == 1 && isOwn(passed.cell[0] - first)))
        continue;
      Wrench amounts = through[std::size_t(cell) * 4 + std::size_t(facet)];
      for (std::size_t i = 3; i < amounts.size(); ++i)
        amounts[i] /= passed.size;
      std::array<double, 18> T{}; // facet data at most
      passed.addCarried(amounts.data(), T.data());
      const auto add = [&](double* sum, double sign) {
        for (int i = 0; i < size; ++i)
          sum[i] += sign * T[std::size_t(i)];
      };
      add(tractions(cell, facet, correction), 1.0);
      if (const int other = passed.cell[1 - side] - first; isOwn(other))
        add(tractions(other, passed.facet[1 - side], correction), -1.0);
    }
}

/// The largest of what cells lack, moments over the size of the cell.
double FlowSettler::largestOf(const std::vector<Wrench>& lacks, const Comm& comm) const
{
  Vector largest{0.0};
  for (int cell = 0; cell < mesh_.numCells(); ++cell) {
    if (!isOwn(cell))
      continue;
    const double size = std::cbrt(cellMeasure(mesh_, cell));
    for (std::size_t i = 0; i < std::tuple_size_v<Wrench>; ++i)
      largest[0] = std::max(largest[0], std::abs(lacks[std::size_t(cell)][i]) / (i < 3 ? 1.0 : size));
  }
  takeLargest(largest, comm);
  return largest[0];
}

void FlowSettler::settle(StressCorrection& correction, const Comm& comm) const
{
  constexpr double less = 0.1; // else it is what nothing takes
  double before = 0.0;
  std::vector<Wrench> left = lacks(correction);
  do {
    before = correction.imbalance;
    pass(std::move(left), correction, comm);
    left = lacks(correction);
    correction.imbalance = largestOf(left, comm);
  } while (correction.imbalance > 0.0 && correction.imbalance < less * before &&
           correction.imbalance > roundOff * correction.force);
}

void settleByFlows(int body, const StressFaces& faces, const BodyPiece* piece, const BodyCorrections& corrections,
                   const Comm& comm)
{
  std::unique_ptr<FlowSettler> settler;
  for (StressCorrection* correction : corrections) {
    agreeOnImbalance(*correction, comm);
    if (!needsSettling(faces.cells().body(body).model().mesh, *correction, comm))
      continue;
    if (!settler)
      settler = std::make_unique<FlowSettler>(body, faces, piece, comm);
    settler->settle(*correction, comm);
  }
}

} // namespace ndframe
