#include "ndframe/algebra/split_body.hpp"

#include <algorithm>

#include "ndframe/algebra/joined_system.hpp"
#include "ndframe/algebra/solver_problem.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

/// (K u)_dof, zero when another rank owns the row.
double rowTimes(const BlockMatrix& K, int dof, const double* u)
{
  const int node = dof / K.dim, component = dof % K.dim;
  const int row = K.rowOf(node);
  if (row < 0)
    return 0.0;
  const auto r = std::size_t(row);
  double sum = 0.0;
  for (std::int64_t b = K.rowPtr[r]; b < K.rowPtr[r + 1]; ++b) {
    const double* entry = K.values.data() + (b * K.dim + component) * K.dim;
    const double* column = u + std::size_t(K.colNode(b)) * std::size_t(K.dim);
    for (int j = 0; j < K.dim; ++j)
      sum += entry[j] * column[j];
  }
  return sum;
}

} // namespace

SplitBody::SplitBody(const SolverProblem& problem, const Comm& comm, Ledger& ledger)
    : matrix_(*problem.matrix), kept_(problem.kept), motions_(ndframe::freeMotions(problem, comm)), comm_(comm),
      ledger_(ledger)
{}

DenseMatrix SplitBody::reduce(const DenseMatrix& load) const
{
  DenseMatrix g = keptRowsTimes(expand(load, DenseMatrix(numKept(), load.cols())));
  for (int j = 0; j < g.cols(); ++j)
    for (int c = 0; c < g.rows(); ++c)
      g(c, j) = load(kept_[std::size_t(c)], j) - g(c, j);
  return g;
}

Vector SplitBody::applySchur(const Vector& kept) const
{
  return keptRowsTimes(expand(DenseMatrix(numDofs(), 1), DenseMatrix(kept))).column(0);
}

const NeumannSolver& neumannSolver(const CondensedBody& body)
{
  const auto* solver = dynamic_cast<const NeumannSolver*>(&body);
  NDFRAME_ASSERT(solver != nullptr, "a condensed body has no Neumann solver");
  return *solver;
}

double toleranceFor(Exactness exactness, double tolerance)
{
  constexpr double looser = 1e3, most = 1e-7;
  return exactness == Exactness::Full ? tolerance : std::max(tolerance, std::min(looser * tolerance, most));
}

const WholeSolver* wholeSolver(const CondensedBody& body)
{
  const auto* solver = dynamic_cast<const WholeSolver*>(&body);
  return solver != nullptr && solver->solvesWhole() ? solver : nullptr;
}

void SplitBody::checkShapes(const DenseMatrix& load, const DenseMatrix& kept) const
{
  NDFRAME_ASSERT(load.rows() == numDofs(), "a load needs one row per dof");
  NDFRAME_ASSERT(kept.rows() == numKept(), "kept values need one row per kept dof");
  NDFRAME_ASSERT(load.cols() == kept.cols(), "loads and kept values need as many columns");
}

DenseMatrix SplitBody::keptRowsTimes(const DenseMatrix& u) const
{
  Vector products(kept_.size() * std::size_t(u.cols()));
  auto product = products.begin();
  for (int j = 0; j < u.cols(); ++j)
    for (const int dof : kept_)
      *product++ = rowTimes(matrix_, dof, u.col(j));
  comm_.sum(products);
  DenseMatrix result(numKept(), u.cols());
  std::copy(products.begin(), products.end(), result.data());
  return result;
}

} // namespace ndframe
