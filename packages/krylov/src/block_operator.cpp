#include "block_operator.hpp"

#include <algorithm>
#include <cmath>

#include "block_product.hpp"

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

BlockOperator::BlockOperator(const RankProblem& problem, const Comm& comm)
    : matrix_(*problem.matrix), dofMap_(ownedMap(matrix_.nodes, matrix_.dim, teuchosComm(comm)))
{
  for (int r = 0; r < matrix_.numRows(); ++r)
    for (int i = 0; i < matrix_.dim; ++i)
      interior_.push_back(problem.role(r, i) == DofRole::Interior);
  if (comm.size() == 1)
    return;
  const auto seenMap = heldMap(matrix_.nodes, matrix_.dim, dofMap_->getComm());
  halo_.emplace(dofMap_, seenMap);
  seen_ = Teuchos::rcp(new TpetraVectors(seenMap, 1));
}

Teuchos::ArrayRCP<const double> BlockOperator::seen(const TpetraVectors& x) const
{
  if (!halo_)
    return x.getData(0);
  halo_->fetch(x, *seen_);
  return seen_->getData(0);
}

void BlockOperator::multiply(const TpetraVectors& x, double* y) const
{
  const auto values = seen(x);
  multiplyBlocks(matrix_, values.getRawPtr(), std::size_t(values.size()), y);
  for (std::size_t dof = 0; dof < interior_.size(); ++dof)
    if (!interior_[dof])
      y[dof] = 0.0;
  ++products_;
}

void BlockOperator::sizes(const TpetraVectors& x, double* y) const
{
  const auto values = seen(x);
  const auto dim = std::size_t(matrix_.dim);
  const double* entry = matrix_.values.data();
  std::fill_n(y, interior_.size(), 0.0);
  for (std::size_t r = 0; r < std::size_t(matrix_.numRows()); ++r)
    for (auto b = std::size_t(matrix_.rowPtr[r]); b < std::size_t(matrix_.rowPtr[r + 1]); ++b)
      for (std::size_t i = 0; i < dim; ++i)
        for (std::size_t j = 0; j < dim; ++j)
          y[r * dim + i] += std::abs(*entry++ * values.getRawPtr()[std::size_t(matrix_.cols[b]) * dim + j]);
}

std::vector<std::int64_t> BlockOperator::numbers() const
{
  std::vector<std::int64_t> all;
  for (int r = 0; r < matrix_.numRows(); ++r)
    for (int i = 0; i < matrix_.dim; ++i)
      all.push_back(matrix_.nodes.global(r) * matrix_.dim + i);
  return all;
}

std::vector<double> BlockOperator::inverseDiagonal() const
{
  std::vector<double> inverse(interior_.size(), 0.0);
  const auto dim = std::size_t(matrix_.dim);
  for (std::size_t r = 0; r < std::size_t(matrix_.numRows()); ++r)
    for (auto b = std::size_t(matrix_.rowPtr[r]); b < std::size_t(matrix_.rowPtr[r + 1]); ++b)
      if (matrix_.cols[b] == int(r))
        for (std::size_t i = 0; i < dim; ++i)
          if (interior_[r * dim + i])
            inverse[r * dim + i] = 1.0 / matrix_.values[(b * dim + i) * dim + i];
  return inverse;
}

} // namespace ndframe
