#include "star_system.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
namespace
{

/// Entry in the full matrix or vector of a star's cells.
int place(const StarBody& body, int cell, int row)
{
  return cell * body.reference().data() + row;
}

} // namespace

StarSystem::StarSystem(const StarBody& body, Star star, const std::vector<ReleasedFacet>& released)
    : balance_(body, std::move(star), released), inner_(DenseMatrix())
{
  DenseMatrix full(balance_.numUnknowns(), balance_.numUnknowns());
  for (int cell = 0; cell < int(this->star().cells.size()); ++cell) {
    parts_.push_back(makePart(cell));
    const CellPart& part = parts_.back();
    DenseMatrix energy(int(part.rows.size()), int(part.rows.size()));
    for (int j = 0; j < energy.cols(); ++j)
      for (int i = 0; i < energy.rows(); ++i)
        energy(i, j) = part.energy(part.rows[std::size_t(i)], part.rows[std::size_t(j)]);
    const DenseMatrix local = multiplyTransposed(part.columns, multiply(energy, part.columns));
    for (int j = 0; j < local.cols(); ++j)
      for (int i = 0; i < local.rows(); ++i)
        full(part.unknowns[std::size_t(i)], part.unknowns[std::size_t(j)]) += local(i, j);
  }
  eliminateInner(full);
}

StarSystem::CellPart StarSystem::makePart(int cell) const
{
  const StarBody& body = balance_.body();
  CellPart part;
  part.energy = body.cellEnergy(star().cells[std::size_t(cell)]);
  std::vector<std::pair<const SpokeColumns*, double>> sides;
  for (std::size_t s = 0; s < star().spokes.size(); ++s)
    for (std::size_t side = 0; side < 2; ++side)
      if (star().spokes[s].cell[side] == cell) {
        const SpokeColumns& columns = balance_.spokes()[s];
        sides.emplace_back(&columns, side == 0 ? 1.0 : -1.0);
        part.unknowns.insert(part.unknowns.end(), columns.unknowns.begin(), columns.unknowns.end());
        for (int i = 0; i < body.facetData(); ++i)
          part.rows.push_back(star().spokes[s].facet[side] * body.facetData() + i);
      }
  std::sort(part.unknowns.begin(), part.unknowns.end());
  part.unknowns.erase(std::unique(part.unknowns.begin(), part.unknowns.end()), part.unknowns.end());
  part.columns = DenseMatrix(int(part.rows.size()), int(part.unknowns.size()));
  for (std::size_t k = 0; k < sides.size(); ++k)
    for (std::size_t j = 0; j < sides[k].first->unknowns.size(); ++j) {
      const auto found = std::lower_bound(part.unknowns.begin(), part.unknowns.end(), sides[k].first->unknowns[j]);
      double* target = part.columns.col(int(found - part.unknowns.begin())) + std::ptrdiff_t(k) * body.facetData();
      for (int i = 0; i < body.facetData(); ++i)
        target[i] = sides[k].second * sides[k].first->columns(i, int(j));
    }
  return part;
}

void StarSystem::eliminateInner(const DenseMatrix& full)
{
  const int inner = numInner(), released = numReleased();
  for (int j = 0; j < inner; ++j)
    scale_.push_back(1.0 / std::sqrt(full(j, j)));
  DenseMatrix own(inner, inner);
  for (int j = 0; j < inner; ++j)
    for (int i = 0; i < inner; ++i)
      own(i, j) = scale_[std::size_t(i)] * full(i, j) * scale_[std::size_t(j)];
  inner_ = DenseCholesky(std::move(own));
  condensing_ = DenseMatrix(inner, released);
  stiffness_ = DenseMatrix(released, released);
  for (int j = 0; j < released; ++j) {
    const double* column = full.col(inner + j);
    const Vector solved = solveInner(column);
    std::copy(solved.begin(), solved.end(), condensing_.col(j));
    for (int i = 0; i < released; ++i)
      stiffness_(i, j) = column[inner + i];
  }
  for (int j = 0; j < released; ++j)
    for (int i = 0; i < released; ++i)
      for (int k = 0; k < inner; ++k)
        stiffness_(i, j) -= full(k, inner + i) * condensing_(k, j);
}

Vector StarSystem::solveInner(const double* gradient) const
{
  Vector z(gradient, gradient + numInner());
  for (std::size_t i = 0; i < z.size(); ++i)
    z[i] *= scale_[i];
  z = inner_.solve(std::move(z));
  for (std::size_t i = 0; i < z.size(); ++i)
    z[i] *= scale_[i];
  return z;
}

/// Half the derivative of the energy with respect to all unknowns, released ones last.
DenseMatrix StarSystem::fullGradient(const StarFields& x) const
{
  DenseMatrix gradient(balance_.numUnknowns(), x.cols());
  for (int cell = 0; cell < int(parts_.size()); ++cell) {
    const CellPart& part = parts_[std::size_t(cell)];
    for (int field = 0; field < x.cols(); ++field) {
      const double* first = x.col(field) + place(balance_.body(), cell, 0);
      const Vector force = multiplySymmetric(part.energy, Vector(first, first + part.energy.rows()));
      for (int j = 0; j < part.columns.cols(); ++j)
        for (std::size_t i = 0; i < part.rows.size(); ++i)
          gradient(part.unknowns[std::size_t(j)], field) += part.columns(int(i), j) * force[std::size_t(part.rows[i])];
    }
  }
  return gradient;
}

DenseMatrix StarSystem::gradient(const StarFields& x) const
{
  const DenseMatrix full = fullGradient(x);
  DenseMatrix condensed(numReleased(), x.cols());
  for (int field = 0; field < x.cols(); ++field)
    for (int j = 0; j < numReleased(); ++j) {
      condensed(j, field) = full(numInner() + j, field);
      for (int k = 0; k < numInner(); ++k)
        condensed(j, field) -= condensing_(k, j) * full(k, field);
    }
  return condensed;
}

void StarSystem::relax(StarFields& x, const DenseMatrix& dt) const
{
  NDFRAME_ASSERT(dt.rows() == numReleased() && dt.cols() == x.cols(), "one column of released tractions per field");
  const DenseMatrix full = fullGradient(x);
  for (int field = 0; field < x.cols(); ++field) {
    Vector unknowns = solveInner(full.col(field));
    for (int k = 0; k < numInner(); ++k) {
      unknowns[std::size_t(k)] = -unknowns[std::size_t(k)];
      for (int j = 0; j < numReleased(); ++j)
        unknowns[std::size_t(k)] -= condensing_(k, j) * dt(j, field);
    }
    unknowns.insert(unknowns.end(), dt.col(field), dt.col(field) + numReleased());
    for (int cell = 0; cell < int(parts_.size()); ++cell) {
      const CellPart& part = parts_[std::size_t(cell)];
      for (int j = 0; j < part.columns.cols(); ++j)
        for (std::size_t i = 0; i < part.rows.size(); ++i)
          x(place(balance_.body(), cell, part.rows[i]), field) +=
              part.columns(int(i), j) * unknowns[std::size_t(part.unknowns[std::size_t(j)])];
    }
  }
}

} // namespace ndframe
