#include "sample_waves.hpp"

#include <cmath>

#include <fmt/format.h>

#include "common/test_main.hpp"
#include "ndframe/equilibrium/equilibrated_stress.hpp"

namespace ndframe::test
{
namespace
{

/// Enough for the squares of a few waves on a cell.
constexpr int waveDegree = 12;

/// Engineering strain from the derivatives u_i,j.
Vector strainOf(int dim, const Vector& gradient)
{
  const auto sum = [&](int i, int j) {
    return gradient[std::size_t(i * dim + j)] + gradient[std::size_t(j * dim + i)];
  };
  if (dim == 2)
    return {gradient[0], gradient[3], sum(0, 1)};
  return {gradient[0], gradient[4], gradient[8], sum(0, 1), sum(1, 2), sum(0, 2)};
}

Vector stressOf(const Elasticity& law, const Vector& strain)
{
  Vector stress(strain.size(), 0.0);
  for (std::size_t i = 0; i < stress.size(); ++i)
    for (std::size_t j = 0; j < stress.size(); ++j)
      stress[i] += law(int(i), int(j)) * strain[j];
  return stress;
}

/// Row `i` of a Voigt stress times a vector.
double rowTimes(int dim, const double* stress, int i, const double* n)
{
  constexpr int inSpace[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  double sum = 0.0;
  for (int j = 0; j < dim; ++j)
    sum += stress[dim == 2 && i != j ? 2 : inSpace[i][j]] * n[j];
  return sum;
}

/// u = x sum_m a_m sin(k_m . x + phase_m), componentwise.
struct Waves
{
  static constexpr int count = 2;
  int dim;
  double k[count][3], amplitude[count][3], phase[count][3];

  /// u_i,j, or its derivative along x_l if l >= 0.
  Vector gradient(const double* x, int l = -1) const
  {
    Vector result(std::size_t(dim * dim), 0.0);
    for (int m = 0; m < count; ++m)
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) {
          double argument = phase[m][i];
          for (int d = 0; d < dim; ++d)
            argument += k[m][d] * x[d];
          const double f = std::sin(argument), df = std::cos(argument);
          const double value = l < 0 ? (j == 0) * f + x[0] * k[m][j] * df
                                     : (j == 0) * k[m][l] * df + (l == 0) * k[m][j] * df - x[0] * k[m][j] * k[m][l] * f;
          result[std::size_t(i * dim + j)] += amplitude[m][i] * value;
        }
    return result;
  }
};

/// The same derivatives as expressions: u_i,j, or their derivative along x_l if l >= 0.
std::vector<std::string> gradientText(const Waves& u, int l = -1)
{
  constexpr const char* axes[] = {"x", "y", "z"};
  std::vector<std::string> all;
  for (int i = 0; i < u.dim; ++i)
    for (int j = 0; j < u.dim; ++j) {
      std::string text = "0";
      for (int m = 0; m < Waves::count; ++m) {
        std::string argument = fmt::format("({:.17g})", u.phase[m][i]);
        for (int d = 0; d < u.dim; ++d)
          argument += fmt::format(" + ({:.17g})*{}", u.k[m][d], axes[d]);
        const double kj = u.k[m][j], kl = l < 0 ? 0.0 : u.k[m][l], a = u.amplitude[m][i];
        const std::string sine = "sin(" + argument + ")", cosine = "cos(" + argument + ")";
        text += l < 0 ? fmt::format(" + ({:.17g})*({}*{} + x*({:.17g})*{})", a, int(j == 0), sine, kj, cosine)
                      : fmt::format(" + ({:.17g})*(({:.17g})*{} - x*({:.17g})*{})", a, (j == 0) * kl + (l == 0) * kj,
                                    cosine, kj * kl, sine);
      }
      all.push_back(text);
    }
  return all;
}

/// The stress of these derivatives, Voigt.
std::vector<std::string> stressText(const Elasticity& law, const std::vector<std::string>& gradient)
{
  std::vector<std::string> stress;
  for (int s = 0; s < law.strains(); ++s) {
    std::string text = "0";
    for (std::size_t e = 0; e < gradient.size(); ++e) {
      Vector unit(gradient.size(), 0.0);
      unit[e] = 1.0;
      text += fmt::format(" + ({:.17g})*({})", stressOf(law, strainOf(law.dim, unit))[std::size_t(s)], gradient[e]);
    }
    stress.push_back(text);
  }
  return stress;
}

/// The traction or the force of an exact solution; side and place stand in the deck of the load that it replaces.
class ExactLoad final : public Load
{
public:
  ExactLoad(const Params& params, const ExactSolution& exact) : Load(params), exact_(exact) {}

  std::vector<SampledFunction> functions(int) const override
  {
    return params().has("Side") ? exact_.stressFunctions : exact_.forceFunctions;
  }

  void density(int dim, const double* values, const double* normal, double* q) const override
  {
    for (int i = 0; i < dim; ++i)
      q[i] = normal == nullptr ? values[i] : rowTimes(dim, values, i, normal);
  }

private:
  ExactSolution exact_;
};

} // namespace

SampledFunction functionOf(const std::string& text)
{
  return {std::make_shared<const ExpressionTree>(text), {}};
}

ExactSolution waveSolution(const Elasticity& law, double waves, unsigned seed)
{
  Random random(seed);
  const int dim = law.dim;
  Waves u{dim, {}, {}, {}};
  for (int m = 0; m < Waves::count; ++m)
    for (int d = 0; d < dim; ++d) {
      u.k[m][d] = 2.0 * M_PI * waves * random();
      u.amplitude[m][d] = random();
      u.phase[m][d] = M_PI * random();
    }
  const auto stress = [law, u](const double* x, int l) { return stressOf(law, strainOf(u.dim, u.gradient(x, l))); };
  ExactSolution exact;
  exact.dim = dim;
  exact.stress = [stress](const double* x, double* sigma) {
    const Vector values = stress(x, -1);
    std::copy(values.begin(), values.end(), sigma);
  };
  for (const auto& text : stressText(law, gradientText(u)))
    exact.stressFunctions.push_back(functionOf(text));
  constexpr int inSpace[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  std::vector<std::string> force(std::size_t(dim), "0");
  for (int l = 0; l < dim; ++l) {
    const auto derivative = stressText(law, gradientText(u, l));
    for (int i = 0; i < dim; ++i)
      force[std::size_t(i)] += " - (" + derivative[std::size_t(dim == 2 && i != l ? 2 : inSpace[i][l])] + ")";
  }
  for (const auto& text : force)
    exact.forceFunctions.push_back(functionOf(text));
  return exact;
}

Problem solvedUnder(const ExactSolution& exact, Mesh mesh, int order, int degree, const Elasticity& law)
{
  Conditions conditions{{onSide("Clamp", "left")}, {{"Body Force", {}}}};
  for (const Side& side : mesh.sides)
    if (side.name != "left")
      conditions.loads.push_back(onSide("Traction", side.name));
  BodyModel body = makeBody(std::move(mesh), order, conditions);
  body.laws = law;
  for (auto& load : body.loads)
    load = std::make_unique<ExactLoad>(load->params(), exact);
  return solved(std::move(body), degree);
}

Distances distances(const ExactSolution& exact, const Problem& problem, const StressCorrection& correction)
{
  const BodyModel& body = problem.body;
  const std::size_t strains = std::size_t(body.laws(0).strains());
  DenseMatrix D(body.laws(0).strains(), body.laws(0).strains());
  for (int i = 0; i < D.rows(); ++i)
    for (int j = 0; j < D.cols(); ++j)
      D(i, j) = body.laws(0)(i, j);
  const DenseCholesky stiffness(D);
  const auto square = [&stiffness](const Vector& stress) { return dot(stress, stiffness.solve(stress)); };
  StressCorrection none = correction;
  none.tractions.assign(none.tractions.size(), 0.0);
  none.loads.assign(none.loads.size(), 0.0);
  Distances sum;
  for (int cell = 0; cell < body.mesh.numCells(); ++cell) {
    const SplitStress equilibrated = equilibratedStress(body, problem.displacement, correction, cell);
    const SplitStress computed = equilibratedStress(body, problem.displacement, none, cell);
    overSubCells(exact.dim, waveDegree, [&](int sub, const double* lambda, double weight) {
      Vector sigma(strains), hat(strains), h(strains), mean(strains);
      exact.stress(pointOf(body.mesh, equilibrated.cell, lambda).data(), sigma.data());
      equilibrated.stress(sub, lambda, hat.data());
      computed.stress(sub, lambda, h.data());
      for (std::size_t s = 0; s < strains; ++s)
        mean[s] = 0.5 * (hat[s] + h[s]);
      const double volume = weight * cellMeasure(body.mesh, cell);
      sum.computed += volume * square(difference(sigma, h));
      sum.equilibrated += volume * square(difference(sigma, hat));
      sum.mean += volume * square(difference(sigma, mean));
    });
  }
  return sum;
}

} // namespace ndframe::test
