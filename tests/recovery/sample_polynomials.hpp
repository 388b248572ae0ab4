#pragma once

#include <array>
#include <map>
#include <string>

#include "admissibility/sample_problems.hpp"

namespace ndframe::test
{

/// A polynomial in x, y, z.
class Polynomial
{
public:
  using Powers = std::array<int, 3>;

  Polynomial() = default;
  explicit Polynomial(std::map<Powers, double> terms) : terms_(std::move(terms)) {}

  double operator()(const double* x, int dim) const;
  Polynomial derivative(int variable) const;
  Polynomial& add(double factor, const Polynomial& other);
  /// As a deck writes it.
  std::string text() const;

private:
  std::map<Powers, double> terms_;
};

/// A displacement field u = x (...), zero on x = 0, of degree `degree`, and its stress for a law (Voigt).
struct ExactField
{
  int dim;
  std::array<Polynomial, 3> displacement;
  std::array<Polynomial, 6> stress;
};

ExactField exactField(int dim, int degree, const Elasticity& law, unsigned seed);

/// The box of sampleMesh clamped at x = 0 under the loads that make `exact` its solution; the same law.
Conditions loadsOf(const ExactField& exact);

/// |K eps(u) - sigma|^2 in the complementary energy norm, sigma given cell by cell, by quadrature.
double distance(const ExactField& exact, const BodyModel& body,
                const std::function<void(int cell, int sub, const double* lambda, double* sigma)>& stress);

} // namespace ndframe::test
