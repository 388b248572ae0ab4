#include "stress_descent.hpp"

#include <algorithm>

namespace ndframe
{

StressDescent::StressDescent(const StarBody& body, const StressFaces& faces)
    : body_(&body), faces_(&faces), blocks_(body, faces),
      matrices_(body, [this](int cell, const DenseMatrix& A) { blocks_.add(cell, A); })
{
  blocks_.invert();
}

/// T per face, on its first cell.
Vector StressDescent::faceTractions(const Vector& unknowns) const
{
  const int size = facetData();
  Vector tractions(std::size_t(numFaces()) * std::size_t(size), 0.0);
  const auto add = [&](int f, const DenseMatrix& columns, const double* amounts) {
    double* T = tractions.data() + std::ptrdiff_t(f) * size;
    for (int k = 0; k < columns.cols(); ++k)
      for (int i = 0; i < size; ++i)
        T[i] += columns(i, k) * amounts[k];
  };
  for (int f = 0; f < numFaces(); ++f)
    add(f, faces_->faces()[std::size_t(f)].own, unknowns.data() + blocks_.ofFace(f));
  std::vector<Wrench> amounts(std::size_t(numFaces()), Wrench{}); // of the carriers
  for (std::size_t e = 0; e < faces_->edges().size(); ++e) {
    const StressEdge& edge = faces_->edges()[e];
    const double* z = unknowns.data() + blocks_.ofEdge(e);
    for (const StressEdge::Step& step : edge.ring)
      for (int k = 0; k < step.through.cols(); ++k)
        for (int i = 0; i < step.through.rows(); ++i)
          amounts[std::size_t(step.face)][std::size_t(i)] += step.through(i, k) * z[k];
  }
  for (int f = 0; f < numFaces(); ++f)
    add(f, faces_->faces()[std::size_t(f)].carrier, amounts[std::size_t(f)].data());
  return tractions;
}

/// A_E times the cells' tractions, per cell.
Vector StressDescent::forcesOf(const Vector& tractions) const
{
  const int size = facetData(), cells = body_->model().mesh.numCells();
  Vector forces(std::size_t(cells) * std::size_t(4) * std::size_t(size));
  Vector x(4 * std::size_t(size), 0.0);
  for (int cell = 0; cell < cells; ++cell) {
    for (int facet = 0; facet < 4; ++facet) {
      const int f = faces_->faceOf(cell, facet);
      const double sign = faces_->faces()[std::size_t(f)].cell[0] == cell ? 1.0 : -1.0;
      const double* T = tractions.data() + std::ptrdiff_t(f) * size;
      for (int i = 0; i < size; ++i)
        x[std::size_t(facet) * std::size_t(size) + std::size_t(i)] = sign * T[i];
    }
    matrices_.multiply(cell, x.data(), 4 * size, forces.data() + std::ptrdiff_t(4) * cell * size);
  }
  return forces;
}

/// Of the energy's half, by the unknowns, from the cells' forces A_E x_E.
Vector StressDescent::gradientOf(const Vector& forces) const
{
  const int size = facetData(), data = body_->reference().tractions;
  Vector gradient(std::size_t(blocks_.size()), 0.0), ofCarriers;
  std::vector<std::size_t> firstCarrier{0};
  for (int f = 0; f < numFaces(); ++f) {
    const StressFace& face = faces_->faces()[std::size_t(f)];
    std::array<double, 18> G{}; // facet data at most
    for (std::size_t side = 0; side < 2 && face.cell[side] >= 0; ++side)
      for (int i = 0; i < size; ++i)
        G[std::size_t(i)] +=
            (side == 0 ? 1.0 : -1.0) * forces[std::size_t(face.cell[side]) * std::size_t(data) +
                                              std::size_t(face.facet[side]) * std::size_t(size) + std::size_t(i)];
    for (int k = 0; k < face.own.cols(); ++k)
      for (int i = 0; i < size; ++i)
        gradient[std::size_t(blocks_.ofFace(f)) + std::size_t(k)] += face.own(i, k) * G[std::size_t(i)];
    for (int k = 0; k < face.carrier.cols(); ++k) {
      ofCarriers.push_back(0.0);
      for (int i = 0; i < size; ++i)
        ofCarriers.back() += face.carrier(i, k) * G[std::size_t(i)];
    }
    firstCarrier.push_back(ofCarriers.size());
  }
  for (std::size_t e = 0; e < faces_->edges().size(); ++e) {
    const StressEdge& edge = faces_->edges()[e];
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

/// A_E x_E of a correction.
Vector StressDescent::startForces(const StressCorrection& correction) const
{
  const int tractions = body_->reference().tractions, loads = body_->reference().loads,
            cells = body_->model().mesh.numCells();
  Vector forces(std::size_t(cells) * std::size_t(tractions), 0.0), x(std::size_t(tractions + loads), 0.0);
  for (int cell = 0; cell < cells; ++cell) {
    std::copy_n(correction.tractions.data() + std::ptrdiff_t(cell) * tractions, tractions, x.begin());
    std::copy_n(correction.loads.data() + std::ptrdiff_t(cell) * loads, loads, x.begin() + tractions);
    matrices_.multiply(cell, x.data(), tractions + loads, forces.data() + std::ptrdiff_t(cell) * tractions);
  }
  return forces;
}

void StressDescent::lower(StressCorrection& correction, int steps) const
{
  Vector residual = gradientOf(startForces(correction));
  for (double& value : residual)
    value = -value;
  Vector z = blocks_.precondition(residual), p = z, x(residual.size(), 0.0);
  double rz = dot(residual, z);
  for (int step = 0; step < steps && rz > 0.0; ++step) {
    const Vector Ap = gradientOf(forcesOf(faceTractions(p)));
    const double curvature = dot(p, Ap);
    if (!(curvature > 0.0))
      break;
    const double length = rz / curvature;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += length * p[i];
      residual[i] -= length * Ap[i];
    }
    z = blocks_.precondition(residual);
    const double next = dot(residual, z);
    for (std::size_t i = 0; i < p.size(); ++i)
      p[i] = z[i] + next / rz * p[i];
    rz = next;
  }
  const Vector tractions = faceTractions(x);
  const auto size = std::size_t(facetData());
  for (std::size_t f = 0; f < std::size_t(numFaces()); ++f) {
    const StressFace& face = faces_->faces()[f];
    for (std::size_t side = 0; side < 2 && face.cell[side] >= 0; ++side) {
      double* T =
          correction.tractions.data() + (std::size_t(face.cell[side]) * 4 + std::size_t(face.facet[side])) * size;
      for (std::size_t i = 0; i < size; ++i)
        T[i] += (side == 0 ? 1.0 : -1.0) * tractions[f * size + i];
    }
  }
}

} // namespace ndframe
