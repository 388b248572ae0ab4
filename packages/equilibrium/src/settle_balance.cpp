#include "ndframe/equilibrium/settle_balance.hpp"

#include <algorithm>
#include <cmath>

#include "balance_settler.hpp"
#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Imbalance over the smallest facet, relative to the largest force over the largest facet, that is left as it is.
constexpr double unseen = 1e-13;

} // namespace

/// The ranks' parts hand on to each other what the parts behind them have; where that passes is the same as if cells
/// did it one by one, but no rank waits for another.
void BalanceSettler::runWith(const Comm& comm)
{
  begin();
  const PartGraph graph(*piece_, tree_, comm);
  const Vector about(piece_->centre.begin(), piece_->centre.begin() + data_.dim);
  reactTogether(graph, about, comm);
  passOn(graph, about, comm);
  for (std::size_t part = 0; part < tree_.parts().size(); ++part) {
    const int number = graph.number(part);
    handOn(graph.parent(number) < 0 ? tree_.parts()[part]
                                    : tree_.treeFrom(graph.exit(number, *piece_, tree_) / (data_.dim + 1)));
  }
  Vector largest{largestLeft()};
  takeLargest(largest, comm);
  correction_.imbalance = largest[0];
}

/// The wrench that every part has, of all ranks.
Vector BalanceSettler::totals(const PartGraph& graph, const Vector& about, const Comm& comm) const
{
  const auto size = std::size_t(wrenchSize(data_.dim));
  Vector all(std::size_t(graph.size()) * size, 0.0);
  for (std::size_t part = 0; part < tree_.parts().size(); ++part) {
    Vector total(size, 0.0);
    addTotal(tree_.parts()[part], about, total);
    std::copy(total.begin(), total.end(), all.begin() + std::ptrdiff_t(graph.number(part)) * std::ptrdiff_t(size));
  }
  comm.sum(all);
  return all;
}

/// Every connected part of the body with all its supports.
void BalanceSettler::reactTogether(const PartGraph& graph, const Vector& about, const Comm& comm)
{
  const int size = wrenchSize(data_.dim);
  const Vector ofParts = totals(graph, about, comm);
  std::vector<DenseMatrix> resistance(std::size_t(graph.size()), DenseMatrix(size, size));
  for (std::size_t part = 0; part < tree_.parts().size(); ++part)
    addResistance(tree_.parts()[part], about, resistance[std::size_t(graph.root(graph.number(part)))]);
  Vector entries;
  for (const DenseMatrix& matrix : resistance)
    entries.insert(entries.end(), matrix.data(), matrix.data() + std::ptrdiff_t(size) * size);
  comm.sum(entries);
  for (std::size_t part = 0; part < tree_.parts().size(); ++part) {
    const int root = graph.root(graph.number(part));
    Vector total(std::size_t(size), 0.0);
    for (int other = 0; other < graph.size(); ++other)
      for (int i = 0; i < size && graph.root(other) == root; ++i)
        total[std::size_t(i)] += ofParts[std::size_t(other) * std::size_t(size) + std::size_t(i)];
    DenseMatrix all(size, size);
    std::copy_n(entries.begin() + std::ptrdiff_t(root) * size * size, std::ptrdiff_t(size) * size, all.col(0));
    react(tree_.parts()[part], about, total, all);
  }
}

/// What parts give to the ones that they hang on: what they have, and those that hang on them.
void BalanceSettler::passOn(const PartGraph& graph, const Vector& about, const Comm& comm)
{
  const auto size = std::size_t(wrenchSize(data_.dim));
  Vector flow = totals(graph, about, comm);
  for (auto part = graph.order().rbegin(); part != graph.order().rend(); ++part) {
    const int parent = graph.parent(*part);
    for (std::size_t i = 0; i < size && parent >= 0; ++i)
      flow[std::size_t(parent) * size + i] += flow[std::size_t(*part) * size + i];
  }
  for (const int part : graph.order()) {
    const int parent = graph.parent(part);
    if (parent < 0 || !(graph.isOwn(part) || graph.isOwn(parent)))
      continue;
    const int half = graph.exit(part, *piece_, tree_);
    const Vector middle = centre(half / (data_.dim + 1));
    const auto begin = flow.begin() + std::ptrdiff_t(part) * std::ptrdiff_t(size);
    const Vector there = wrenchAbout(data_.dim, Vector(begin, begin + std::ptrdiff_t(size)), about, middle, size_);
    const FacetSplit split = splitFacet(data_.dim, arms(half, middle), reference_.facetModes, size_);
    const Vector moments = multiply(split.carrier, DenseMatrix(there)).column(0);
    change(half, moments, -1.0);
    change(tree_.twin(half), moments, 1.0);
  }
}

void agreeOnImbalance(StressCorrection& correction, const Comm& comm)
{
  Vector largest{correction.imbalance, correction.force};
  takeLargest(largest, comm);
  correction.imbalance = largest[0];
  correction.force = largest[1];
}

bool needsSettling(const Mesh& mesh, const StressCorrection& correction, const Comm& comm)
{
  if (correction.imbalance > unseen * correction.force)
    return true;
  Vector smallest{HUGE_VAL}, largest{0.0};
  for (int cell = 0; cell < mesh.numCells(); ++cell)
    for (int facet = 0; facet <= mesh.dim; ++facet) {
      double normal[3];
      const double measure = facetNormal(mesh, {cell, facet}, normal);
      smallest[0] = std::min(smallest[0], measure);
      largest[0] = std::max(largest[0], measure);
    }
  takeExtremes(smallest, largest, comm);
  return correction.imbalance * largest[0] > unseen * correction.force * smallest[0];
}

void settleBalance(const BodyModel& body, const StaticData& data, const FieldInput& field, StressCorrection& correction)
{
  NDFRAME_ASSERT(field.displacement != nullptr && data.degree == correction.degree, "data and stress do not match");
  BalanceSettler(body, data, field, diameter(body.mesh), nullptr, correction).run();
}

void settleBalance(const BodyPiece& piece, const FieldInput& field, StressCorrection& correction, const Comm& comm)
{
  NDFRAME_ASSERT(field.displacement != nullptr && piece.data.degree == correction.degree,
                 "data and stress do not match");
  BalanceSettler(piece.model, piece.data, field, piece.extent, &piece, correction).runWith(comm);
  piece.fetchGhosts(correction);
}

} // namespace ndframe
