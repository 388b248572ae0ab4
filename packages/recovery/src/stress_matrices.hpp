#pragma once

#include <functional>
#include <vector>

#include "ndframe/equilibrium/cell_forms.hpp"
#include "star_body.hpp"

namespace ndframe
{

/// The matrices A_E (CellForm::condensed) of up to CellForms::lanes cells with successive numbers, double precision,
/// reference axes, over tractions and loads.
struct CellMatrices
{
  int cell, count;
  const CellMap* maps;
  const double* triangle; ///< below the diagonal, column by column, per entry CellForms::lanes cells
  int size;

  /// i >= j
  const double* entry(int i, int j) const
  {
    return triangle + (std::ptrdiff_t(j) * size - std::ptrdiff_t(j) * (j - 1) / 2 + i - j) * CellForms::lanes;
  }
  /// forces += A x for all cells; both lane by lane, of `size` numbers.
  void multiply(const double* x, double* forces) const;
};

/// The energy matrices A_E of some of a solid's cells (CellForm::condensed) as functions of the tractions alone. They
/// are not kept, which would take 10 kB a cell and more time to read than to do without (CellForms::apply). Cells go by
/// batches: those of a batch are lanes * batch .. lanes * batch + its size.
class StressMatrices
{
public:
  /// Cells that are multiplied together.
  static constexpr int lanes = CellForms::lanes;

  /// Of the batches first .. last, still to be found.
  StressMatrices(const StarBody& body, int first, int last);

  /// Finds those of some batches; batches may be found at the same time. use(): sees every matrix once.
  void find(int first, int last, const std::function<void(const CellMatrices&)>& use);

  static int numBatches(const StarBody& body) { return (body.model().mesh.numCells() + lanes - 1) / lanes; }
  int first() const { return first_; }
  int last() const { return last_; }
  int sizeOf(int batch) const;
  /// forces = A_E T for the cells of a batch; both cell by cell, global axes.
  void multiply(int batch, const double* T, double* forces) const;

private:
  std::size_t compliances() const { return body_->reference().energy.size() * lanes; }
  /// Where a batch's compliances are, and then its factors.
  std::size_t at(int batch) const
  {
    return std::size_t(batch - first_) * (compliances() + forms_.factorSize() * lanes);
  }

  const StarBody* body_;
  int first_, last_;
  std::size_t tractions_;
  CellForms forms_;
  std::vector<CellMap> maps_;
  Vector kept_;
};

/// F^-1 applied to a vector: what the reference cell sees of it.
void pullBack(const CellMap& map, const double* vector, double* result);
/// sum += F^-T applied to every vector of forces there: what they are in global axes.
void addPushed(const CellMap& map, const double* forces, int count, double* sum);

} // namespace ndframe
