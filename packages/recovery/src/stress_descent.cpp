#include "stress_descent.hpp"

#include <algorithm>
#include <optional>

#include "ndframe/algebra/threads.hpp"
#include "pressure_room.hpp"

namespace ndframe
{

StressDescent::StressDescent(const StressFaces& faces, const std::vector<ContactPatch>& contact,
                             std::vector<DescentField> fields, const DescentWatch& watch, const Comm& comm, int threads)
    : faces_(&faces), contact_(&contact), fields_(std::move(fields)), watch_(watch), comm_(comm), threads_(threads),
      edges_(stressEdges(faces)), blocks_(faces, edges_), unknowns_(faces, edges_, blocks_)
{
  const StressCells& cells = faces.cells();
  for (const DescentField& field : fields_) {
    if (field.traction != nullptr)
      add(interiorChange(faces, contact, *field.traction), field);
    start_.emplace_back(std::size_t(cells.size()) * 4 * std::size_t(facetData()), 0.0);
  }
  for (int body = 0; body < cells.numBodies(); ++body) {
    matrices_.push_back(nullptr);
    if (cells.has(body))
      findMatrices(body);
  }
  blocks_.invert(comm, threads);
}

/// Those of this rank.
void StressDescent::findMatrices(int body)
{
  constexpr int together = 32; // batches whose parts of blocks are kept until they are added in order
  const StressCells& cells = faces_->cells();
  const std::int64_t batches = StressMatrices::numBatches(cells.body(body));
  matrices_.back() = std::make_unique<StressMatrices>(cells.body(body), int(batches * comm_.rank() / comm_.size()),
                                                      int(batches * (comm_.rank() + 1) / comm_.size()));
  StressMatrices& matrices = *matrices_.back();
  for (int first = matrices.first(); first < matrices.last(); first += together) {
    const int last = std::min(first + together, matrices.last());
    std::array<Vector, std::size_t(together) * StressMatrices::lanes> parts;
    const int begin = first * StressMatrices::lanes;
    runInRanges(last - first, threads_, [&](int from, int to) {
      CellBlocks work(facetData());
      matrices.find(first + from, first + to, [&](const CellMatrices& found) {
        auto own = blocks_.parts(cells.number(body, found.cell), found, work);
        std::move(own.begin(), own.end(), parts.begin() + (found.cell - begin));
        addStart(body, found);
        for (int c = 0; c < found.count; ++c)
          watch_.cellIsRead();
      });
    });
    for (std::size_t c = 0; c < parts.size() && !parts[c].empty(); ++c)
      blocks_.add(cells.number(body, begin + int(c)), parts[c]);
  }
}

/// A_E x_E of all fields' corrections.
void StressDescent::addStart(int body, const CellMatrices& found)
{
  constexpr std::size_t lanes = CellForms::lanes;
  const int tractions = faces_->cells().any().reference().tractions, size = found.size, loads = size - tractions;
  Vector x(std::size_t(size) * lanes), forces, own(x.size() / lanes);
  for (std::size_t f = 0; f < fields_.size(); ++f) {
    const StressCorrection& correction = *fields_[f].corrections[std::size_t(body)];
    for (int c = 0; c < found.count; ++c) {
      const std::ptrdiff_t cell = found.cell + c;
      std::copy_n(correction.tractions.data() + cell * tractions, tractions, own.data());
      std::copy_n(correction.loads.data() + cell * loads, loads, own.data() + tractions);
      for (int at = 0; at < size; at += 3) {
        double local[3];
        pullBack(found.maps[c], own.data() + at, local);
        for (int i = 0; i < 3; ++i)
          x[std::size_t(at + i) * lanes + std::size_t(c)] = local[i];
      }
    }
    forces.assign(x.size(), 0.0);
    found.multiply(x.data(), forces.data());
    for (int c = 0; c < found.count; ++c) {
      for (int i = 0; i < tractions; ++i)
        own[std::size_t(i)] = forces[std::size_t(i) * lanes + std::size_t(c)];
      addPushed(found.maps[c], own.data(), tractions,
                start_[f].data() + std::ptrdiff_t(faces_->cells().number(body, found.cell + c)) * tractions);
    }
  }
}

/// A_E times the cells' tractions, per cell; zero at those of other ranks.
Vector StressDescent::cellForces(const Vector& tractions) const
{
  const StressCells& cells = faces_->cells();
  const int size = facetData();
  Vector forces(std::size_t(cells.size()) * 4 * std::size_t(size));
  const auto multiply = [&](int body, int batch) {
    const int first = cells.number(body, batch * StressMatrices::lanes);
    std::array<double, std::size_t(72) * StressMatrices::lanes> T{}; // of degree 2
    double* to = T.data();
    for (int cell = first; cell < first + matrices_[std::size_t(body)]->sizeOf(batch); ++cell)
      for (int facet = 0; facet < 4; ++facet, to += size) {
        const int f = faces_->of(cell, facet);
        const StressFace& face = (*faces_)[f];
        face.toSide(face.sideOf(cell), tractions.data() + std::ptrdiff_t(f) * size, size, to);
      }
    matrices_[std::size_t(body)]->multiply(batch, T.data(), forces.data() + std::ptrdiff_t(4) * first * size);
  };
  for (int body = 0; body < cells.numBodies(); ++body)
    if (cells.has(body)) {
      const int begin = matrices_[std::size_t(body)]->first(), count = matrices_[std::size_t(body)]->last() - begin;
      runInRanges(count, threads_, [&](int first, int last) {
        for (int batch = begin + first; batch < begin + last; ++batch)
          multiply(body, batch);
      });
    }
  return forces;
}

/// What the cells' forces amount to on every face.
Vector StressDescent::faceForces(const Vector& cellForces) const
{
  const int size = facetData();
  Vector result(std::size_t(faces_->size()) * std::size_t(size), 0.0);
  runInRanges(faces_->size(), threads_, [&](int first, int last) {
    for (int f = first; f < last; ++f) {
      const StressFace& face = (*faces_)[f];
      for (std::size_t side = 0; side < 2 && face.cell[side] >= 0; ++side)
        face.fromSide(side, cellForces.data() + (std::ptrdiff_t(face.cell[side]) * 4 + face.facet[side]) * size, size,
                      result.data() + std::ptrdiff_t(f) * size);
    }
  });
  return result;
}

/// By the unknowns, from what all ranks have of that by the faces' tractions.
Vector StressDescent::gradientOf(const Vector& faceForces) const
{
  Vector gradient = unknowns_.gradient(faceForces, threads_);
  comm_.sum(gradient);
  return gradient;
}

/// Half the derivative of 2 int t^ w by the tractions of faces in contact.
void StressDescent::addOpening(const Vector& opening, Vector& faceForces) const
{
  const auto modes = std::size_t(facetData()) / 3;
  for (int f = 0; f < faces_->size(); ++f)
    if (const int number = (*faces_)[f].contact; number >= 0) {
      const ContactPatch& patch = (*contact_)[std::size_t(number)];
      for (std::size_t k = 0; k < modes; ++k)
        for (std::size_t i = 0; i < 3; ++i)
          faceForces[(std::size_t(f) * modes + k) * 3 + i] +=
              patch.normal[i] * opening[std::size_t(number) * modes + k] / patch.measure;
    }
}

/// The blocks of StressBlocks that stay as they are with these patches held.
std::vector<char> StressDescent::held(const std::vector<char>& patches) const
{
  std::vector<char> blocks(std::size_t(blocks_.numBlocks()), 0);
  const auto isHeld = [&](int face) {
    const int number = (*faces_)[face].contact;
    return number >= 0 && patches[std::size_t(number)] != 0;
  };
  for (int f = 0; f < faces_->size(); ++f)
    blocks[std::size_t(f)] = char(isHeld(f));
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (const StressEdge::Step& step : edges_[e].ring)
      if (isHeld(step.face))
        blocks[std::size_t(faces_->size()) + e] = 1;
  return blocks;
}

void StressDescent::lower(int steps)
{
  for (std::size_t f = 0; f < fields_.size(); ++f) {
    Vector forces = faceForces(start_[f]);
    start_[f] = Vector();
    if (fields_[f].traction != nullptr && comm_.rank() == 0) // the ranks' forces are added up
      addOpening(*fields_[f].opening, forces);
    Vector residual = gradientOf(forces);
    for (double& value : residual)
      value = -value;
    lower(fields_[f], std::move(residual), steps);
  }
}

void StressDescent::lower(const DescentField& field, Vector residual, int steps) const
{
  std::optional<PressureRoom> room;
  if (field.traction != nullptr)
    room.emplace(*faces_, *contact_, *field.traction);
  std::vector<char> still = held(room ? room->held() : std::vector<char>(contact_->size(), 1));
  Vector z = blocks_.precondition(residual, still, threads_), p = z, x(residual.size(), 0.0);
  double rz = dot(residual, z);
  for (int step = 0; step < steps && rz > 0.0; ++step) {
    const Vector tractions = unknowns_.tractions(p, threads_), Ap = gradientOf(faceForces(cellForces(tractions)));
    const double curvature = dot(p, Ap);
    if (!(curvature > 0.0))
      break;
    const double wanted = rz / curvature, length = room ? room->move(tractions, wanted) : wanted;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += length * p[i];
      residual[i] -= length * Ap[i];
    }
    if (length < wanted)
      still = held(room->held());
    z = blocks_.precondition(residual, still, threads_);
    const double next = dot(residual, z), kept = length < wanted ? 0.0 : next / rz;
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = z[i] + kept * p[i];
    rz = next;
    watch_.stepIsTaken();
  }
  add(unknowns_.tractions(x, threads_), field);
}

/// Adds the normal part of a face's traction to a patch, in equal shares.
void StressDescent::addNormal(std::size_t patch, const double* T, ContactTraction& traction) const
{
  const Vector moments = normalMoments((*contact_)[patch], T, traction.numModes());
  for (std::size_t vertex = 0; vertex < 3; ++vertex)
    for (std::size_t k = 0; k < moments.size(); ++k)
      traction.shares[traction.first(patch, vertex) + k] += moments[k] / 3.0;
}

/// Adds tractions of faces to a field.
void StressDescent::add(const Vector& tractions, const DescentField& field) const
{
  const int size = facetData();
  const StressCells& cells = faces_->cells();
  std::array<double, 18> T{}; // facet data at most
  for (int f = 0; f < faces_->size(); ++f) {
    const StressFace& face = (*faces_)[f];
    const double* change = tractions.data() + std::ptrdiff_t(f) * size;
    for (std::size_t side = 0; side < 2 && face.cell[side] >= 0; ++side) {
      const int body = cells.bodyOf(face.cell[side]), cell = face.cell[side] - cells.number(body, 0);
      face.toSide(side, change, size, T.data());
      double* sum =
          field.corrections[std::size_t(body)]->tractions.data() + (std::ptrdiff_t(cell) * 4 + face.facet[side]) * size;
      for (int i = 0; i < size; ++i)
        sum[i] += T[std::size_t(i)];
    }
    if (field.traction != nullptr && face.contact >= 0)
      addNormal(std::size_t(face.contact), change, *field.traction);
  }
}

} // namespace ndframe
