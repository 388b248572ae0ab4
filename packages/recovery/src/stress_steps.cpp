#include <algorithm>
#include <optional>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/simd/block_kernels.hpp"
#include "pressure_room.hpp"
#include "step_gains.hpp"
#include "stress_descent.hpp"

namespace ndframe
{

/// The tractions of a batch's cells, per number and lane.
void StressDescent::gather(int batch, const Rounded& tractions, float* x) const
{
  constexpr std::size_t lanes = StressMatrices::lanes;
  const auto size = std::size_t(facetData()), count = std::size_t(matrices_.sizeOf(batch));
  std::array<std::array<float, 18>, lanes> turned{}; // facet data at most
  std::array<const float*, lanes> T;
  std::array<float, lanes> sign{};
  for (int facet = 0; facet < 4; ++facet, x += size * lanes) {
    T.fill(turned[0].data());
    for (std::size_t c = 0; c < count; ++c) {
      const StressFaces::Seat& seat = seats_[std::size_t(matrices_.cells(batch)[c]) * 4 + std::size_t(facet)];
      T[c] = tractions.data() + std::size_t(seat.face) * size;
      sign[c] = seat.sign;
      if (seat.sign != 0.0F)
        continue;
      std::array<double, 18> given{}, result{};
      std::copy_n(T[c], size, given.begin());
      (*faces_)[seat.face].toSide(1, given.data(), int(size), result.data());
      std::transform(result.begin(), result.end(), turned[c].begin(), [](double value) { return float(value); });
      T[c] = turned[c].data();
      sign[c] = 1.0F;
    }
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t c = 0; c < lanes; ++c)
        x[i * lanes + c] = sign[c] * T[c][i];
  }
}

/// unit A_E times the cells' tractions, per cell of this rank.
void StressDescent::cellForces(const Rounded& tractions, double unit, Rounded& result) const
{
  constexpr std::size_t lanes = StressMatrices::lanes;
  const auto size = std::size_t(facetData()) * 4;
  runInRanges(matrices_.numBatches(), threads_, [&](int first, int last) {
    std::array<float, StressMatrices::mostNumbers> x, forces;
    for (int batch = first; batch < last; ++batch) {
      gather(batch, tractions, x.data());
      matrices_.multiplyRounded(batch, unit, x.data(), forces.data());
      for (std::size_t c = 0; c < std::size_t(matrices_.sizeOf(batch)); ++c) {
        float* own = result.data() + std::size_t(matrices_.cells(batch)[c]) * size;
        for (std::size_t i = 0; i < size; ++i)
          own[i] = forces[i * lanes + c];
      }
    }
  });
}

/// What the cells' forces, over a unit, amount to on a face.
template <class Number>
void StressDescent::faceForces(int f, const std::vector<Number>& cellForces, double unit, double* sum) const
{
  const int size = facetData();
  const StressFace& face = (*faces_)[f];
  const auto forces = [&](std::size_t side) {
    return cellForces.data() + (std::ptrdiff_t(face.cell[side]) * 4 + face.facet[side]) * size;
  };
  if (face.turned.rows() > 0) {
    std::array<double, 18> other{}; // facet data at most
    std::copy_n(forces(0), size, sum);
    std::copy_n(forces(1), size, other.begin());
    face.fromSide(1, other.data(), size, sum);
  } else if (face.isBoundary())
    std::copy_n(forces(0), size, sum);
  else
    std::transform(forces(0), forces(0) + size, forces(1), sum,
                   [](Number own, Number other) { return double(own) - double(other); });
  for (int i = 0; i < size; ++i)
    sum[i] /= unit;
}

/// By the own unknowns, from what all ranks have of that by the faces' tractions; zero at those of other ranks. Summed
/// in double precision and rounded once, so that it is the same however cells are shared out.
void StressDescent::gradientOf(const StressUnknowns::FaceForces& ofFace, Vector& ofCarriers, Rounded& gradient) const
{
  if (comm_.size() == 1) {
    unknowns_.gradient(ofFace, threads_, ofCarriers, gradient);
    return;
  }
  Vector all;
  unknowns_.gradient(ofFace, threads_, ofCarriers, all);
  sharing_.values().add([this](int block) { return blocks_.placeOf(block); }, all);
  gradient.resize(all.size());
  std::transform(all.begin(), all.end(), gradient.begin(), [](double value) { return float(value); });
}

void StressDescent::fetch(Rounded& unknowns) const
{
  if (comm_.size() == 1)
    return;
  Vector copy(unknowns.begin(), unknowns.end());
  sharing_.values().fetch([this](int block) { return blocks_.placeOf(block); }, copy);
  std::transform(copy.begin(), copy.end(), unknowns.begin(), [](double value) { return float(value); });
}

double StressDescent::dotOfAll(const Rounded& a, const Rounded& b) const
{
  Vector sum{block_kernels::dotOf(a.data(), b.data(), a.size())};
  comm_.sum(sum);
  return sum.front();
}

/// Vectors of a field's steps.
struct StressDescent::Steps
{
  double force, traction;                      ///< units, of residuals and of directions
  Rounded residual, p, Ap, tractions, ofCells; ///< p, Ap: the direction and what the energy makes of it
  Vector ofCarriers, x;                        ///< forces on the faces' carriers; the sum of the steps
  std::vector<char> still;                     ///< blocks that are held
  double rz = 0.0;
  bool wasStopped = false; ///< the last one, where a facet in contact reached its limit
};

/// Residuals and directions are zero where another rank owns, but for directions that are about to be taken.
int StressDescent::lower(std::size_t number, const DescentEnd& end)
{
  const DescentField& field = fields_[number];
  if (end.most == 0 || isDone(number))
    return 0;
  std::optional<PressureRoom> room;
  if (field.traction != nullptr)
    room.emplace(*faces_, *contact_, *field.traction, comm_);
  Steps steps =
      begin(field, std::move(start_[number]), held(room ? room->held() : std::vector<char>(contact_->size(), 1)));
  const int taken = descend(steps, room ? &*room : nullptr, number, end);
  const Vector x = std::move(steps.x);
  const double unit = steps.traction;
  steps = {}; // its memory is needed again
  Vector ofPatches(field.traction == nullptr ? 0 : field.traction->shares.size(), 0.0);
  std::array<double, 18> T{}; // facet data at most
  for (int face = 0; face < faces_->size(); ++face) {
    unknowns_.tractionsOf(face, x, T.data());
    for (double& value : T)
      value *= unit;
    add(face, T.data(), field, ofPatches);
  }
  addPatches(ofPatches, field);
  return taken;
}

/// Takes steps until they gain too little; how many.
int StressDescent::descend(Steps& steps, PressureRoom* room, std::size_t field, const DescentEnd& end)
{
  Vector squares{energies_[field] + fields_[field].beside, fields_[field].enough};
  takeLargest(squares, comm_); // the same to the bit on all ranks, which have to end together
  StepGains gains(squares[0]);
  int taken = 0;
  while (taken < end.most && steps.rz > 0.0 && (!gains.areBelow(end.leastGain) || gains.willReach(squares[1]))) {
    const std::optional<double> lowered = take(steps, room);
    if (!lowered)
      break;
    gains.add(*lowered, steps.wasStopped);
    ++taken;
    watch_.stepIsTaken(gains.mean());
  }
  energies_[field] -= gains.lowered();
  return taken;
}

StressDescent::Steps StressDescent::begin(const DescentField& field, Vector start, std::vector<char> still) const
{
  Steps steps{};
  steps.force = sharing_.unitOf(largestEntry(start));
  steps.traction = steps.force * blocks_.unit();
  steps.still = std::move(still);
  gradientOf(
      [&](int face, double* forces) {
        faceForces(face, start, steps.force, forces);
        if (field.traction != nullptr)
          addOpening(face, *field.opening, steps.force, forces);
      },
      steps.ofCarriers, steps.residual);
  const std::size_t size = start.size();
  start = {}; // its memory is needed again
  for (float& value : steps.residual)
    value = -value;
  steps.ofCells.assign(size, 0.0F);
  steps.x.assign(steps.residual.size(), 0.0);
  blocks_.precondition(steps.residual, steps.still, threads_, steps.p);
  steps.rz = dotOfAll(steps.residual, steps.p);
  return steps;
}

/// What the step lowers the energy by; none where there was no step to take.
std::optional<double> StressDescent::take(Steps& steps, PressureRoom* room) const
{
  auto& [force, traction, residual, p, Ap, tractions, ofCells, ofCarriers, x, still, rz, wasStopped] = steps;
  fetch(p);
  unknowns_.tractions(p, threads_, tractions);
  cellForces(tractions, blocks_.unit(), ofCells);
  gradientOf([&](int face, double* forces) { faceForces(face, steps.ofCells, 1.0, forces); }, ofCarriers, Ap);
  const double curvature = dotOfAll(p, Ap);
  if (!(curvature > 0.0))
    return std::nullopt;
  const double wanted = rz / curvature;
  double length = wanted;
  if (room != nullptr)
    length = room->move([&](int face, double* T) { ofContact(face, steps, T); }, wanted);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] += length * double(p[i]);
    residual[i] -= float(length) * Ap[i];
  }
  wasStopped = length < wanted;
  if (wasStopped)
    still = held(room->held());
  Rounded& z = Ap; // not needed any more
  blocks_.precondition(residual, still, threads_, z);
  const double next = dotOfAll(residual, z);
  const auto kept = float(wasStopped ? 0.0 : next / rz);
  for (std::size_t i = 0; i < p.size(); ++i)
    p[i] = z[i] + kept * p[i];
  const double lowered = force * traction * length * (2.0 * rz - length * curvature);
  rz = next;
  return lowered;
}

/// The traction of a direction on a face in contact, in double precision, as x will have it.
void StressDescent::ofContact(int face, const Steps& steps, double* T) const
{
  unknowns_.tractionsOf(face, steps.p, T);
  for (int i = 0; i < facetData(); ++i)
    T[i] *= steps.traction;
}

} // namespace ndframe
