#include "ndframe/algebra/yardstick.hpp"

#include <ctime>
#include <memory>

#include "free_matrix.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ordering.hpp"
#include "serial_openmp.hpp"

namespace ndframe
{

namespace
{

double processorSeconds()
{
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

/// Runs `step` and returns what it needed.
template <class Step>
Seconds timed(const Step& step)
{
  const Seconds start{wallSeconds(), processorSeconds()};
  step();
  return {wallSeconds() - start.wall, processorSeconds() - start.processor};
}

/// The problem with its kept dofs as interior ones.
SolverProblem withoutKept(const SolverProblem& problem)
{
  SolverProblem whole;
  whole.matrix = problem.matrix;
  whole.roles = problem.roles;
  for (const int dof : problem.kept)
    whole.roles[std::size_t(dof)] = DofRole::Interior;
  return whole;
}

/// CHOLMOD as its manual calls it, set up as in a run; fills the times of analysis, factorisation and solve.
void factorAndSolve(UpperTriangle A, std::vector<int> order, DenseMatrix load, Yardstick& result)
{
  cholmod_common common;
  startCholmod(common);
  cholmod_sparse matrix = viewOf(A);
  cholmod_dense b = viewOf(load);
  const SerialOpenMp serial;
  cholmod_factor* factor = nullptr;
  cholmod_dense* x = nullptr;
  result.factor = timed([&] {
    factor = cholmod_analyze_p(&matrix, order.data(), nullptr, 0, &common);
    cholmod_factorize(&matrix, factor, &common);
  });
  result.nonzeros = std::int64_t(common.lnz);
  result.flops = common.fl;
  const bool isFactored = common.status == CHOLMOD_OK;
  if (isFactored)
    result.solve = timed([&] { x = cholmod_solve(CHOLMOD_A, factor, &b, &common); });
  cholmod_free_dense(&x, &common);
  cholmod_free_factor(&factor, &common);
  cholmod_finish(&common);
  if (!isFactored)
    throw InputError("the yardstick needs bodies that CHOLMOD can factor; this one is singular or too large.");
}

} // namespace

Seconds& Seconds::operator+=(const Seconds& other)
{
  wall += other.wall;
  processor += other.processor;
  return *this;
}

Seconds Yardstick::total() const
{
  Seconds sum = order;
  sum += factor;
  return sum += solve;
}

Yardstick& Yardstick::operator+=(const Yardstick& other)
{
  dofs += other.dofs;
  nonzeros += other.nonzeros;
  flops += other.flops;
  order += other.order;
  factor += other.factor;
  solve += other.solve;
  return *this;
}

Yardstick measureYardstick(const SolverProblem& problem, const Vector& load)
{
  const Comm comm = Comm::single();
  const FreeDofs free(problem.roles);
  UpperTriangle A = freeUpperTriangle(problem, free);
  shiftKept(A, problem, free, Vector(problem.kept.size(), meanKeptDiagonal(problem, comm)));
  Vector freeLoad;
  for (const int dof : free.dofs)
    freeLoad.push_back(load[std::size_t(dof)]);
  const SolverProblem whole = withoutKept(problem);
  NodeGraph graph = interiorGraph(whole, comm);
  Yardstick result;
  result.dofs = free.size();
  std::vector<int> nodes;
  result.order = timed([&] { nodes = nestedDissection(std::move(graph)); });
  factorAndSolve(std::move(A), freeOrder(whole, free, nodes), DenseMatrix(std::move(freeLoad)), result);
  return result;
}

} // namespace ndframe
