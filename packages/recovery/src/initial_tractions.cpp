#include "initial_tractions.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/equilibrium/cell_stress.hpp"

namespace ndframe
{
namespace
{

constexpr int linear = StressFace::linear;

} // namespace

InitialTractions::InitialTractions(int body, const StressFaces& faces, const FieldInput& field,
                                   StressCorrection& correction, int threads)
    : number_(body), faces_(&faces), body_(&faces.cells().body(body)), field_(&field), correction_(&correction),
      facetShares_(facetBasis(3, body_->data().degree), body_->data().order),
      cellShares_(loadBasis(3, body_->data().degree), body_->data().order),
      divergence_(std::size_t(body_->model().mesh.numCells())), forces_(divergence_.size(), 0.0)
{
  findTables();
  runInRanges(int(forces_.size()), threads, [&](int first, int last) {
    for (int cell = first; cell < last; ++cell)
      putStress(cell);
  });
  for (const StressFace& face : faces.all())
    if (face.contact < 0 && faces.cells().bodyOf(face.cell[0]) == body)
      putFace(face);
  if (!body_->data().cellShares.empty())
    subtractBodyLoads();
}

void InitialTractions::findTables()
{
  const bool isLinear = body_->data().order == 2;
  const auto share = [&](std::size_t a, std::size_t b, std::size_t k) {
    return isLinear ? facetShares_.ofLinear(int(a), int(b))[k] : facetShares_.ofOne(int(a))[k] / double(modes);
  };
  DenseMatrix whole(modes, modes);
  for (std::size_t b = 0; b < modes; ++b)
    for (std::size_t k = 0; k < modes; ++k) {
      for (std::size_t a = 0; a < modes; ++a)
        moments_[k][b] += share(a, b, k);
      whole(int(k), int(b)) = moments_[k][b];
    }
  const DenseMatrix inverse = pseudoInverse(whole, 1e-10); // tractions of order 1 are constant
  for (std::size_t a = 0; a < modes; ++a)
    for (std::size_t k = 0; k < modes; ++k)
      for (std::size_t l = 0; l < modes; ++l)
        for (std::size_t b = 0; b < modes; ++b)
          ofVertices_[a][k][l] += share(a, b, k) * inverse(int(b), int(l));
  const Vector& means = body_->cellMeans(); // sum_k of the part's moment k times the arm of function k
  const auto towards = [&](std::size_t v) {
    double sum = 0.0;
    for (std::size_t k = 0; k < std::size_t(body_->loadModes()); ++k)
      sum += cellShares_.ofOne(0)[k] * means[k * 4 + v];
    return sum;
  };
  arm_ = cellShares_.ofOne(0)[0] - (towards(0) - towards(1));
}

/// Minus sigma~ n on the facets of a cell and minus its divergence. With the barycentric coordinate of the vertex
/// opposite to a facet, |f| n = - 3 |E| grad lambda.
void InitialTractions::putStress(int cell)
{
  const BodyModel& model = body_->model();
  const CellStress stress = cellStress(model, cell, sortedCell(model.mesh, cell), *field_->displacement);
  double& sum = forces_[std::size_t(cell)];
  for (int facet = 0; facet < 4; ++facet) {
    double* T = tractions(cell, facet);
    for (int b = 0; b < 3; ++b) {
      double force[3] = {};
      addForce(stress, b < facet ? b : b + 1, facet, 3.0 * stress.measure, force);
      for (std::size_t i = 0; i < 3; ++i) {
        sum += std::abs(force[i]) / 3.0;
        for (std::size_t k = 0; k < modes; ++k)
          T[3 * k + i] += moments_[k][std::size_t(b)] * force[i];
      }
    }
  }
  if (body_->data().order != 2)
    return;
  Direction& divergence = divergence_[std::size_t(cell)];
  for (int v = 0; v < 4; ++v)
    addForce(stress, v, v, -stress.measure, divergence.data());
  double* load = correction_->loads.data() + std::ptrdiff_t(cell) * body_->reference().loads;
  for (int k = 0; k < body_->loadModes(); ++k)
    for (std::size_t i = 0; i < 3; ++i, ++load) {
      for (int a = 0; a < 4; ++a)
        *load += cellShares_.ofOne(a)[k] * divergence[i];
      sum += k == 0 ? std::abs(divergence[i]) : 0.0;
    }
}

void InitialTractions::putFace(const StressFace& face)
{
  const int first = face.cell[0] - faces_->cells().number(number_, 0);
  double* T = tractions(first, face.facet[0]);
  if (!face.isBoundary()) {
    double* other = tractions(face.cell[1] - faces_->cells().number(number_, 0), face.facet[1]);
    for (int i = 0; i < linear; ++i)
      T[i] = other[i] = 0.5 * (T[i] + other[i]);
    return;
  }
  if (body_->boundaryIndex(first, face.facet[0]) >= 0 || body_->contactIndex(first, face.facet[0]) >= 0)
    putPrescribed(face, first);
}

/// A facet with supports, loads or contact: the parts of its three vertices, and the whole.
void InitialTractions::putPrescribed(const StressFace& face, int cell)
{
  const StaticData& data = body_->data();
  const auto size = std::size_t(body_->facetData());
  const int facet = face.facet[0], boundary = body_->boundaryIndex(cell, facet),
            contact = body_->contactIndex(cell, facet);
  if (prescribedAt_.empty())
    prescribedAt_.assign(forces_.size() * 4, -1);
  prescribedAt_[std::size_t(cell) * 4 + std::size_t(facet)] = int(prescribed_.size());
  double* T = tractions(cell, facet);
  Vector own(size), whole(T, T + size);
  for (std::size_t a = 0; a < 3; ++a) {
    std::fill(own.begin(), own.end(), 0.0);
    const auto add = [&](const double* shares, int index) {
      const double* share = shares + (std::size_t(index) * 3 + a) * size;
      for (std::size_t i = 0; i < size; ++i) {
        own[i] += share[i];
        whole[i] += share[i];
        forces_[std::size_t(cell)] += std::abs(share[i]);
      }
    };
    if (boundary >= 0 && !data.facetShares.empty())
      add(data.facetShares.data(), boundary);
    if (contact >= 0 && field_->contact != nullptr)
      add(field_->contact->data(), contact);
    for (std::size_t k = 0; k < modes; ++k)
      for (std::size_t l = 0; l < modes; ++l)
        for (std::size_t i = 0; i < 3; ++i)
          own[3 * k + i] += ofVertices_[a][k][l] * T[3 * l + i];
    if (boundary >= 0)
      data.boundary[std::size_t(boundary)].removeSupported(3, modes, own.data());
    prescribed_.insert(prescribed_.end(), own.begin(), own.begin() + linear);
  }
  if (boundary >= 0)
    data.boundary[std::size_t(boundary)].removeSupported(3, size / 3, whole.data());
  std::copy(whole.begin(), whole.end(), T);
}

void InitialTractions::subtractBodyLoads()
{
  const auto loads = std::size_t(body_->reference().loads);
  const double* share = body_->data().cellShares.data();
  for (std::size_t cell = 0; cell < forces_.size(); ++cell)
    for (int a = 0; a < 4; ++a)
      for (std::size_t i = 0; i < loads; ++i, ++share) {
        correction_->loads[cell * loads + i] -= *share;
        forces_[cell] += std::abs(*share);
      }
}

Wrench InitialTractions::wrenchOf(const StressFace& face, int cell, int facet, int apex, const double* vertex,
                                  double size) const
{
  const int at = prescribedAt_.empty() ? -1 : prescribedAt_[std::size_t(cell) * 4 + std::size_t(facet)];
  if (at >= 0)
    return face.wrench(prescribed_.data() + at + std::ptrdiff_t(apex) * linear, vertex, size);
  double own[linear];
  const auto& table = ofVertices_[std::size_t(apex)];
  const double* whole = tractions(cell, facet);
  for (std::size_t k = 0; k < modes; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      own[3 * k + i] = table[k][0] * whole[i] + table[k][1] * whole[3 + i] + table[k][2] * whole[6 + i];
  return face.wrench(own, vertex, size);
}

void InitialTractions::addLoad(int cell, int apex, const double* vertex, double size, Wrench& sum) const
{
  const Mesh& mesh = body_->model().mesh;
  const Direction centre = cellCentre(mesh, cell), &divergence = divergence_[std::size_t(cell)];
  const Direction arm{centre[0] - vertex[0], centre[1] - vertex[1], centre[2] - vertex[2]};
  for (std::size_t i = 0; i < 3; ++i)
    sum[i] += cellShares_.ofOne(apex)[0] * divergence[i];
  addCross(arm, divergence.data(), arm_ / size, &sum[3]);
  if (body_->data().cellShares.empty())
    return;
  const Vector arms = momentArms(body_->cellMeans(), corners(mesh, sortedCell(mesh, cell), -1), vertex, 3);
  const double* share =
      body_->data().cellShares.data() + (std::ptrdiff_t(cell) * 4 + apex) * std::ptrdiff_t(body_->reference().loads);
  for (std::size_t i = 0; i < 3; ++i)
    sum[i] -= share[i];
  for (std::size_t k = 0; k < arms.size(); k += 3)
    addCross({arms[k], arms[k + 1], arms[k + 2]}, share + k, -1.0 / size, &sum[3]);
}

} // namespace ndframe
