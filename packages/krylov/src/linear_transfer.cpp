#include "linear_transfer.hpp"

#include <algorithm>

namespace ndframe
{

namespace
{

std::vector<std::size_t> heldDofs(const SolverProblem& problem)
{
  const BlockMatrix& K = *problem.matrix;
  std::vector<std::size_t> held;
  for (int r = 0; r < K.numRows(); ++r)
    for (int i = 0; i < K.dim; ++i)
      if (problem.roles[std::size_t(K.rowNode(r)) * std::size_t(K.dim) + std::size_t(i)] != DofRole::Interior)
        held.push_back(std::size_t(r) * std::size_t(K.dim) + std::size_t(i));
  return held;
}

/// The vertices of the level that this rank owns, and those that the nodes of its rows interpolate.
IndexMap seenVertices(const BlockMatrix& fine, const LinearLevel& level)
{
  std::vector<IndexMap::Global> owned, needed;
  for (int v = 0; v < level.matrix.numRows(); ++v)
    owned.push_back(level.matrix.nodes.global(v));
  for (int r = 0; r < fine.numRows() && !level.matrix.nodes.isWhole(); ++r)
    for (const int end : level.interpolation.ends[std::size_t(fine.rowNode(r))])
      needed.push_back(end);
  return IndexMap(level.matrix.nodes.globalSize(), std::move(owned), std::move(needed));
}

} // namespace

LinearTransfer::LinearTransfer(const SolverProblem& fine, const LinearLevel& level,
                               Teuchos::RCP<const TpetraMap> coarseMap)
    : dim_(fine.matrix->dim), coarseMap_(std::move(coarseMap)), held_(heldDofs(fine)),
      coarseHeld_(heldDofs(level.problem))
{
  const LinearInterpolation& P = level.interpolation;
  const IndexMap vertices = seenVertices(*fine.matrix, level);
  const auto blockSize = 2 * dim_ * dim_;
  for (int r = 0; r < fine.matrix->numRows(); ++r) {
    const int node = fine.matrix->rowNode(r);
    const auto& ends = P.ends[std::size_t(node)];
    ends_.push_back({vertices.local(ends[0]), vertices.local(ends[1])});
    if (P.turned.empty())
      continue;
    const double* turned = P.blocks(node);
    turned_.push_back(turned ? int(blocks_.size()) : -1);
    if (turned)
      blocks_.insert(blocks_.end(), turned, turned + blockSize);
  }
  const auto seenMap = heldMap(vertices, dim_, coarseMap_->getComm());
  halo_ = std::make_unique<Halo>(coarseMap_, seenMap);
  seen_ = Teuchos::rcp(new TpetraVectors(seenMap, 1));
}

/// action(own node, end, its vertex, block of P; null: half the identity)
template <class Action>
void LinearTransfer::eachEnd(const Action& action) const
{
  for (std::size_t r = 0; r < ends_.size(); ++r) {
    const double* blocks = turned_.empty() || turned_[r] < 0 ? nullptr : blocks_.data() + turned_[r];
    action(r, std::size_t(ends_[r][0]), blocks);
    action(r, std::size_t(ends_[r][1]), blocks ? blocks + std::ptrdiff_t(dim_) * dim_ : nullptr);
  }
}

void LinearTransfer::toCoarse(const double* fine, TpetraVectors& coarse)
{
  seen_->putScalar(0.0);
  {
    const auto sums = seen_->getDataNonConst(0);
    const auto dim = std::size_t(dim_);
    eachEnd([&](std::size_t r, std::size_t vertex, const double* W) {
      double* sum = sums.getRawPtr() + vertex * dim;
      const double* value = fine + r * dim;
      for (std::size_t i = 0; i < dim; ++i)
        if (!W)
          sum[i] += 0.5 * value[i];
        else
          for (std::size_t k = 0; k < dim; ++k)
            sum[i] += W[k * dim + i] * value[k];
    });
  }
  coarse.putScalar(0.0);
  halo_->add(*seen_, coarse);
  annul(coarse);
}

void LinearTransfer::toFine(TpetraVectors& coarse, double* fine)
{
  annul(coarse);
  halo_->fetch(coarse, *seen_);
  const auto values = seen_->getData(0);
  const auto dim = std::size_t(dim_);
  std::fill(fine, fine + ends_.size() * dim, 0.0);
  eachEnd([&](std::size_t r, std::size_t vertex, const double* W) {
    const double* value = values.getRawPtr() + vertex * dim;
    for (std::size_t i = 0; i < dim; ++i)
      if (!W)
        fine[r * dim + i] += 0.5 * value[i];
      else
        for (std::size_t k = 0; k < dim; ++k)
          fine[r * dim + i] += W[i * dim + k] * value[k];
  });
  for (const std::size_t dof : held_)
    fine[dof] = 0.0;
}

void LinearTransfer::annul(TpetraVectors& coarse) const
{
  const auto values = coarse.getDataNonConst(0);
  for (const std::size_t dof : coarseHeld_)
    values[Teuchos::Ordinal(dof)] = 0.0;
}

} // namespace ndframe
