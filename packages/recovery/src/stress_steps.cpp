#include <algorithm>
#include <optional>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/simd/block_kernels.hpp"
#include "pressure_room.hpp"
#include "step_gains.hpp"
#include "stress_descent.hpp"

namespace ndframe
{

/// The tractions of a cell.
void StressDescent::gather(int cell, const Rounded& tractions, float* x) const
{
  const int size = facetData();
  for (int facet = 0; facet < 4; ++facet, x += size) {
    const auto [face, sign] = seats_[std::size_t(cell) * 4 + std::size_t(facet)];
    const float* T = tractions.data() + std::ptrdiff_t(face) * size;
    if (sign != 0.0F) {
      for (int i = 0; i < size; ++i)
        x[i] = sign * T[i];
      continue;
    }
    std::array<double, 18> given{}, result{}; // facet data at most
    std::copy_n(T, size, given.begin());
    (*faces_)[face].toSide(1, given.data(), size, result.data());
    std::transform(result.begin(), result.begin() + size, x, [](double value) { return float(value); });
  }
}

/// unit A_E times the cells' tractions, per cell of this rank.
void StressDescent::cellForces(const Rounded& tractions, double unit, Rounded& result) const
{
  const auto size = std::size_t(facetData()) * 4;
  runInRanges(matrices_.numBatches(), threads_, [&](int first, int last) {
    std::array<float, StressMatrices::mostNumbers> x, forces;
    for (int batch = first; batch < last; ++batch) {
      const int* cells = matrices_.cells(batch);
      const auto count = std::size_t(matrices_.sizeOf(batch));
      for (std::size_t c = 0; c < count; ++c)
        gather(cells[c], tractions, x.data() + c * size);
      matrices_.multiplyRounded(batch, unit, x.data(), forces.data());
      for (std::size_t c = 0; c < count; ++c)
        std::copy_n(forces.data() + c * size, size, result.data() + std::size_t(cells[c]) * size);
    }
  });
}

/// What the cells' forces, times a factor, amount to on a face.
void StressDescent::faceForces(int f, const Rounded& cellForces, double factor, double* sum) const
{
  const int size = facetData();
  constexpr std::size_t ahead = 12;
  if (std::size_t(f) + ahead < facets_.size()) {
    const auto [first, second] = facets_[std::size_t(f) + ahead];
    for (const int facet : {first, std::max(second, 0)}) {
      const float* soon = cellForces.data() + std::ptrdiff_t(facet) * size;
      __builtin_prefetch(soon);
      __builtin_prefetch(soon + size - 1);
    }
  }
  const auto [first, second] = facets_[std::size_t(f)];
  const float* own = cellForces.data() + std::ptrdiff_t(first) * size;
  if (second >= 0) {
    const float* other = cellForces.data() + std::ptrdiff_t(second) * size;
    for (int i = 0; i < size; ++i)
      sum[i] = factor * (double(own[i]) - double(other[i]));
    return;
  }
  for (int i = 0; i < size; ++i)
    sum[i] = factor * double(own[i]);
  if (second != Facets::turned)
    return;
  const StressFace& face = (*faces_)[f];
  const float* theirs = cellForces.data() + (std::ptrdiff_t(face.cell[1]) * 4 + face.facet[1]) * size;
  std::array<double, 18> other{}; // facet data at most
  std::transform(theirs, theirs + size, other.begin(), [factor](float value) { return factor * double(value); });
  face.fromSide(1, other.data(), size, sum);
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
  Steps steps = begin(number, held(room ? room->held() : std::vector<char>(contact_->size(), 1)));
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

/// The start becomes room for the forces of cells.
StressDescent::Steps StressDescent::begin(std::size_t number, std::vector<char> still)
{
  const DescentField& field = fields_[number];
  Steps steps{};
  steps.ofCells = std::move(start_[number]);
  double largest = 0.0;
  for (const float value : steps.ofCells)
    largest = std::max(largest, std::abs(double(value)));
  steps.force = sharing_.unitOf(largest * startUnits_[number]);
  steps.traction = steps.force * blocks_.unit();
  steps.still = std::move(still);
  const double factor = startUnits_[number] / steps.force;
  gradientOf(
      [&](int face, double* forces) {
        faceForces(face, steps.ofCells, factor, forces);
        if (field.traction != nullptr)
          addOpening(face, *field.opening, steps.force, forces);
      },
      steps.ofCarriers, steps.residual);
  for (float& value : steps.residual)
    value = -value;
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
