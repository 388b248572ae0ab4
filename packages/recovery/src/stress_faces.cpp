#include "stress_faces.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{
namespace
{

DenseMatrix transposed(const DenseMatrix& matrix)
{
  DenseMatrix result(matrix.cols(), matrix.rows());
  for (int j = 0; j < matrix.cols(); ++j)
    for (int i = 0; i < matrix.rows(); ++i)
      result(j, i) = matrix(i, j);
  return result;
}

} // namespace

Wrench StressFace::wrench(const double* T, const double* point, double length) const
{
  Wrench result{T[0], T[1], T[2], 0.0, 0.0, 0.0};
  addCross({centre[0] - point[0], centre[1] - point[1], centre[2] - point[2]}, T, 1.0 / length, &result[3]);
  for (std::size_t k = 0; k < 2; ++k)
    addCross(arms[k], T + 3 * (k + 1), 1.0 / length, &result[3]);
  return result;
}

void StressFace::toSide(std::size_t side, const double* T, int count, double* result) const
{
  const double sign = sideSign(side);
  if (side == 0 || turned.rows() == 0) {
    for (int i = 0; i < count; ++i)
      result[i] = sign * T[i];
    return;
  }
  std::fill_n(result, count, 0.0);
  for (int j = 0; j < turned.cols(); ++j)
    for (int k = 0; k < turned.rows(); ++k)
      for (int i = 0; i < 3; ++i)
        result[3 * k + i] -= turned(k, j) * T[3 * j + i];
}

void StressFace::fromSide(std::size_t side, const double* forces, int count, double* sum) const
{
  const double sign = sideSign(side);
  if (side == 0 || turned.rows() == 0) {
    for (int i = 0; i < count; ++i)
      sum[i] += sign * forces[i];
    return;
  }
  for (int j = 0; j < turned.cols(); ++j)
    for (int k = 0; k < turned.rows(); ++k)
      for (int i = 0; i < 3; ++i)
        sum[3 * j + i] -= turned(k, j) * forces[3 * k + i];
}

DenseMatrix StressFace::onSide(std::size_t side, const DenseMatrix& columns) const
{
  DenseMatrix result(columns.rows(), columns.cols());
  for (int j = 0; j < columns.cols(); ++j)
    toSide(side, columns.col(j), columns.rows(), result.col(j));
  return result;
}

DenseMatrix StressFace::allOwn() const
{
  if (free)
    return free->own;
  DenseMatrix all(linear + higher, numOwn());
  const FaceFrame frame = this->frame();
  const Wrench none{};
  for (int k = 0; k < ownLinear; ++k) {
    double unit[ownLinear] = {};
    unit[k] = 1.0;
    frame.tractions(unit, none.data(), all.col(k));
  }
  for (int k = 0; k < higher; ++k)
    all(linear + k, ownLinear + k) = 1.0;
  return all;
}

DenseMatrix StressFace::carriers() const
{
  if (free)
    return free->carrier;
  DenseMatrix all(linear + higher, numCarriers());
  for (int k = 0; k < all.cols(); ++k) {
    Wrench unit{};
    unit[std::size_t(k)] = 1.0;
    addCarried(unit.data(), all.col(k));
  }
  return all;
}

void StressFace::addCarried(const double* amounts, double* T) const
{
  if (!free) {
    double none[ownLinear] = {}, carried[linear];
    frame().tractions(none, amounts, carried);
    for (int i = 0; i < linear; ++i)
      T[i] += carried[i];
    return;
  }
  for (int k = 0; k < free->carrier.cols(); ++k)
    for (int i = 0; i < free->carrier.rows(); ++i)
      T[i] += free->carrier(i, k) * amounts[k];
}

StressFaces::StressFaces(const StressCells& cells, const std::vector<ContactPatch>& contact)
    : cells_(&cells), faceOf_(std::size_t(cells.size()) * 4, -1)
{
  for (int body = 0; body < cells.numBodies(); ++body)
    if (cells.has(body))
      addFaces(body, contact.size());
  joinContact(contact);
}

/// more: faces that are still to come.
void StressFaces::addFaces(int body, std::size_t more)
{
  const Mesh& mesh = cells_->body(body).model().mesh;
  const VertexTuples facets = allFacets(mesh, mesh.numPoints());
  int count = 0;
  for (int place = 0; place < facets.size(); place = facets.groupEnd(place))
    ++count;
  faces_.reserve(faces_.size() + std::size_t(count) + more);
  joined_.reserve(faces_.capacity());
  for (int place = 0, end = 0; place < facets.size(); place = end) {
    end = facets.groupEnd(place);
    NDFRAME_ASSERT(end - place <= 2, "a facet of a sound mesh has one or two cells");
    StressFace face;
    for (int p = place; p < end; ++p) {
      const Facet facet{facets.at(p) / 4, facets.at(p) % 4};
      const auto side = std::size_t(p - place);
      face.cell[side] = cells_->number(body, facet.cell);
      face.facet[side] = sortedFacet(mesh, facet);
    }
    findGeometry(face);
    if (face.isInside())
      face.higher = cells_->facetData() - StressFace::linear;
    else
      freeReactions(face);
    for (std::size_t side = 0; side < 2 && face.cell[side] >= 0; ++side)
      faceOf_[std::size_t(face.cell[side]) * 4 + std::size_t(face.facet[side])] = size();
    faces_.push_back(std::move(face));
    joined_.push_back(-1);
  }
}

/// Centre, size and arms.
void StressFaces::findGeometry(StressFace& face) const
{
  const Mesh& mesh = cells_->mesh(face.cell[0]);
  const SortedCell cell = cells_->sorted(face.cell[0]);
  std::array<const double*, 3> vertices{};
  for (int v = 0, place = 0; v < 4; ++v)
    if (v != face.facet[0])
      vertices[std::size_t(place++)] = mesh.point(cell.vertices[std::size_t(v)]);
  Direction e{}, f{};
  for (std::size_t i = 0; i < 3; ++i) {
    face.centre[i] = (vertices[0][i] + vertices[1][i] + vertices[2][i]) / 3.0;
    e[i] = vertices[1][i] - vertices[0][i];
    f[i] = vertices[2][i] - vertices[0][i];
  }
  Direction normal{};
  addCross(e, f.data(), 0.5, normal.data());
  face.size = std::sqrt(std::sqrt(dotProduct(normal, normal)));
  const double* means = cells_->any().facetMeans().data() + 3;
  for (Direction& arm : face.arms)
    for (std::size_t v = 0; v < 3; ++v, ++means)
      for (std::size_t i = 0; i < 3; ++i)
        arm[i] += *means * (vertices[v][i] - face.centre[i]);
}

void StressFaces::freeReactions(StressFace& face)
{
  const int body = cells_->bodyOf(face.cell[0]);
  const StarBody& star = cells_->body(body);
  const int boundary = star.boundaryIndex(face.cell[0] - cells_->number(body, 0), face.facet[0]);
  if (boundary < 0)
    return freeAlong(face, nullptr, 0);
  const auto& data = star.data().boundary[std::size_t(boundary)];
  freeAlong(face, data.directions.data(), data.supported);
}

/// Tractions along some directions: linear ones, and those beyond, which have no wrench.
void StressFaces::freeAlong(StressFace& face, const Direction* directions, int count)
{
  constexpr int linear = 3; // modes
  const int modes = cells_->any().facetModes(), data = cells_->facetData();
  if (count == 0) {
    if (!none_)
      none_ = std::make_shared<FreeTractions>(
          FreeTractions{DenseMatrix(data, 0), DenseMatrix(data, 0), DenseMatrix(6, 0), DenseMatrix(0, 6)});
    face.free = none_;
    return;
  }
  DenseMatrix reactions(data, count * linear);
  for (int mode = 0, column = 0; mode < linear; ++mode)
    for (int d = 0; d < count; ++d, ++column)
      std::copy_n(directions[d].begin(), 3, reactions.col(column) + std::ptrdiff_t(3) * mode);
  DenseMatrix wrenches(6, reactions.cols());
  for (int column = 0; column < wrenches.cols(); ++column) {
    const Wrench has = face.wrench(reactions.col(column), face.centre.data(), face.size);
    std::copy(has.begin(), has.end(), wrenches.col(column));
  }
  const DenseMatrix idle = nullSpace(wrenches, rigidTolerance), busy = nullSpace(transposed(idle), rigidTolerance);
  FreeTractions free{DenseMatrix(data, idle.cols() + count * (modes - linear)),
                     multiply(reactions, busy),
                     multiply(wrenches, busy),
                     {}};
  const DenseMatrix own = multiply(reactions, idle);
  std::copy_n(own.data(), std::ptrdiff_t(data) * own.cols(), free.own.data());
  for (int mode = linear, column = own.cols(); mode < modes; ++mode)
    for (int d = 0; d < count; ++d, ++column)
      std::copy_n(directions[d].begin(), 3, free.own.col(column) + std::ptrdiff_t(3) * mode);
  free.choose = pseudoInverse(free.reach, rigidTolerance);
  face.free = std::make_shared<FreeTractions>(std::move(free));
}

/// Contact facets become faces with their normal tractions free: of two cells where both bodies have the same wrench of
/// them, of one cell at a rigid body; where supports take a part they keep the tractions that they have.
void StressFaces::joinContact(const std::vector<ContactPatch>& contact)
{
  OrderedModes inOrder(3, cells_->any().data().degree);
  for (std::size_t f = 0; f < contact.size(); ++f) {
    const ContactPatch& patch = contact[f];
    if (!cells_->has(patch.sides[0].body) || patch.turns)
      continue;
    StressFace face;
    const std::size_t count = cells_->has(patch.sides[1].body) ? 2 : 1;
    if (patch.sides[0].facet.cell < 0 || (count == 2 && patch.sides[1].facet.cell < 0))
      continue; // another rank's
    bool isFree = true;
    for (std::size_t side = 0; side < count; ++side) {
      const auto& [body, facet, places] = patch.sides[side];
      face.cell[side] = cells_->number(body, facet.cell);
      face.facet[side] = sortedFacet(cells_->body(body).model().mesh, facet);
      isFree = isFree && faces_[std::size_t(within(face.cell[side], face.facet[side]))].free->reach.cols() == 0;
    }
    face.contact = int(f);
    face.theirs = patch.sides[1].places;
    if (count == 2 && face.theirs != std::array{0, 1, 2})
      face.turned = inOrder(patch.sides[1]);
    findGeometry(face);
    if (!isFree || (count == 2 && !coincide(face, patch.normal)))
      continue;
    freeAlong(face, &patch.normal, 1);
    for (std::size_t side = 0; side < count; ++side)
      joined_[std::size_t(within(face.cell[side], face.facet[side]))] = size();
    faces_.push_back(std::move(face));
    joined_.push_back(-1);
  }
}

/// Whether equal normal tractions have the same wrench on the second cell, to round-off: its points may differ from the
/// first one's along the normal only.
bool StressFaces::coincide(const StressFace& face, const Direction& normal) const
{
  constexpr double roundOff = 1e-13;
  const auto armsOn = [&](std::size_t side) {
    const auto vertices = corners(cells_->mesh(face.cell[side]), cells_->sorted(face.cell[side]), face.facet[side]);
    return momentArms(cells_->any().facetMeans(), vertices, face.centre.data(), 3);
  };
  const Vector arms = armsOn(0), theirs = armsOn(1);
  for (std::size_t at = 0; at < arms.size(); at += 3) {
    Direction apart{};
    for (std::size_t i = 0; i < 3; ++i) {
      apart[i] = (face.turned.rows() == 0 ? theirs[at + i] : 0.0) - arms[at + i];
      for (int j = 0; j < face.turned.rows(); ++j)
        apart[i] += face.turned(j, int(at / 3)) * theirs[std::size_t(j) * 3 + i];
    }
    const double along = dotProduct(apart, normal);
    for (std::size_t i = 0; i < 3; ++i)
      if (!(std::abs(apart[i] - along * normal[i]) <= roundOff * face.size))
        return false;
  }
  return true;
}

std::vector<StressFaces::Seat> StressFaces::seats() const
{
  std::vector<Seat> seats;
  for (int cell = 0; cell < cells_->size(); ++cell)
    for (int facet = 0; facet < 4; ++facet) {
      const StressFace& face = faces_[std::size_t(of(cell, facet))];
      const bool isTurned = face.sideOf(cell) == 1 && face.turned.rows() > 0;
      seats.push_back({of(cell, facet), isTurned ? 0.0F : float(sideSign(face.sideOf(cell)))});
    }
  return seats;
}

} // namespace ndframe
