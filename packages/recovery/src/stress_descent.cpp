#include "stress_descent.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ndframe/admissibility/contact_moments.hpp"
#include "ndframe/algebra/threads.hpp"
#include "pressure_room.hpp"

namespace ndframe
{

StressDescent::StressDescent(const StressFaces& faces, const std::vector<ContactPatch>& contact,
                             std::vector<DescentField> fields, const DescentWatch& watch, const Comm& comm, int threads)
    : faces_(&faces), contact_(&contact), fields_(std::move(fields)), watch_(watch), comm_(comm), threads_(threads),
      seats_(faces.seats()), edges_(stressEdges(faces)), sharing_(faces, edges_, comm), ofClasses_(faces.cells()),
      blocks_(faces, edges_, ofClasses_), unknowns_(faces, edges_, blocks_), matrices_(faces.cells(), ofClasses_)
{
  listFacets();
  for (const DescentField& field : fields_) {
    if (field.traction != nullptr) {
      Vector ofPatches(field.traction->shares.size(), 0.0);
      for (const FaceTraction& change : interiorChange(faces, contact, *field.traction))
        add(change.face, change.T.data(), field, ofPatches);
      addPatches(ofPatches, field);
    }
    start_.emplace_back(std::size_t(faces.cells().size()) * 4 * std::size_t(facetData()), 0.0F);
    startUnits_.push_back(0.0);
    batches_.emplace_back(std::size_t(matrices_.numBatches()));
  }
  findMatrices();
  for (std::size_t f = 0; f < fields_.size(); ++f)
    energies_.push_back(startEnergy(f));
  blocks_.invert(sharing_, threads);
}

std::array<std::int64_t, 2> StressDescent::numMatrices() const
{
  std::int64_t cells = 0;
  for (int batch = 0; batch < matrices_.numBatches(); ++batch)
    if (!matrices_.isOfClass(batch))
      cells += matrices_.sizeOf(batch);
  Vector most{double(ofClasses_.size() + cells)};
  takeLargest(most, comm_);
  return {comm_.sum(ofClasses_.numOwn() + cells), std::int64_t(most.front())};
}

void StressDescent::listFacets()
{
  facets_.reserve(std::size_t(faces_->size()));
  for (const StressFace& face : faces_->all())
    facets_.push_back({face.cell[0] * 4 + face.facet[0], face.turned.rows() > 0 ? Facets::turned
                                                         : face.isBoundary()    ? -1
                                                                                : face.cell[1] * 4 + face.facet[1]});
}

/// Those of this rank.
void StressDescent::findMatrices()
{
  constexpr int together = 16; // batches of which is kept what is then added in order
  constexpr std::size_t lanes = StressMatrices::lanes;
  Vector forces(startSize() * std::size_t(together));
  for (int first = 0; first < matrices_.numBatches(); first += together) {
    const int last = std::min(first + together, matrices_.numBatches());
    std::array<Vector, std::size_t(together) * lanes> parts;
    runInRanges(last - first, threads_, [&](int from, int to) {
      CellBlocks work(*faces_);
      Vector space;
      for (int i = from; i < to; ++i)
        findMatrices(first + i, work, space, parts.data() + std::size_t(i) * lanes,
                     forces.data() + std::size_t(i) * startSize());
    });
    for (int batch = first; batch < last; ++batch) {
      for (int c = 0; c < matrices_.sizeOf(batch); ++c)
        blocks_.add(matrices_.cells(batch)[c], parts[std::size_t(batch - first) * lanes + std::size_t(c)]);
      keepStart(batch, forces.data() + std::size_t(batch - first) * startSize());
    }
  }
}

/// Of one batch, its parts of blocks per lane, and the start.
void StressDescent::findMatrices(int batch, CellBlocks& work, Vector& space, Vector* parts, double* forces)
{
  const int* cells = matrices_.cells(batch);
  const int count = matrices_.sizeOf(batch);
  if (matrices_.isOfClass(batch)) {
    for (int c = 0; c < count; ++c)
      parts[c] = blocks_.partsOfClass(cells[c]);
    findStart(
        batch, [&](const double* x, double* result) { matrices_.multiplyData(batch, x, result); }, forces);
  } else
    matrices_.find(batch, space, [&](const CellFacets& found) {
      work.compute(found);
      for (int c = 0; c < count; ++c)
        parts[c] = blocks_.parts(work, c, cells[c]);
      findStart(
          batch, [&](const double* x, double* result) { matrices_.multiplyData(found, x, result); }, forces);
    });
  for (int c = 0; c < count; ++c)
    watch_.cellIsRead();
}

/// A_E x_E of all fields' corrections in a batch's cells, per field, number and lane; multiply(x, forces) per number
/// and lane.
void StressDescent::findStart(int batch, const std::function<void(const double*, double*)>& multiply, double* forces)
{
  constexpr std::size_t lanes = StressMatrices::lanes;
  const int* cells = matrices_.cells(batch);
  const int count = matrices_.sizeOf(batch);
  const ReferenceStress& reference = faces_->cells().any().reference();
  const auto tractions = std::size_t(reference.tractions), loads = std::size_t(reference.loads);
  for (std::size_t f = 0; f < fields_.size(); ++f, forces += StressMatrices::mostNumbers) {
    std::array<double, StressMatrices::mostNumbers> x{};
    for (std::size_t c = 0; c < std::size_t(count); ++c) {
      const int body = faces_->cells().bodyOf(cells[c]);
      const auto cell = std::size_t(cells[c] - faces_->cells().number(body, 0));
      const StressCorrection& correction = *fields_[f].corrections[std::size_t(body)];
      for (std::size_t i = 0; i < tractions; ++i)
        x[i * lanes + c] = correction.tractions[cell * tractions + i];
      for (std::size_t i = 0; i < loads; ++i)
        x[(tractions + i) * lanes + c] = correction.loads[cell * loads + i];
    }
    const std::size_t used = (tractions + loads) * lanes;
    multiply(x.data(), forces);
    const auto bySize = [](double a, double b) { return std::abs(a) < std::abs(b); };
    batches_[f][std::size_t(batch)] = {std::inner_product(x.begin(), x.begin() + std::ptrdiff_t(used), forces, 0.0),
                                       std::abs(*std::max_element(x.begin(), x.end(), bySize))};
  }
}

/// Rounds what findStart() has found. Units follow from the first cells that have anything, and rise where others have
/// far more: single precision has room for 1e38 of them.
void StressDescent::keepStart(int batch, const double* forces)
{
  constexpr std::size_t lanes = StressMatrices::lanes;
  constexpr double room = 1e20;
  const std::size_t tractions = std::size_t(facetData()) * 4;
  for (std::size_t f = 0; f < fields_.size(); ++f, forces += StressMatrices::mostNumbers) {
    double largest = 0.0;
    for (std::size_t i = 0; i < tractions * lanes; ++i)
      largest = std::max(largest, std::abs(forces[i]));
    double& unit = startUnits_[f];
    if (largest > room * unit) {
      const double raised = powerOfTwo(largest);
      if (unit > 0.0)
        for (float& value : start_[f])
          value = float(value * (unit / raised));
      unit = raised;
    }
    const double factor = unit > 0.0 ? 1.0 / unit : 0.0;
    for (std::size_t c = 0; c < std::size_t(matrices_.sizeOf(batch)); ++c) {
      float* own = start_[f].data() + std::size_t(matrices_.cells(batch)[c]) * tractions;
      for (std::size_t i = 0; i < tractions; ++i)
        own[i] = float(forces[i * lanes + c] * factor);
    }
  }
}

/// sum x_E^T A_E x_E of all ranks' cells, and 2 int t^ w.
double StressDescent::startEnergy(std::size_t field) const
{
  Vector sum{0.0};
  for (const Start& start : batches_[field])
    sum.front() += start.energy;
  comm_.sum(sum);
  if (fields_[field].traction == nullptr)
    return sum.front();
  const Vector contact = contactContributions(*contact_, *fields_[field].traction, *fields_[field].opening);
  return std::accumulate(contact.begin(), contact.end(), sum.front());
}

/// Half the derivative of 2 int t^ w by the traction of a face in contact, over a unit.
void StressDescent::addOpening(int f, const Vector& opening, double unit, double* forces) const
{
  const int number = (*faces_)[f].contact;
  if (number < 0 || !sharing_.owns(f))
    return;
  const auto modes = std::size_t(facetData()) / 3;
  const ContactPatch& patch = (*contact_)[std::size_t(number)];
  for (std::size_t k = 0; k < modes; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      forces[3 * k + i] += patch.normal[i] * opening[std::size_t(number) * modes + k] / patch.measure / unit;
}

/// The blocks of StressBlocks that stay as they are with these patches held, and those of other ranks.
std::vector<char> StressDescent::held(const std::vector<char>& patches) const
{
  std::vector<char> blocks(std::size_t(blocks_.numBlocks()), 0);
  const auto isHeld = [&](int face) {
    const int number = (*faces_)[face].contact;
    return number >= 0 && patches[std::size_t(number)] != 0;
  };
  for (int b = 0; b < blocks_.numBlocks(); ++b)
    blocks[std::size_t(b)] = char(!sharing_.owns(b) || (b < faces_->size() && isHeld(b)));
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (const StressEdge::Step& step : edges_[e].ring)
      if (isHeld(step.face))
        blocks[std::size_t(faces_->size()) + e] = 1;
  return blocks;
}

int StressDescent::lower(const DescentEnd& end)
{
  int steps = 0;
  for (std::size_t f = 0; f < fields_.size(); ++f)
    steps += lower(f, end);
  return steps;
}

/// Whether the data of all corrections are round-off of the forces.
bool StressDescent::isDone(std::size_t field) const
{
  constexpr double roundOff = 1e-12;
  Vector largest{0.0, 0.0}; // of data, of forces
  for (const Start& start : batches_[field])
    largest[0] = std::max(largest[0], start.largest);
  for (const StressCorrection* correction : fields_[field].corrections)
    largest[1] = std::max(largest[1], correction->force);
  takeLargest(largest, comm_);
  return largest[0] <= roundOff * largest[1];
}

/// Adds the normal part of a face's traction to the change of a patch's, in equal shares.
void StressDescent::addNormal(std::size_t patch, const double* T, const ContactTraction& traction, Vector& change) const
{
  const Vector moments = normalMoments((*contact_)[patch], T, traction.numModes());
  for (std::size_t vertex = 0; vertex < 3; ++vertex)
    for (std::size_t k = 0; k < moments.size(); ++k)
      change[traction.first(patch, vertex) + k] += moments[k] / 3.0;
}

/// Adds a face's traction to a field, but not yet to its traction in contact.
void StressDescent::add(int f, const double* change, const DescentField& field, Vector& ofPatches) const
{
  const int size = facetData();
  const StressCells& cells = faces_->cells();
  const StressFace& face = (*faces_)[f];
  std::array<double, 18> T{}; // facet data at most
  for (std::size_t side = 0; side < 2 && face.cell[side] >= 0; ++side) {
    const int body = cells.bodyOf(face.cell[side]), cell = face.cell[side] - cells.number(body, 0);
    double* sum =
        field.corrections[std::size_t(body)]->tractions.data() + (std::ptrdiff_t(cell) * 4 + face.facet[side]) * size;
    const double* own = change;
    double sign = sideSign(side);
    if (side == 1 && face.turned.rows() > 0) {
      face.toSide(side, change, size, T.data());
      own = T.data();
      sign = 1.0;
    }
    for (int i = 0; i < size; ++i)
      sum[i] += sign * own[i];
  }
  if (field.traction != nullptr && face.contact >= 0 && sharing_.owns(f))
    addNormal(std::size_t(face.contact), change, *field.traction, ofPatches);
}

void StressDescent::addPatches(Vector& ofPatches, const DescentField& field) const
{
  comm_.sum(ofPatches);
  for (std::size_t i = 0; i < ofPatches.size(); ++i)
    field.traction->shares[i] += ofPatches[i];
}

} // namespace ndframe
