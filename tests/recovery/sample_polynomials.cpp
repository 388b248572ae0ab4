#include "sample_polynomials.hpp"

#include <cmath>

#include <fmt/format.h>

#include "ndframe/fem/quadrature.hpp"

namespace ndframe::test
{

namespace
{

/// Places of the stress components (i, j) in Voigt notation.
int voigtPlace(int dim, int i, int j)
{
  constexpr int inSpace[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  return dim == 2 && i != j ? 2 : inSpace[i][j];
}

/// Engineering strains of a displacement field.
std::array<Polynomial, 6> strains(int dim, const std::array<Polynomial, 3>& u)
{
  std::array<Polynomial, 6> strain;
  for (int i = 0; i < dim; ++i)
    for (int j = 0; j < dim; ++j) {
      // Both orders of a shear add up to the engineering strain.
      strain[std::size_t(voigtPlace(dim, i, j))].add(1.0, u[std::size_t(i)].derivative(j));
    }
  return strain;
}

} // namespace

double Polynomial::operator()(const double* x, int dim) const
{
  double sum = 0.0;
  for (const auto& [powers, coefficient] : terms_) {
    double term = coefficient;
    for (int i = 0; i < dim; ++i)
      term *= std::pow(x[i], powers[std::size_t(i)]);
    sum += term;
  }
  return sum;
}

Polynomial Polynomial::derivative(int variable) const
{
  Polynomial result;
  for (const auto& [powers, coefficient] : terms_)
    if (const int power = powers[std::size_t(variable)]; power > 0) {
      Powers lower = powers;
      --lower[std::size_t(variable)];
      result.terms_[lower] += power * coefficient;
    }
  return result;
}

Polynomial& Polynomial::add(double factor, const Polynomial& other)
{
  for (const auto& [powers, coefficient] : other.terms_)
    terms_[powers] += factor * coefficient;
  return *this;
}

std::string Polynomial::text() const
{
  std::string text = "0";
  for (const auto& [powers, coefficient] : terms_) {
    text += fmt::format(" + ({:.17g})", coefficient);
    for (std::size_t i = 0; i < 3; ++i)
      for (int k = 0; k < powers[i]; ++k)
        text += std::string("*") + "xyz"[i];
  }
  return text;
}

ExactField exactField(int dim, int degree, const Elasticity& law, unsigned seed)
{
  Random random(seed);
  ExactField field{dim, {}, {}};
  for (int component = 0; component < dim; ++component)
    for (int i = 1; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        for (int k = 0; i + j + k <= degree && (dim == 3 || k == 0); ++k)
          field.displacement[std::size_t(component)].add(1.0, Polynomial({{{i, j, k}, random()}}));
  const auto strain = strains(dim, field.displacement);
  for (int i = 0; i < law.strains(); ++i)
    for (int j = 0; j < law.strains(); ++j)
      field.stress[std::size_t(i)].add(law(i, j), strain[std::size_t(j)]);
  return field;
}

Conditions loadsOf(const ExactField& exact)
{
  const std::vector<std::string> keys = {"X", "Y", "Z"};
  const auto stress = [&exact](int i, int j) { return exact.stress[std::size_t(voigtPlace(exact.dim, i, j))]; };
  const std::map<std::string, std::pair<int, double>> sides =
      exact.dim == 2
          ? std::map<std::string, std::pair<int, double>>{{"right", {0, 1.0}}, {"bottom", {1, -1.0}}, {"top", {1, 1.0}}}
          : std::map<std::string, std::pair<int, double>>{{"right", {0, 1.0}},
                                                          {"front", {1, -1.0}},
                                                          {"back", {1, 1.0}},
                                                          {"bottom", {2, -1.0}},
                                                          {"top", {2, 1.0}}};
  Conditions conditions{{onSide("Clamp", "left")}, {}};
  for (const auto& [side, normal] : sides) {
    Condition traction = onSide("Traction", side);
    for (int i = 0; i < exact.dim; ++i)
      traction.entries.emplace_back(keys[std::size_t(i)],
                                    Polynomial().add(normal.second, stress(i, normal.first)).text());
    conditions.loads.push_back(traction);
  }
  Condition force{"Body Force", {}};
  for (int i = 0; i < exact.dim; ++i) {
    Polynomial b;
    for (int j = 0; j < exact.dim; ++j)
      b.add(-1.0, stress(i, j).derivative(j));
    force.entries.emplace_back(keys[std::size_t(i)], b.text());
  }
  conditions.loads.push_back(force);
  return conditions;
}

double distance(const ExactField& exact, const BodyModel& body,
                const std::function<void(int, int, const double*, double*)>& stress)
{
  const int dim = exact.dim, strainCount = body.laws(0).strains();
  const QuadratureRule rule = simplexRule(dim, 6);
  DenseMatrix D(strainCount, strainCount);
  for (int i = 0; i < strainCount; ++i)
    for (int j = 0; j < strainCount; ++j)
      D(i, j) = body.laws(0)(i, j);
  const DenseCholesky stiffness(D);
  double sum = 0.0;
  for (int cell = 0; cell < body.mesh.numCells(); ++cell) {
    const SortedCell sorted = sortedCell(body.mesh, cell);
    for (int sub = 0; sub <= dim; ++sub)
      for (int q = 0; q < rule.size(); ++q) {
        // Sub-cell `sub` has the barycentre in place of vertex `sub`.
        double lambda[4], x[3] = {}, sigma[6];
        for (int v = 0; v <= dim; ++v) {
          lambda[v] = (v == sub ? 0.0 : rule.point(q)[v]) + rule.point(q)[sub] / (dim + 1);
          for (int i = 0; i < dim; ++i)
            x[i] += lambda[v] * body.mesh.point(sorted.vertices[std::size_t(v)])[i];
        }
        stress(cell, sub, lambda, sigma);
        Vector difference;
        for (int s = 0; s < strainCount; ++s)
          difference.push_back(exact.stress[std::size_t(s)](x, dim) - sigma[s]);
        sum += rule.weights[std::size_t(q)] * cellMeasure(body.mesh, cell) / (dim + 1) *
               dot(difference, stiffness.solve(difference));
      }
  }
  return sum;
}

} // namespace ndframe::test
