// Measures the recovery of equilibrated stresses on a clamped, stretched block: microseconds per triangle.
// docs/performance.md says how to read it.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <numeric>
#include <random>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "batched_cell_pass.hpp"
#include "batched_stars.hpp"
#include "batched_workspace.hpp"
#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/assembly/body_system.hpp"
#include "ndframe/recovery/reference_stress.hpp"

using namespace ndframe;

namespace
{

/// Processor seconds, so that a busy machine disturbs less: the median of several runs.
double median(int runs, const std::function<void()>& work)
{
  std::vector<double> seconds;
  for (int run = 0; run < runs; ++run) {
    const std::clock_t start = std::clock();
    work();
    seconds.push_back(double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::nth_element(seconds.begin(), seconds.begin() + runs / 2, seconds.end());
  return seconds[std::size_t(runs / 2)];
}

/// About so many triangles on the unit square: squares with moved corners, cut along a diagonal by chance, so that
/// vertices have 4 to 8 cells.
Mesh randomSquare(int triangles)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shake(-0.2, 0.2);
  const int n = std::max(1, int(std::lround(std::sqrt(triangles / 2.0))));
  Mesh mesh;
  mesh.dim = 2;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool inside = i > 0 && i < n && j > 0 && j < n;
      for (const int k : {i, j})
        mesh.points.push_back((k + (inside ? shake(random) : 0.0)) / n);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      const bool rising = random() % 2 == 0;
      for (const int vertex : rising ? std::array{a, b, c, a, c, d} : std::array{a, b, d, b, c, d})
        mesh.cells.push_back(vertex);
    }
  return mesh;
}

/// A steel-like block in plane strain, E = 1, nu = 0.3.
BodyModel makeBlock(int triangles)
{
  const double nu = 0.3, shear = 1.0 / (2.0 * (1.0 + nu));
  BodyModel body;
  body.name = "block";
  body.mesh = randomSquare(triangles);
  body.nodes = makeNodeMap(body.mesh, 2);
  body.law = reduceTo(Hypothesis::PlaneStrain,
                      *orthotropicStiffness({1, -nu, -nu, -nu, 1, -nu, -nu, -nu, 1}, {shear, shear, shear}));
  return body;
}

/// Held on the left, pulled and sheared on the right.
ConstraintSet makeConstraints(const BodyModel& body)
{
  ConstraintSet constraints(2, 1.0);
  for (int node = 0; node < body.nodes.numNodes(); ++node) {
    const double x = body.nodes.point(node)[0];
    if (x == 0.0 || x == 1.0) {
      constraints.add({node, {1.0, 0.0, 0.0}, 0.01 * x});
      constraints.add({node, {0.0, 1.0, 0.0}, 0.005 * x});
    }
  }
  return constraints;
}

/// The data that go with these constraints: reactions on both ends, no loads.
StaticData makeData(const BodyModel& body, int degree)
{
  StaticData data;
  data.dim = data.order = 2;
  data.degree = degree;
  for (int cell = 0; cell < body.mesh.numCells(); ++cell)
    for (int local = 0; local < 3; ++local) {
      int ends[2];
      facetVertices(body.mesh, {cell, local}, ends);
      const double x = body.mesh.point(ends[0])[0];
      if (x == body.mesh.point(ends[1])[0] && (x == 0.0 || x == 1.0))
        data.boundary.push_back({{cell, local}, 2, {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}}});
    }
  data.facetShares.assign(data.boundary.size() * std::size_t(4 * (degree + 1)), 0.0);
  return data;
}

/// Fills the components' parameters with their defaults.
Params defaultsOf(const Choices& choices, const std::string& type)
{
  ListSpec spec;
  spec.choices = choices;
  Diagnostics diagnostics;
  const std::string deck = fmt::format(
      R"(<ParameterList name="deck"><Parameter name="Type" type="string" value="{}"/></ParameterList>)", type);
  Params params = validate(parseDeck(deck, "benchmark"), spec, diagnostics);
  diagnostics.throwIfAny();
  return params;
}

/// u_h, and the seconds that the factorisation takes.
Vector solveBlock(const BodyModel& body, double& seconds)
{
  Registry<LinearSolver> solvers("solver");
  registerLinearSolvers(solvers);
  const auto solver = solvers.build(defaultsOf(solvers.choices(), "Cholmod"));
  std::vector<int> nodes(std::size_t(body.nodes.numNodes()));
  std::iota(nodes.begin(), nodes.end(), 0);
  const BodySystem system = assembleBody(body, makeDofLayout(body.nodes, makeConstraints(body), {}), nodes);
  SolverProblem problem{&system.K, system.dofs.roles, {}, {}, body.nodes.points};
  Ledger ledger;
  std::unique_ptr<CondensedBody> factor;
  seconds = median(1, [&] { factor = solver->factor(problem, Comm::single(), ledger); });
  const DenseMatrix u = factor->expand(DenseMatrix(system.effectiveLoad(Comm::single())), DenseMatrix(0, 1));
  Vector solution = u.column(0);
  for (std::size_t i = 0; i < solution.size(); ++i)
    solution[i] += system.dofs.prescribed[i];
  return solution;
}

std::vector<StressCorrection> zeroCorrections(const BodyModel& body, int degree, int fields)
{
  StressCorrection zero;
  zero.dim = 2;
  zero.degree = degree;
  const ReferenceStress& reference = referenceStress(2, degree);
  zero.tractions.assign(std::size_t(reference.tractions) * std::size_t(body.mesh.numCells()), 0.0);
  zero.loads.assign(std::size_t(reference.loads) * std::size_t(body.mesh.numCells()), 0.0);
  return std::vector<StressCorrection>(std::size_t(fields), zero);
}

/// Vectors of a correction and the stress at the vertices, per triangle and field.
double bytesPerTriangle(int degree)
{
  const ReferenceStress& reference = referenceStress(2, degree);
  return double(sizeof(double)) * (reference.tractions + reference.loads + 9);
}

struct Timing
{
  double connectivity, stars, distances, imbalance;
};

Timing measure(const BodyModel& body, const Vector& displacement, int degree, int numFields,
               const BatchedKernels& kernels, int runs)
{
  const StaticData data = makeData(body, degree);
  const std::vector<FieldInput> fields(std::size_t(numFields), FieldInput{&displacement, nullptr});
  std::vector<int> vertices(std::size_t(body.mesh.numPoints()));
  std::iota(vertices.begin(), vertices.end(), 0);
  const BatchedStars stars(body, data, kernels);
  std::vector<StressCorrection> corrections;
  Timing timing{};
  timing.connectivity = median(runs, [&] { BatchedStars again(body, data, kernels); });
  timing.stars = median(runs, [&] {
    corrections = zeroCorrections(body, degree, numFields);
    stars.add(fields, vertices, corrections);
  });
  timing.distances = median(runs, [&] {
    for (const StressCorrection& correction : corrections)
      batchedCellDistances(body, correction, &displacement, kernels);
  });
  timing.imbalance = corrections[0].imbalance / corrections[0].force;
  return timing;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Measures the recovery of equilibrated stresses on a block of P2 triangles, one thread.");
  int triangles = 62000, runs = 9;
  std::string instructions;
  app.add_option("triangles", triangles, "About how many")->check(CLI::PositiveNumber);
  app.add_option("--runs", runs, "Medians of so many runs")->check(CLI::PositiveNumber);
  app.add_option("--instructions", instructions, "portable, avx2 or avx512; all that the machine has when not given");
  CLI11_PARSE(app, argc, argv);

  const BodyModel body = makeBlock(triangles);
  const double perTriangle = 1e6 / body.mesh.numCells();
  double factorisation = 0.0;
  const Vector displacement = solveBlock(body, factorisation);
  fmt::print("{} triangles, {} dofs; microseconds per triangle, medians of {} runs\n", body.mesh.numCells(),
             body.numDofs(), runs);
  fmt::print("factorisation with its ordering (Cholmod): {:.2f}\n\n", factorisation * perTriangle);
  fmt::print("instructions  degree  fields   total  connectivity   stars  distances   bytes/field  imbalance\n");
  for (const BatchedKernels* kernels : availableKernels())
    for (const int degree : {2, 3})
      for (const int fields : {1, 3}) {
        if (!instructions.empty() && instructions != kernels->name)
          continue;
        const Timing t = measure(body, displacement, degree, fields, *kernels, runs);
        fmt::print("{:12}  {:6}  {:6}  {:6.2f}  {:12.2f}  {:6.2f}  {:9.2f}  {:12.0f}  {:9.1e}\n", kernels->name, degree,
                   fields, (t.connectivity + t.stars + t.distances) * perTriangle, t.connectivity * perTriangle,
                   t.stars * perTriangle, t.distances * perTriangle, bytesPerTriangle(degree), t.imbalance);
      }
}
