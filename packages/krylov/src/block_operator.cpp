#include "block_operator.hpp"

#include "tpetra_maps.hpp"

namespace ndframe
{

void FineOperator::apply(const TpetraVectors& x, TpetraVectors& y, Teuchos::ETransp, double alpha, double beta) const
{
  std::vector<double> product(getDomainMap()->getNodeNumElements());
  for (std::size_t j = 0; j < x.getNumVectors(); ++j) {
    multiply(*x.getVector(j), product.data());
    const auto result = y.getDataNonConst(j);
    double* const values = result.getRawPtr();
    for (std::size_t i = 0; i < product.size(); ++i)
      values[i] = alpha * product[i] + (beta == 0.0 ? 0.0 : beta * values[i]);
  }
}

BlockOperator::BlockOperator(const SolverProblem& problem, const Comm& comm)
    : matrix_(*problem.matrix), dofMap_(mapOf(matrix_.rows, matrix_.dim, teuchosComm(comm)))
{
  for (const int node : matrix_.rows)
    for (int i = 0; i < matrix_.dim; ++i)
      interior_.push_back(problem.roles[std::size_t(node) * std::size_t(matrix_.dim) + std::size_t(i)] ==
                          DofRole::Interior);
  if (comm.size() == 1)
    return;
  LocalNodes local = columnNodes(matrix_);
  columns_.reserve(matrix_.cols.size());
  for (const int node : matrix_.cols)
    columns_.push_back(local.number(node));
  const auto seenMap = mapOf(local.nodes, matrix_.dim, dofMap_->getComm());
  import_ = Teuchos::rcp(new Tpetra::Import<>(dofMap_, seenMap));
  seen_ = Teuchos::rcp(new TpetraVectors(seenMap, 1));
}

Teuchos::ArrayRCP<const double> BlockOperator::seen(const TpetraVectors& x) const
{
  if (import_.is_null())
    return x.getData(0);
  seen_->doImport(x, *import_, Tpetra::INSERT);
  return seen_->getData(0);
}

template <int dim>
void BlockOperator::multiplyRows(const double* x, double* y) const
{
  const double* entry = matrix_.values.data();
  const int* column = columns_.empty() ? matrix_.cols.data() : columns_.data();
  const char* interior = interior_.data();
  const std::size_t rows = matrix_.rows.size();
  for (std::size_t r = 0; r < rows; ++r) {
    double sum[dim] = {};
    for (std::int64_t b = matrix_.rowPtr[r]; b < matrix_.rowPtr[r + 1]; ++b, ++column, entry += dim * dim) {
      const double* value = x + std::ptrdiff_t(*column) * dim;
      for (int i = 0; i < dim; ++i) { // a block's part by itself: sums of all blocks would wait for each other
        double part = entry[i * dim] * value[0];
        for (int j = 1; j < dim; ++j)
          part += entry[i * dim + j] * value[j];
        sum[i] += part;
      }
    }
    for (int i = 0; i < dim; ++i) {
      const std::size_t dof = r * dim + std::size_t(i);
      y[dof] = interior[dof] ? sum[i] : 0.0;
    }
  }
}

void BlockOperator::multiply(const TpetraVectors& x, double* y) const
{
  const auto values = seen(x);
  if (matrix_.dim == 2)
    multiplyRows<2>(values.getRawPtr(), y);
  else
    multiplyRows<3>(values.getRawPtr(), y);
  ++products_;
}

std::vector<double> BlockOperator::inverseDiagonal() const
{
  std::vector<double> inverse(interior_.size(), 0.0);
  const auto dim = std::size_t(matrix_.dim);
  for (std::size_t r = 0; r < matrix_.rows.size(); ++r)
    for (auto b = std::size_t(matrix_.rowPtr[r]); b < std::size_t(matrix_.rowPtr[r + 1]); ++b)
      if (matrix_.cols[b] == matrix_.rows[r])
        for (std::size_t i = 0; i < dim; ++i)
          if (interior_[r * dim + i])
            inverse[r * dim + i] = 1.0 / matrix_.values[(b * dim + i) * dim + i];
  return inverse;
}

} // namespace ndframe
