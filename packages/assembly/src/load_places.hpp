#pragma once

#include <functional>
#include <vector>

#include "ndframe/assembly/load_samples.hpp"

namespace ndframe
{

/// The facets or cells that a load acts on, by number. Load and mesh are kept elsewhere.
class LoadPlaces
{
public:
  LoadPlaces(const Load& load, const Mesh& mesh);

  int size() const { return size_; }
  bool areCells() const { return facets_ == nullptr; }
  bool isConstant() const { return areConstant(functions_); } ///< the load
  /// Only the cell counts where it acts in cells.
  Facet at(int number) const;
  /// A lower bound of the load's largest value on all of them, as DataSampler::scaleOn has it.
  double scaleOf(DataSampler& sampler) const;

  /// Facets or cells first ... last - 1.
  struct Range
  {
    int first, last;
  };
  Range all() const { return {0, size_}; }
  /// Visits a range with samples of the load. sampler, scale: of the load's functions; a load that is constant needs
  /// none.
  void visit(Range range, DataSampler* sampler, double scale,
             const std::function<void(const LoadedSimplex&)>& visit) const;
  /// Visits them without samples.
  void visit(const std::function<void(LoadedSimplex&)>& visit) const;

private:
  void visitConstant(Range range, const std::function<void(const LoadedSimplex&)>& visit) const;

  const Load& load_;
  const Mesh& mesh_;
  const std::vector<SampledFunction> functions_;
  const std::vector<Facet>* facets_; ///< null: cells
  std::vector<int> cells_;           ///< where it does not act in all of them
  int size_ = 0;
};

} // namespace ndframe
