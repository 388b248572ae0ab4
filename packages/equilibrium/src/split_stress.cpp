#include <cmath>

#include "ndframe/equilibrium/reference_stress.hpp"
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

namespace
{

/// K = L L^T: the complementary energy of a stress is |L^-1 sigma|^2.
class StiffnessRoot
{
public:
  explicit StiffnessRoot(const Elasticity& law) : strains_(std::size_t(law.strains()))
  {
    for (std::size_t j = 0; j < strains_; ++j)
      for (std::size_t i = j; i < strains_; ++i) {
        double value = law(int(i), int(j));
        for (std::size_t k = 0; k < j; ++k)
          value -= L_[i][k] * L_[j][k];
        L_[i][j] = i == j ? std::sqrt(value) : value / L_[j][j];
      }
  }

  double energy(const double* sigma) const
  {
    double sum = 0.0, x[6];
    for (std::size_t i = 0; i < strains_; ++i) {
      x[i] = sigma[i];
      for (std::size_t k = 0; k < i; ++k)
        x[i] -= L_[i][k] * x[k];
      x[i] /= L_[i][i];
      sum += x[i] * x[i];
    }
    return sum;
  }

private:
  std::size_t strains_;
  double L_[6][6] = {};
};

} // namespace

double SplitStress::energy(const Elasticity& law) const
{
  const StiffnessRoot root(law);
  const int modes = referenceStress(dim, degree).basis.size(), strains = numStrains(dim);
  double sum = 0.0;
  for (int sub = 0; sub <= dim; ++sub)
    for (int m = 0; m < modes; ++m) {
      double S[6];
      double sigma[6] = {};
      for (int s = 0; s < strains; ++s)
        S[s] = coefficients[(std::size_t(sub) * std::size_t(strains) + std::size_t(s)) * std::size_t(modes) +
                            std::size_t(m)];
      transformStress(dim, map.F.data(), 1.0 / map.det, S, sigma);
      sum += root.energy(sigma);
    }
  // The functions are orthonormal for the mean value over a sub-cell.
  return sum * referenceMeasure(dim) * map.det / (dim + 1);
}

} // namespace ndframe
