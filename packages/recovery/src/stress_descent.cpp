#include "stress_descent.hpp"

#include <algorithm>
#include <optional>

#include "pressure_room.hpp"

namespace ndframe
{

StressDescent::StressDescent(const StressFaces& faces, const std::vector<ContactFacet>& contact)
    : faces_(&faces), contact_(&contact), edges_(stressEdges(faces)), blocks_(faces, edges_)
{
  const StressCells& cells = faces.cells();
  for (int body = 0; body < cells.numBodies(); ++body) {
    const auto add = [&](int cell, const DenseMatrix& A) { blocks_.add(cells.number(body, cell), A); };
    matrices_.push_back(cells.has(body) ? std::make_unique<StressMatrices>(cells.body(body), add) : nullptr);
  }
  blocks_.invert();
}

/// T per face, on its first cell.
Vector StressDescent::faceTractions(const Vector& unknowns) const
{
  const int size = facetData();
  Vector tractions(std::size_t(faces_->size()) * std::size_t(size), 0.0);
  const auto add = [&](int f, const DenseMatrix& columns, const double* amounts) {
    double* T = tractions.data() + std::ptrdiff_t(f) * size;
    for (int k = 0; k < columns.cols(); ++k)
      for (int i = 0; i < size; ++i)
        T[i] += columns(i, k) * amounts[k];
  };
  for (int f = 0; f < faces_->size(); ++f)
    add(f, (*faces_)[f].own, unknowns.data() + blocks_.ofFace(f));
  std::vector<Wrench> amounts(std::size_t(faces_->size()), Wrench{}); // of the carriers
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const StressEdge& edge = edges_[e];
    const double* z = unknowns.data() + blocks_.ofEdge(e);
    for (const StressEdge::Step& step : edge.ring)
      for (int k = 0; k < step.through.cols(); ++k)
        for (int i = 0; i < step.through.rows(); ++i)
          amounts[std::size_t(step.face)][std::size_t(i)] += step.through(i, k) * z[k];
  }
  for (int f = 0; f < faces_->size(); ++f)
    add(f, (*faces_)[f].carrier, amounts[std::size_t(f)].data());
  return tractions;
}

/// A_E times the cells' tractions, per cell.
Vector StressDescent::cellForces(const Vector& tractions) const
{
  const StressCells& cells = faces_->cells();
  const int size = facetData();
  Vector forces(std::size_t(cells.size()) * 4 * std::size_t(size)), x(4 * std::size_t(size), 0.0);
  for (int body = 0; body < cells.numBodies(); ++body)
    for (int c = 0; cells.has(body) && c < cells.body(body).model().mesh.numCells(); ++c) {
      const int cell = cells.number(body, c);
      for (int facet = 0; facet < 4; ++facet) {
        const int f = faces_->of(cell, facet);
        const StressFace& face = (*faces_)[f];
        face.toSide(face.sideOf(cell), tractions.data() + std::ptrdiff_t(f) * size, size,
                    x.data() + std::ptrdiff_t(facet) * size);
      }
      matrices_[std::size_t(body)]->multiply(c, x.data(), 4 * size, forces.data() + std::ptrdiff_t(4) * cell * size);
    }
  return forces;
}

/// What the cells' forces amount to on every face.
Vector StressDescent::faceForces(const Vector& cellForces) const
{
  const int size = facetData();
  Vector result(std::size_t(faces_->size()) * std::size_t(size), 0.0);
  for (int f = 0; f < faces_->size(); ++f) {
    const StressFace& face = (*faces_)[f];
    for (std::size_t side = 0; side < 2 && face.cell[side] >= 0; ++side)
      face.fromSide(side, cellForces.data() + (std::ptrdiff_t(face.cell[side]) * 4 + face.facet[side]) * size, size,
                    result.data() + std::ptrdiff_t(f) * size);
  }
  return result;
}

/// By the unknowns, from that by the faces' tractions.
Vector StressDescent::gradientOf(const Vector& faceForces) const
{
  const int size = facetData();
  Vector gradient(std::size_t(blocks_.size()), 0.0), ofCarriers;
  std::vector<std::size_t> firstCarrier{0};
  for (int f = 0; f < faces_->size(); ++f) {
    const StressFace& face = (*faces_)[f];
    const double* G = faceForces.data() + std::ptrdiff_t(f) * size;
    for (int k = 0; k < face.own.cols(); ++k)
      for (int i = 0; i < size; ++i)
        gradient[std::size_t(blocks_.ofFace(f)) + std::size_t(k)] += face.own(i, k) * G[i];
    for (int k = 0; k < face.carrier.cols(); ++k) {
      ofCarriers.push_back(0.0);
      for (int i = 0; i < size; ++i)
        ofCarriers.back() += face.carrier(i, k) * G[i];
    }
    firstCarrier.push_back(ofCarriers.size());
  }
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const StressEdge& edge = edges_[e];
    double* of = gradient.data() + blocks_.ofEdge(e);
    for (const StressEdge::Step& step : edge.ring) {
      const double* amounts = ofCarriers.data() + firstCarrier[std::size_t(step.face)];
      for (int k = 0; k < step.through.cols(); ++k)
        for (int i = 0; i < step.through.rows(); ++i)
          of[k] += step.through(i, k) * amounts[i];
    }
  }
  return gradient;
}

/// A_E x_E of a field's corrections.
Vector StressDescent::startForces(const DescentField& field) const
{
  const StressCells& cells = faces_->cells();
  const ReferenceStress& reference = cells.any().reference();
  const int tractions = reference.tractions, loads = reference.loads;
  Vector forces(std::size_t(cells.size()) * std::size_t(tractions), 0.0), x(std::size_t(tractions + loads), 0.0);
  for (int body = 0; body < cells.numBodies(); ++body)
    for (int c = 0; cells.has(body) && c < cells.body(body).model().mesh.numCells(); ++c) {
      const StressCorrection& correction = *field.corrections[std::size_t(body)];
      std::copy_n(correction.tractions.data() + std::ptrdiff_t(c) * tractions, tractions, x.begin());
      std::copy_n(correction.loads.data() + std::ptrdiff_t(c) * loads, loads, x.begin() + tractions);
      matrices_[std::size_t(body)]->multiply(c, x.data(), tractions + loads,
                                             forces.data() + std::ptrdiff_t(cells.number(body, c)) * tractions);
    }
  return forces;
}

/// Half the derivative of 2 int t^ w by the tractions of faces in contact.
void StressDescent::addOpening(const Vector& opening, Vector& faceForces) const
{
  const auto modes = std::size_t(facetData()) / 3;
  for (int f = 0; f < faces_->size(); ++f)
    if (const int number = (*faces_)[f].contact; number >= 0) {
      const ContactFacet& facet = (*contact_)[std::size_t(number)];
      for (std::size_t k = 0; k < modes; ++k)
        for (std::size_t i = 0; i < 3; ++i)
          faceForces[(std::size_t(f) * modes + k) * 3 + i] +=
              facet.normal[i] * opening[std::size_t(number) * modes + k] / facet.measure;
    }
}

/// The blocks of StressBlocks that stay as they are with these contact facets.
std::vector<char> StressDescent::held(const std::vector<char>& facets) const
{
  std::vector<char> blocks(std::size_t(blocks_.numBlocks()), 0);
  const auto isHeld = [&](int face) {
    const int number = (*faces_)[face].contact;
    return number >= 0 && facets[std::size_t(number)] != 0;
  };
  for (int f = 0; f < faces_->size(); ++f)
    blocks[std::size_t(f)] = char(isHeld(f));
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (const StressEdge::Step& step : edges_[e].ring)
      if (isHeld(step.face))
        blocks[std::size_t(faces_->size()) + e] = 1;
  return blocks;
}

void StressDescent::lower(const DescentField& field, int steps) const
{
  std::optional<PressureRoom> room;
  if (field.traction != nullptr) {
    add(interiorChange(*faces_, *contact_, *field.traction), field);
    room.emplace(*faces_, *contact_, *field.traction);
  }
  Vector residual = faceForces(startForces(field));
  if (room)
    addOpening(*field.opening, residual);
  residual = gradientOf(residual);
  for (double& value : residual)
    value = -value;
  std::vector<char> still = held(room ? room->held() : std::vector<char>(contact_->size(), 1));
  Vector z = blocks_.precondition(residual, still), p = z, x(residual.size(), 0.0);
  double rz = dot(residual, z);
  for (int step = 0; step < steps && rz > 0.0; ++step) {
    const Vector tractions = faceTractions(p), Ap = gradientOf(faceForces(cellForces(tractions)));
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
    z = blocks_.precondition(residual, still);
    const double next = dot(residual, z), kept = length < wanted ? 0.0 : next / rz;
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = z[i] + kept * p[i];
    rz = next;
  }
  add(faceTractions(x), field);
}

/// Adds the normal part of a face's traction to a contact facet, in equal shares.
void StressDescent::addNormal(std::size_t facet, const double* T, ContactTraction& traction) const
{
  const Direction& normal = (*contact_)[facet].normal;
  const std::size_t modes = traction.numModes();
  for (std::size_t vertex = 0; vertex < 3; ++vertex)
    for (std::size_t k = 0; k < modes; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        traction.shares[(facet * 3 + vertex) * modes + k] += normal[i] * T[3 * k + i] / 3.0;
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
