// A program of another project: ndframe with a relaxation controller and a coupling of its own.

#include <algorithm>
#include <cmath>

#include "ndframe/driver/main.hpp"

namespace
{

using namespace ndframe;

/// theta_p = 1 / p: the traction becomes the mean of all that the Dirichlet body answered.
class Averaging final : public RelaxationController
{
public:
  explicit Averaging(int firstSweep) : firstSweep_(firstSweep), sweep_(firstSweep) {}
  void start() override { sweep_ = firstSweep_; }
  RelaxedTraction next(const InterfaceValues& dirichlet, const InterfaceValues& neumann) override
  {
    const double theta = 1.0 / sweep_++;
    return {relax(dirichlet, neumann, theta), theta, {}};
  }
  RelaxationMemory memory() const override { return {{double(sweep_)}}; }
  bool recall(const RelaxationMemory& memory) override
  {
    if (memory.size() != 1 || memory.front().size() != 1)
      return false;
    sweep_ = int(memory.front().front());
    return true;
  }

private:
  int firstSweep_, sweep_;
};

void registerAveraging(Components& components)
{
  components.relaxations.add(
      "Averaging", "Mean of all answers.", {{"First Sweep", 1, atLeast(1), "Number of the first sweep."}},
      [](const Params& params) { return std::make_unique<Averaging>(params.get<int>("First Sweep")); });
}

/// The contact forces of bodies that their supports hold, by projected Gauss-Seidel on their flexibility.
class GaussSeidel final : public Coupling
{
public:
  GaussSeidel(int sweeps, double tolerance) : sweeps_(sweeps), tolerance_(tolerance) {}
  Roles roles() const override { return Roles::None; }

  CouplingResult solve(const InterfaceSystem& system, const SweepObserver& observe, Ledger& ledger,
                       const CouplingStart&) const override
  {
    const auto n = std::size_t(system.size());
    const UnknownValues none = ofUnknowns(Vector(n, 0.0));
    CouplingResult result;
    InterfaceState& state = result.state;
    state.forceDirichlet = none;
    displace(system, state);
    Vector opening = openingOf(system, state);
    DenseMatrix flexibility(system.size(), system.size());
    for (int j = 0; j < system.size(); ++j) {
      state.forceDirichlet = none;
      state.forceDirichlet[std::size_t(j)] = 1.0;
      displace(system, state);
      const Vector pushed = openingOf(system, state);
      for (int i = 0; i < system.size(); ++i)
        flexibility(i, j) = pushed[std::size_t(i)] - opening[std::size_t(i)];
    }
    state.forceDirichlet = none;
    SweepRecord record;
    for (double change = 1.0; record.sweep < sweeps_ && change > tolerance_; ++record.sweep)
      change = sweep(flexibility, opening, state.forceDirichlet);
    displace(system, state);
    state.forceNeumann = state.forceDirichlet;
    state.tractionDirichlet = state.tractionNeumann = system.traction(state.forceDirichlet);
    for (const double force : state.forceDirichlet)
      state.closed.push_back(force < 0.0);
    record.closed = int(std::count(state.closed.begin(), state.closed.end(), char(1)));
    result.converged = record.sweep < sweeps_;
    result.reason = "forces settled";
    result.history.push_back(record);
    observe(record, state);
    ledger.count("sweeps");
    return result;
  }

private:
  /// F r + opening <= 0, r <= 0, one force after the other; the largest change, relative.
  static double sweep(const DenseMatrix& F, const Vector& opening, UnknownValues& r)
  {
    double change = 0.0, largest = 0.0;
    for (int i = 0; i < F.rows(); ++i) {
      double w = opening[std::size_t(i)];
      for (int j = 0; j < F.cols(); ++j)
        w += F(i, j) * r[std::size_t(j)];
      const double next = std::min(0.0, r[std::size_t(i)] - w / F(i, i));
      change = std::max(change, std::abs(next - r[std::size_t(i)]));
      r[std::size_t(i)] = next;
      largest = std::max(largest, std::abs(next));
    }
    return largest > 0.0 ? change / largest : 0.0;
  }

  /// u = S^-1 (g + r) of every body.
  static void displace(const InterfaceSystem& system, InterfaceState& state)
  {
    state.uDirichlet = ofUnknowns(Vector(state.forceDirichlet.size(), 0.0));
    state.uNeumann = system.withObstacles(state.uDirichlet);
    for (const BodyTrace& body : system.bodies) {
      if (body.freeMotions.cols() > 0)
        throw NotConverged("Gauss-Seidel needs bodies that their supports hold");
      Vector load = body.forces(state.forceDirichlet, state.forceDirichlet);
      for (std::size_t k = 0; k < load.size(); ++k)
        load[k] += body.g[k];
      const Vector u = body.S->inverseOn(std::vector<char>(load.size(), 1), 0.0)->solve(load);
      for (std::size_t k = 0; k < u.size(); ++k)
        (body.roles[k] == ndframe::ContactRole::Dirichlet ? state.uDirichlet
                                                          : state.uNeumann)[std::size_t(body.unknowns[k])] = u[k];
    }
  }

  /// u1_N - u2_N - g.
  static Vector openingOf(const InterfaceSystem& system, const InterfaceState& state)
  {
    Vector opening;
    for (std::size_t i = 0; i < state.uDirichlet.size(); ++i)
      opening.push_back(state.uDirichlet[i] - state.uNeumann[i] - system.gap[i]);
    return opening;
  }

  int sweeps_;
  double tolerance_;
};

void registerOwn(Components& components)
{
  registerAveraging(components);
  components.couplings.add("Gauss-Seidel", "Force after force, for bodies that their supports hold.",
                           {{"Maximum Sweeps", 1000, atLeast(1), "More count as not converged."},
                            {"Tolerance", 1e-13, inOpenRange(0.0, 1.0), "Of the largest force."}},
                           [](const Params& params) {
                             return std::make_unique<GaussSeidel>(params.get<int>("Maximum Sweeps"),
                                                                  params.get<double>("Tolerance"));
                           });
}

} // namespace

int main(int argc, char** argv)
{
  return ndframe::runMain(argc, argv, registerOwn);
}
