// Measures the recovery of equilibrated stresses on a clamped, stretched block: microseconds per triangle.
// docs/performance.md says how to read it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <functional>
#include <numeric>
#include <random>

#include <malloc.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "batched_cell_pass.hpp"
#include "batched_workspace.hpp"
#include "ndframe/algebra/linear_solver.hpp"
#include "ndframe/assembly/body_system.hpp"
#include "ndframe/equilibrium/reference_stress.hpp"
#include "ndframe/iterative/linear_solvers.hpp"
#include "ndframe/simd/batched_stars.hpp"

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
  body.laws = reduceTo(Hypothesis::PlaneStrain,
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
  data.facetShares.assign(data.boundary.size() * 4 * std::size_t(degree + 1), 0.0);
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

/// u_h; the ledger gets the factorisation's stages.
Vector solveBlock(const BodyModel& body, Ledger& ledger)
{
  Registry<LinearSolver> solvers("solver");
  registerLinearSolvers(solvers);
  const auto solver = solvers.build(defaultsOf(solvers.choices(), "Cholmod"));
  std::vector<int> nodes(std::size_t(body.nodes.numNodes()));
  std::iota(nodes.begin(), nodes.end(), 0);
  const BodySystem system = assembleBody(body, makeDofLayout(body.nodes, makeConstraints(body), {}), nodes);
  SolverProblem problem;
  problem.matrix = &system.K;
  problem.roles = system.dofs.roles;
  problem.nodePoints = nodePoints(body.nodes);
  const auto factor = solver->factor(problem, Comm::single(), ledger);
  const DenseMatrix u =
      factor->expand(DenseMatrix(system.effectiveLoad(Comm::single()).all().whole()), DenseMatrix(0, 1));
  Vector solution = u.column(0);
  for (const auto& [dof, value] : system.dofs.prescribed)
    solution[std::size_t(dof)] += value;
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

/// By how much the resident memory grows at most while `work` runs.
std::int64_t peakGrowth(const std::function<void()>& work)
{
  malloc_trim(0); // what earlier work has freed does not hide what this one needs
  Ledger ledger;
  {
    const auto timer = ledger.time("before");
  }
  {
    const auto timer = ledger.time("work");
    work();
  }
  return ledger.stages()[1].peakBytes - ledger.stages()[0].peakBytes;
}

struct Measured
{
  double connectivity, stars, distances; ///< seconds
  std::int64_t bytes;
  double imbalance;
};

Measured measure(const BodyModel& body, const Vector& displacement, int degree, int numFields,
                 const BatchedKernels& kernels, int runs)
{
  const StaticData data = makeData(body, degree);
  const std::vector<FieldInput> fields(std::size_t(numFields), FieldInput{&displacement, nullptr});
  std::vector<int> vertices(std::size_t(body.mesh.numPoints()));
  std::iota(vertices.begin(), vertices.end(), 0);
  std::vector<StressCorrection> corrections;
  const auto solve = [&](const BatchedStars& stars) {
    corrections.clear();
    corrections = zeroCorrections(body, degree, numFields);
    stars.add(fields, vertices, corrections);
  };
  const auto takeDistances = [&] {
    for (const StressCorrection& correction : corrections)
      batchedCellDistances(body, correction, &displacement, kernels);
  };
  Measured measured{};
  measured.bytes = peakGrowth([&] {
    solve(BatchedStars(body, data, kernels));
    takeDistances();
  });
  const BatchedStars stars(body, data, kernels);
  measured.connectivity = median(runs, [&] { BatchedStars again(body, data, kernels); });
  measured.stars = median(runs, [&] { solve(stars); });
  measured.distances = median(runs, takeDistances);
  measured.imbalance = corrections[0].imbalance / corrections[0].force;
  return measured;
}

void printRow(const Measured& m, const char* instructions, int degree, int fields, int cells)
{
  const double us = 1e6 / cells;
  fmt::print("{:12}  {:6}  {:6}  {:6.2f}  {:12.2f}  {:6.2f}  {:9.2f}  {:12.0f}  {:9.1e}\n", instructions, degree,
             fields, (m.connectivity + m.stars + m.distances) * us, m.connectivity * us, m.stars * us, m.distances * us,
             double(m.bytes) / cells / fields, m.imbalance);
}

} // namespace

int main(int argc, char** argv)
try {
  CLI::App app("Measures the recovery of equilibrated stresses on a block of P2 triangles, one thread.");
  int triangles = 62000, runs = 9;
  std::string instructions;
  app.add_option("triangles", triangles, "About how many")->check(CLI::PositiveNumber);
  app.add_option("--runs", runs, "Medians of so many runs")->check(CLI::PositiveNumber);
  app.add_option("--instructions", instructions, "portable, avx2 or avx512; all that the machine has when not given")
      ->check(CLI::IsMember({"portable", "avx2", "avx512"}));
  CLI11_PARSE(app, argc, argv);

  const BodyModel body = makeBlock(triangles);
  const int cells = body.mesh.numCells();
  Ledger ledger;
  const Vector displacement = solveBlock(body, ledger);
  fmt::print("{} triangles, {} dofs; microseconds per triangle, medians of {} runs\n", cells, body.numDofs(), runs);
  for (const Ledger::Stage& stage : ledger.stages())
    fmt::print("Cholmod, {}: {:.2f}\n", stage.name, stage.seconds * 1e6 / cells);
  fmt::print("\ninstructions  degree  fields   total  connectivity   stars  distances   bytes/field  imbalance\n");
  for (const BatchedKernels* kernels : availableKernels())
    for (const int degree : {2, 3})
      for (const int fields : {1, 3})
        if (instructions.empty() || instructions == kernels->name)
          printRow(measure(body, displacement, degree, fields, *kernels, runs), kernels->name, degree, fields, cells);
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
