#pragma once

#include <Tpetra_Import.hpp>

#include "tpetra_system.hpp"

namespace ndframe
{

/// K of a body on its interior dofs, in the blocks in which it was assembled: no copy of it. Vectors have all dofs of
/// this rank's nodes and are zero where a dof is not interior; so is what comes out.
class BlockOperator final : public TpetraOperator
{
public:
  BlockOperator(const SolverProblem& problem, const Comm& comm);

  Teuchos::RCP<const TpetraMap> getDomainMap() const override { return dofMap_; }
  Teuchos::RCP<const TpetraMap> getRangeMap() const override { return dofMap_; }
  void apply(const TpetraVectors& x, TpetraVectors& y, Teuchos::ETransp mode, double alpha, double beta) const override;

  /// row(i, (K x)_i) for all dofs of this rank, in ascending order. It must not change x.
  template <class Row>
  void eachRow(const TpetraVectors& x, const Row& row) const
  {
    const auto values = seen(x);
    if (matrix_.dim == 2)
      eachRowOf<2>(values.getRawPtr(), row);
    else
      eachRowOf<3>(values.getRawPtr(), row);
    ++products_;
  }

  /// 1 / K_ii, zero where a dof is not interior.
  std::vector<double> inverseDiagonal() const;
  const std::vector<char>& interior() const { return interior_; } ///< per dof of this rank
  int products() const { return products_; }                      ///< so far

private:
  /// x with the values of other ranks that the rows need.
  Teuchos::ArrayRCP<const double> seen(const TpetraVectors& x) const;

  template <int dim, class Row>
  void eachRowOf(const double* x, const Row& row) const
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
        row(dof, interior[dof] ? sum[i] : 0.0);
      }
    }
  }

  const BlockMatrix& matrix_;
  Teuchos::RCP<const TpetraMap> dofMap_;
  std::vector<char> interior_;
  std::vector<int> columns_; ///< per block its column as this rank numbers nodes; empty on one rank
  Teuchos::RCP<const Tpetra::Import<>> import_;
  Teuchos::RCP<TpetraVectors> seen_; ///< null on one rank
  mutable int products_ = 0;
};

} // namespace ndframe
