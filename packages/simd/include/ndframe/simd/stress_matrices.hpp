#pragma once

#include <array>
#include <functional>
#include <vector>

#include "ndframe/equilibrium/cell_forms.hpp"
#include "ndframe/simd/class_matrices.hpp"

namespace ndframe
{

/// Parts of the matrices A_E of up to CellForms::lanes cells, reference axes.
struct CellFacets
{
  const int* cells; ///< their numbers
  int count;
  const CellMap* maps;       ///< one a lane
  const double* compliances; ///< per entry and lane
  CellForms::Facets facets;
};

/// Maps and pulled-back compliances (per entry and lane) of some cells; lanes without a cell repeat the last one.
void findCompliances(const StressCells& cells, const int* numbers, int count, CellMap* maps, Vector& compliances);

/// The energy matrices A_E of solids' cells as functions of their tractions. Large classes have theirs (ClassMatrices).
/// Those of the other cells are not kept, which would take 10 kB a cell and more time to read than to do without
/// (CellForms::apply). Cells go by batches of one class, or of cells without a class.
class StressMatrices
{
public:
  /// Cells that are multiplied together, and numbers of all their data.
  static constexpr int lanes = CellForms::lanes;
  static constexpr int mostNumbers = 84 * lanes;

  /// Of own cells; those of small classes are still to be found. All must outlive it.
  StressMatrices(const StressCells& cells, const ClassMatrices& ofClasses);

  /// Finds those of a batch without a class; batches may be found at the same time. use() sees them once.
  void find(int batch, Vector& work, const std::function<void(const CellFacets&)>& use);

  int numBatches() const { return int(batches_.size()); }
  bool isOfClass(int batch) const { return batches_[std::size_t(batch)].number < 0; }
  int sizeOf(int batch) const { return batches_[std::size_t(batch)].count; }
  const int* cells(int batch) const { return batches_[std::size_t(batch)].cells.data(); }
  /// forces = A_E T for the cells of a batch; both per number and lane, global axes.
  void multiply(int batch, const double* T, double* forces) const;
  /// The same times `unit`, which makes T and forces numbers of the order of one: in single precision where cells are
  /// not stretched, four digits and more. T and forces cell after cell, room for all lanes.
  void multiplyRounded(int batch, double unit, const float* T, float* forces) const;
  /// The same for tractions and loads, T and G, and by both, in double precision: of a batch with a class, and of found
  /// cells.
  void multiplyData(int batch, const double* x, double* forces) const;
  void multiplyData(const CellFacets& found, const double* x, double* forces) const;

private:
  struct Batch
  {
    std::array<int, lanes> cells;
    int count, number;    ///< among those without a class, rounded or not; -1: in a class
    bool isRound = false; ///< no cell is stretched much: forces in single precision are good enough for directions
  };

  std::vector<Batch> all() const;
  void multiplyClass(const Batch& batch, std::size_t size, const double* x, double* forces) const;
  void pushRounded(const Batch& batch, double unit, const float* T, float* forces) const;
  void roundMaps(const Batch& batch, const CellMap* maps);
  std::size_t compliances() const { return cells_->any().reference().energy.size() * lanes; }
  std::size_t roundedSize() const { return forms_.roundedSize() + std::size_t(9) * lanes; }
  std::size_t keptSize() const { return compliances() + forms_.factorSize() * lanes; }
  void multiplyFound(const CellFacets& found, std::size_t size, const double* x, double* forces) const;

  const StressCells* cells_;
  const ClassMatrices* ofClasses_;
  std::vector<Batch> batches_;
  std::size_t tractions_;
  const CellForms& forms_;
  std::vector<CellMap> maps_;  ///< of batches in kept_
  Vector scales_;              ///< per batch without a class and lane, of rounded numbers
  Vector kept_;                ///< compliances and factors
  std::vector<float> rounded_; ///< CellForms::round(), then F^-1
};

/// x = F^-1 x for all vectors of all lanes, and forces = F^-T forces.
void pullBackLanes(const CellMap* maps, int count, double* x);
void pushLanes(const CellMap* maps, int count, double* forces);

} // namespace ndframe
