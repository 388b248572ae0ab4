#include "ndframe/equilibrium/cell_form.hpp"

namespace ndframe
{

DenseCholesky stiffnessFactor(const Elasticity& law)
{
  DenseMatrix stiffness(law.strains(), law.strains());
  for (int i = 0; i < law.strains(); ++i)
    for (int j = 0; j < law.strains(); ++j)
      stiffness(i, j) = law(i, j);
  return DenseCholesky(std::move(stiffness));
}

CellForm::CellForm(const ReferenceStress& reference, const CellMap& map, const Elasticity& law)
    : reference_(reference), compliance_(pulledBackCompliance(map, law)), bd_(reference.bubbles, reference.data())
{
  const int data = reference.data(), bubbles = reference.bubbles;
  DenseMatrix bb(bubbles, bubbles);
  for (std::size_t m = 0; m < compliance_.size(); ++m) {
    const DenseMatrix& table = reference.energy[m];
    for (int j = 0; j < data; ++j)
      for (int i = 0; i < bubbles; ++i)
        bd_(i, j) += compliance_[m] * table(data + i, j);
    for (int j = 0; j < bubbles; ++j)
      for (int i = 0; i < bubbles; ++i)
        bb(i, j) += compliance_[m] * table(data + i, data + j);
  }
  if (bubbles > 0)
    bb_.emplace(std::move(bb), 0.0);
}

DenseMatrix CellForm::condensed() const
{
  DenseMatrix A(reference_.data(), reference_.data());
  for (std::size_t m = 0; m < compliance_.size(); ++m)
    for (int j = 0; j < A.cols(); ++j)
      for (int i = 0; i < A.rows(); ++i)
        A(i, j) += compliance_[m] * reference_.energy[m](i, j);
  if (!bb_)
    return A;
  for (int j = 0; j < A.cols(); ++j) {
    const Vector y = bb_->solve(bd_.column(j));
    // By symmetry the lower triangle tells all.
    for (int i = j; i < A.rows(); ++i) {
      for (int b = 0; b < bd_.rows(); ++b)
        A(i, j) -= bd_(b, i) * y[std::size_t(b)];
      A(j, i) = A(i, j);
    }
  }
  return A;
}

Vector CellForm::coefficients(const Vector& data) const
{
  Vector result = multiply(reference_.lift, data);
  if (!bb_)
    return result;
  const Vector bubbles = multiply(reference_.bubble, bb_->solve(multiply(bd_, data)));
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] -= bubbles[i];
  return result;
}

StressCorrection zeroCorrection(const Mesh& mesh, int degree)
{
  const auto perMode = std::size_t(mesh.numCells()) * std::size_t(mesh.dim);
  StressCorrection correction;
  correction.dim = mesh.dim;
  correction.degree = degree;
  correction.tractions.assign(perMode * std::size_t(mesh.dim + 1) * std::size_t(facetBasis(mesh.dim, degree).size()),
                              0.0);
  correction.loads.assign(perMode * std::size_t(loadBasis(mesh.dim, degree).size()), 0.0);
  return correction;
}

Vector pullBack(const ReferenceStress& reference, const CellMap& map, const StressCorrection& correction, int cell)
{
  Vector result;
  const auto append = [&](const Vector& vectors, int count) {
    const double* first = vectors.data() + std::size_t(cell) * std::size_t(count);
    for (int at = 0; at < count; ++at) {
      double component = 0.0;
      for (int k = 0; k < map.dim; ++k)
        component += map.inverse[std::size_t(at % map.dim) * std::size_t(map.dim) + std::size_t(k)] *
                     first[at / map.dim * map.dim + k];
      result.push_back(component);
    }
  };
  append(correction.tractions, reference.tractions);
  append(correction.loads, reference.loads);
  return result;
}

} // namespace ndframe
