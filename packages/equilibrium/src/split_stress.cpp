#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/equilibrium/sub_cell.hpp"

namespace ndframe
{

void SplitStress::stress(int sub, const double* lambda, double* sigma) const
{
  const MomentBasis& basis = referenceStress(dim, degree).basis;
  double mu[4], m[maxStressModes], S[6] = {};
  SubCell{dim, sub}.coordinates(lambda, mu);
  basis.values(mu, m);
  const double* coefficient = coefficients.data() + std::ptrdiff_t(sub) * numStrains(dim) * basis.size();
  for (int s = 0; s < numStrains(dim); ++s)
    for (int k = 0; k < basis.size(); ++k)
      S[s] += *coefficient++ * m[k];
  transformStress(dim, map.F.data(), 1.0 / map.det, S, sigma);
}

void SplitStress::divergence(int sub, const double* lambda, double* div) const
{
  const MomentBasis& basis = referenceStress(dim, degree).basis;
  const SubCell subCell{dim, sub};
  double mu[4], dm[maxStressModes * 3], Div[3] = {};
  subCell.coordinates(lambda, mu);
  basis.gradients(mu, dm);
  const double* coefficient = coefficients.data() + std::ptrdiff_t(sub) * numStrains(dim) * basis.size();
  for (int k = 0; k < basis.size(); ++k)
    for (int j = 0; j < dim; ++j) {
      double derivative = 0.0;
      for (int a = 1; a <= dim; ++a)
        derivative += dm[k * dim + a - 1] * subCell.gradient(a, j);
      for (int i = 0; i < dim; ++i)
        Div[i] += coefficient[voigt(dim, i, j) * basis.size() + k] * derivative;
    }
  for (int i = 0; i < dim; ++i) {
    div[i] = 0.0;
    for (int j = 0; j < dim; ++j)
      div[i] += map.F[std::size_t(i) * std::size_t(dim) + std::size_t(j)] * Div[j] / map.det;
  }
}

double SplitStress::energy(const Elasticity& law) const
{
  const DenseCholesky stiffness = stiffnessFactor(law);
  const int modes = referenceStress(dim, degree).basis.size(), strains = numStrains(dim);
  double sum = 0.0;
  for (int sub = 0; sub <= dim; ++sub)
    for (int m = 0; m < modes; ++m) {
      double S[6];
      Vector sigma(std::size_t(strains), 0.0);
      for (int s = 0; s < strains; ++s)
        S[s] = coefficients[(std::size_t(sub) * std::size_t(strains) + std::size_t(s)) * std::size_t(modes) +
                            std::size_t(m)];
      transformStress(dim, map.F.data(), 1.0 / map.det, S, sigma.data());
      sigma = stiffness.solveLower(std::move(sigma));
      sum += dot(sigma, sigma);
    }
  // The functions are orthonormal for the mean value over a sub-cell.
  return sum * referenceMeasure(dim) * map.det / (dim + 1);
}

} // namespace ndframe
