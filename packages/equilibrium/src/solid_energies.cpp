#include "ndframe/equilibrium/solid_energies.hpp"

#include <array>
#include <cmath>

#include "ndframe/base/lanes.hpp"
#include "ndframe/equilibrium/cell_forms.hpp"
#include "ndframe/equilibrium/cell_stress.hpp"
#include "ndframe/equilibrium/star_wrench.hpp"
#include "ndframe/equilibrium/sub_cell.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t lanes = CellForms::lanes, strains = 6, vertices = 4, mostCoefficients = 240;
constexpr std::size_t pairs[strains][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}; ///< Voigt

/// L^-1 of a stiffness K = L L^T, row by row: the complementary energy of a stress is |L^-1 sigma|^2.
std::array<double, strains * strains> inverseRoot(const Elasticity& law)
{
  double L[strains][strains] = {};
  std::array<double, strains * strains> inverse{};
  for (std::size_t j = 0; j < strains; ++j)
    for (std::size_t i = j; i < strains; ++i) {
      double value = law(int(i), int(j));
      for (std::size_t k = 0; k < j; ++k)
        value -= L[i][k] * L[j][k];
      L[i][j] = i == j ? std::sqrt(value) : value / L[j][j];
    }
  for (std::size_t j = 0; j < strains; ++j)
    for (std::size_t i = j; i < strains; ++i) {
      double value = i == j ? 1.0 : 0.0;
      for (std::size_t k = j; k < i; ++k)
        value -= L[i][k] * inverse[k * strains + j];
      inverse[i * strains + j] = value / L[i][i];
    }
  return inverse;
}

/// Some cells side by side, per number and lane.
struct Batch
{
  double F[9 * lanes], inverse[9 * lanes], det[lanes];
  double root[strains * strains * lanes];   ///< R = L^-1 M / sqrt(det), M: S to F S F^T
  double compliance[21 * lanes];            ///< R^T R, above the diagonal
  double sigma[vertices * strains * lanes]; ///< K eps(u) at the vertices
  double stress[mostCoefficients * lanes];  ///< coefficients of S
};

/// L^-1 in `root` becomes R, and the compliance is found.
NDFRAME_EVERY_PROCESSOR void findCompliance(Batch& batch)
{
  DoubleLanes F[9], R[strains][strains], M[strains], scale;
  for (std::size_t k = 0; k < 9; ++k)
    load(batch.F + k * lanes, F[k]);
  for (std::size_t lane = 0; lane < lanes; ++lane)
    scale[lane] = 1.0 / std::sqrt(batch.det[lane]);
  for (std::size_t s = 0; s < strains; ++s) {
    const auto [k, l] = pairs[s];
    for (std::size_t i = 0; i < strains; ++i) {
      const auto [a, b] = pairs[i];
      M[i] = F[3 * a + k] * F[3 * b + l];
      if (k != l)
        M[i] += F[3 * a + l] * F[3 * b + k];
    }
    for (std::size_t i = 0; i < strains; ++i) {
      DoubleLanes sum{}, entry;
      for (std::size_t j = 0; j <= i; ++j) {
        load(batch.root + (i * strains + j) * lanes, entry);
        sum += entry * M[j];
      }
      R[i][s] = scale * sum;
    }
  }
  double* compliance = batch.compliance;
  for (std::size_t a = 0; a < strains; ++a)
    for (std::size_t b = a; b < strains; ++b, compliance += lanes) {
      DoubleLanes sum{};
      for (std::size_t i = 0; i < strains; ++i)
        sum += R[i][a] * R[i][b];
      store(sum, compliance);
    }
  for (std::size_t i = 0; i < strains; ++i)
    for (std::size_t s = 0; s < strains; ++s)
      store(R[i][s], batch.root + (i * strains + s) * lanes);
}

/// Adds a stress that is linear on the whole cells, pulled back: S = |det F| F^-1 sigma F^-T. means: of a sub-cell's
/// functions times its barycentric coordinates.
NDFRAME_EVERY_PROCESSOR void addElasticStress(const double* means, std::size_t modes, Batch& batch)
{
  constexpr double quarter = 0.25;
  DoubleLanes inverse[9], S[vertices][strains], mean[strains] = {}, sigma[3][3], product[3][3], det;
  for (std::size_t k = 0; k < 9; ++k)
    load(batch.inverse + k * lanes, inverse[k]);
  load(batch.det, det);
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t s = 0; s < strains; ++s) {
      const auto [i, j] = pairs[s];
      load(batch.sigma + (v * strains + s) * lanes, sigma[i][j]);
      sigma[j][i] = sigma[i][j];
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        product[i][j] =
            inverse[3 * i] * sigma[0][j] + inverse[3 * i + 1] * sigma[1][j] + inverse[3 * i + 2] * sigma[2][j];
    for (std::size_t s = 0; s < strains; ++s) {
      const auto [i, j] = pairs[s];
      S[v][s] = det * (product[i][0] * inverse[3 * j] + product[i][1] * inverse[3 * j + 1] +
                       product[i][2] * inverse[3 * j + 2]);
      mean[s] += quarter * S[v][s];
    }
  }
  for (std::size_t sub = 0; sub < vertices; ++sub)
    for (std::size_t s = 0; s < strains; ++s) {
      double* coefficient = batch.stress + (sub * strains + s) * modes * lanes;
      for (std::size_t m = 0; m < vertices; ++m, coefficient += lanes) {
        DoubleLanes sum;
        load(coefficient, sum);
        for (std::size_t a = 0; a < vertices; ++a)
          sum += means[m * vertices + a] * (a == sub ? mean[s] : S[a][s]);
        store(sum, coefficient);
      }
    }
}

/// Integrals of |R S|^2.
NDFRAME_EVERY_PROCESSOR void measure(const Batch& batch, std::size_t modes, double* energies)
{
  constexpr double weight = 1.0 / 6.0 / double(vertices); // functions are orthonormal for means over sub-cells
  DoubleLanes R[strains][strains], given[strains], sum{};
  for (std::size_t i = 0; i < strains; ++i)
    for (std::size_t s = 0; s < strains; ++s)
      load(batch.root + (i * strains + s) * lanes, R[i][s]);
  for (std::size_t sub = 0; sub < vertices; ++sub)
    for (std::size_t m = 0; m < modes; ++m) {
      for (std::size_t s = 0; s < strains; ++s)
        load(batch.stress + ((sub * strains + s) * modes + m) * lanes, given[s]);
      for (std::size_t i = 0; i < strains; ++i) {
        DoubleLanes x{};
        for (std::size_t s = 0; s < strains; ++s)
          x += R[i][s] * given[s];
        sum += x * x;
      }
    }
  store(weight * sum, energies);
}

/// Measures batches of cells of one body.
class Energies
{
public:
  Energies(const BodyModel& body, const Vector* displacement, const StressCorrection& correction)
      : body_(body), displacement_(displacement), correction_(correction),
        reference_(referenceStress(body.mesh.dim, correction.degree)), forms_(solidForms(correction.degree)),
        means_(meanCoordinates(reference_.basis)), data_(std::size_t(reference_.data()) * lanes)
  {
    for (const Elasticity& law : body.laws.all())
      roots_.push_back(inverseRoot(law));
  }

  void find(const int* cells, std::size_t count, double* energies)
  {
    for (std::size_t lane = 0; lane < lanes; ++lane)
      put(cells[std::min(lane, count - 1)], lane);
    const auto modes = std::size_t(reference_.basis.size());
    double all[lanes];
    findCompliance(batch_);
    forms_.leastStress(batch_.compliance, data_.data(), batch_.stress);
    if (displacement_ != nullptr)
      addElasticStress(means_.data(), modes, batch_);
    measure(batch_, modes, all);
    std::copy_n(all, count, energies);
  }

private:
  void put(int cell, std::size_t lane)
  {
    const SortedCell sorted = sortedCell(body_.mesh, cell);
    const CellMap map = cellMap(body_.mesh, sorted);
    const auto& root = roots_[std::size_t(body_.laws.number(cell))];
    for (std::size_t k = 0; k < 9; ++k) {
      batch_.F[k * lanes + lane] = map.F[k];
      batch_.inverse[k * lanes + lane] = map.inverse[k];
    }
    batch_.det[lane] = map.det;
    for (std::size_t k = 0; k < root.size(); ++k)
      batch_.root[k * lanes + lane] = root[k];
    double* to = pullBack(map, correction_.tractions, cell, std::size_t(reference_.tractions), data_.data() + lane);
    pullBack(map, correction_.loads, cell, std::size_t(reference_.loads), to);
    if (displacement_ == nullptr)
      return;
    const CellStress elastic = cellStress(body_, cell, sorted, *displacement_);
    for (std::size_t v = 0; v < vertices; ++v)
      for (std::size_t s = 0; s < strains; ++s)
        batch_.sigma[(v * strains + s) * lanes + lane] = elastic.atVertex[v][s];
  }

  /// F^-1 applied to a cell's vectors; the place after the last one.
  static double* pullBack(const CellMap& map, const Vector& vectors, int cell, std::size_t count, double* to)
  {
    const double* from = vectors.data() + std::size_t(cell) * count;
    for (std::size_t at = 0; at < count; at += 3, from += 3)
      for (std::size_t i = 0; i < 3; ++i, to += lanes)
        *to = map.inverse[3 * i] * from[0] + map.inverse[3 * i + 1] * from[1] + map.inverse[3 * i + 2] * from[2];
    return to;
  }

  const BodyModel& body_;
  const Vector* displacement_;
  const StressCorrection& correction_;
  const ReferenceStress& reference_;
  const CellForms& forms_;
  Vector means_, data_;
  std::vector<std::array<double, strains * strains>> roots_; ///< per law
  Batch batch_;
};

} // namespace

Vector solidEnergies(const BodyModel& body, const Vector* displacement, const StressCorrection& correction,
                     const std::vector<int>& cells)
{
  NDFRAME_ASSERT(body.mesh.dim == 3, "cells are tetrahedra");
  Vector result(cells.size());
  Energies energies(body, displacement, correction);
  for (std::size_t first = 0; first < cells.size(); first += lanes)
    energies.find(cells.data() + first, std::min(lanes, cells.size() - first), result.data() + first);
  return result;
}

} // namespace ndframe
