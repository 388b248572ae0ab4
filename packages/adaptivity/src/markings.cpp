#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "ndframe/adaptivity/marking.hpp"

namespace ndframe
{
namespace
{

/// Halving twice is one refinement: all edges of a cell are halved.
constexpr double oneRefinement = 2.0;

/// The parts of a cell that is halved n times.
CellSize halved(const ContributionModel::Cell& cell, double halvings)
{
  const double logArea = std::log2(cell.area) - halvings;
  CellSize size;
  size.logArea = size.leastLogArea = logArea;
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
    const double level = predictRefinement(model.decays(), target, model.degree()).level;
    return fieldOf(model, [&](const ContributionModel::Cell& cell) { return sizeOf(cell, level, model.degree()); });
  }

  std::optional<std::int64_t> cellsFor(const ContributionModel& model, double target) const override
  {
    return predictRefinement(model.decays(), target, model.degree()).numCells;
  }

private:
  /// Smooth cells are halved at most so often at once, cells at a corner twice as often.
  static constexpr double mostHalvings = 8.0;

  /// Solves eta^2 = 2^level of ContributionModel for the area.
  static CellSize sizeOf(const ContributionModel::Cell& cell, double level, int degree)
  {
    const double smooth = degree + 1.0, halvings = (cell.decay.logSquared - level) / smooth;
    if (!cell.atCorner)
      return halved(cell, std::clamp(halvings, 0.0, mostHalvings));
    CellSize size;
    size.gradation = 1.0 - cell.decay.exponent / smooth;
    size.logArea = std::log2(cell.area) - halvings - size.gradation * std::log2(cell.squaredDistance);
    size.leastLogArea = std::log2(cell.area) - 2.0 * mostHalvings;
    size.corner = cell.corner;
    return size;
  }
};

/// A refinement of the cells with the largest contributions.
class Doerfler final : public Marking
{
public:
  explicit Doerfler(double fraction) : fraction_(fraction) {}

  SizeField sizes(const ContributionModel& model, double) const override
  {
    const double least = leastMarked(model);
    return fieldOf(model, [&](const ContributionModel::Cell& cell) {
      return halved(cell, cell.decay.logSquared >= least ? oneRefinement : 0.0);
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
    return fieldOf(model, [](const ContributionModel::Cell& cell) { return halved(cell, oneRefinement); });
  }

  std::optional<std::int64_t> cellsFor(const ContributionModel&, double) const override { return std::nullopt; }
};

} // namespace

void registerMarkings(Registry<Marking>& registry)
{
  registry.add(
      "Predicted",
      "Sizes with which all cells of the next mesh contribute the same, from how contributions fall: learned at "
      "corners, dofs^-1 (second order) elsewhere. Three to six meshes to a target.",
      {}, [](const Params&) { return std::make_unique<Predicted>(); });
  registry.add("Doerfler",
               "The cells with the largest contributions are halved twice: as few as make a fraction of the sum of "
               "squares. Many meshes, and no prediction.",
               {{"Fraction", 0.6, inOpenRange(0.0, 1.0), "Of the sum of squared contributions."}},
               [](const Params& params) { return std::make_unique<Doerfler>(params.get<double>("Fraction")); });
  registry.add("Uniform", "All cells are halved twice: what a target costs without knowing where the error is.", {},
               [](const Params&) { return std::make_unique<Uniform>(); });
}

} // namespace ndframe
