#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "ndframe/adaptivity/marking.hpp"

namespace ndframe
{
namespace
{

/// Halving dim times is one refinement: all edges of a cell are halved.
double oneRefinement(const ContributionModel& model)
{
  return model.decay().dim;
}

/// The parts of a cell that is halved n times.
CellSize halved(const ContributionModel::Cell& cell, double halvings)
{
  CellSize size;
  size.logMeasure = size.leastLogMeasure = std::log2(cell.measure) - halvings;
  return size;
}

/// sizeOf: of one cell.
template <class SizeOf>
SizeField fieldOf(const ContributionModel& model, const SizeOf& sizeOf)
{
  SizeField field;
  for (const auto& body : model.cells()) {
    field.emplace_back();
    for (const ContributionModel::Cell& cell : body)
      field.back().push_back(sizeOf(cell));
  }
  return field;
}

/// Cells in which every part of the next mesh contributes the same.
class Predicted final : public Marking
{
public:
  SizeField sizes(const ContributionModel& model, double target) const override
  {
    const double level = predictRefinement(model.decays(), target, model.decay()).level;
    return fieldOf(model, [&](const ContributionModel::Cell& cell) { return sizeOf(model, cell, level); });
  }

  std::optional<std::int64_t> cellsFor(const ContributionModel& model, double target) const override
  {
    return predictRefinement(model.decays(), target, model.decay()).numCells;
  }

private:
  /// Smooth cells are halved at most so often at once, cells at a corner twice as often.
  static constexpr double mostHalvings = 8.0;
  static constexpr double mostDoublings = 3.0; ///< of the measure, where meshes are made anew

  /// Solves eta^2 = 2^level of ContributionModel for the measure.
  static CellSize sizeOf(const ContributionModel& model, const ContributionModel::Cell& cell, double level)
  {
    const ErrorDecay decay = model.decay();
    const double halvings = (cell.decay.logSquared - level) / decay.ofCell();
    if (!cell.atPlace)
      return halved(cell, std::clamp(halvings, model.areMadeAnew() ? -mostDoublings : 0.0, mostHalvings));
    CellSize size;
    size.gradation = decay.smoothExponent() / decay.ofCell() - cell.decay.exponent / decay.ofCell();
    size.logMeasure = std::log2(cell.measure) - halvings - size.gradation * std::log2(cell.squaredDistance);
    size.leastLogMeasure = std::log2(cell.measure) - 2.0 * mostHalvings;
    if (model.areMadeAnew()) { // parts that touch the edge, whose distance from it goes with their size
      const double ofTouching = (2.0 * cell.decay.exponent + 1.0) / 3.0;
      size.leastLogMeasure =
          std::max(size.leastLogMeasure, std::log2(cell.measure) - halvings * decay.ofCell() / ofTouching);
    }
    size.place = cell.place;
    return size;
  }
};

/// Halves the cells with the largest contributions: twice in the plane; once in space, where a refinement at once costs
/// a quarter more dofs.
class Doerfler final : public Marking
{
public:
  explicit Doerfler(double fraction) : fraction_(fraction) {}

  SizeField sizes(const ContributionModel& model, double) const override
  {
    const double least = leastMarked(model), halvings = model.decay().dim == 2 ? oneRefinement(model) : 1.0;
    return fieldOf(model, [&](const ContributionModel::Cell& cell) {
      return halved(cell, cell.decay.logSquared >= least ? halvings : 0.0);
    });
  }

  std::optional<std::int64_t> cellsFor(const ContributionModel&, double) const override { return std::nullopt; }

private:
  /// log2 eta_K^2 of the last cell that is needed for the fraction of the sum. Equal cells are marked together: then
  /// nothing depends on their order.
  double leastMarked(const ContributionModel& model) const
  {
    std::vector<double> contributions;
    double all = 0.0, marked = 0.0;
    for (const auto& body : model.cells())
      for (const ContributionModel::Cell& cell : body) {
        contributions.push_back(cell.decay.logSquared);
        all += std::exp2(cell.decay.logSquared);
      }
    std::sort(contributions.begin(), contributions.end(), std::greater<>());
    for (const double contribution : contributions) {
      marked += std::exp2(contribution);
      if (marked >= fraction_ * all)
        return contribution - 1e-6; // equal up to round-off
    }
    return -std::numeric_limits<double>::infinity();
  }

  double fraction_;
};

class Uniform final : public Marking
{
public:
  SizeField sizes(const ContributionModel& model, double) const override
  {
    return fieldOf(model, [&](const ContributionModel::Cell& cell) { return halved(cell, oneRefinement(model)); });
  }

  std::optional<std::int64_t> cellsFor(const ContributionModel&, double) const override { return std::nullopt; }
};

} // namespace

void registerMarkings(Registry<Marking>& registry)
{
  registry.add("Predicted",
               "Sizes for which all cells of the next mesh contribute equally, from the rate at which contributions "
               "fall: learned at corners and edges, dofs^-1 (second order; in 3D dofs^-2/3) elsewhere. Three to six "
               "meshes to a target.",
               {}, [](const Params&) { return std::make_unique<Predicted>(); });
  registry.add("Doerfler",
               "Doerfler marking: the cells with the largest contributions are bisected, triangles twice: as few as "
               "make up a fraction of the sum of squares. Many meshes, and no prediction.",
               {{"Fraction", 0.6, inOpenRange(0.0, 1.0), "Of the sum of squared contributions."}},
               [](const Params& params) { return std::make_unique<Doerfler>(params.get<double>("Fraction")); });
  registry.add("Uniform", "All edges are halved: what a target costs without knowing where the error is.", {},
               [](const Params&) { return std::make_unique<Uniform>(); });
}

} // namespace ndframe
