#include "linear_transfer.hpp"

#include <algorithm>

namespace ndframe
{

namespace
{

std::vector<std::size_t> heldDofs(const RankProblem& problem)
{
  const BlockMatrix& K = *problem.matrix;
  std::vector<std::size_t> held;
  for (int r = 0; r < K.numRows(); ++r)
    for (int i = 0; i < K.dim; ++i)
      if (problem.role(r, i) != DofRole::Interior)
        held.push_back(std::size_t(r) * std::size_t(K.dim) + std::size_t(i));
  return held;
}

} // namespace

LinearTransfer::LinearTransfer(const RankProblem& fine, const LinearLevel& level,
                               Teuchos::RCP<const TpetraMap> coarseMap)
    : dim_(fine.matrix->dim), coarseMap_(std::move(coarseMap)), held_(heldDofs(fine)),
      coarseHeld_(heldDofs(level.problem))
{
  const LinearInterpolation& P = level.interpolation;
  const auto blockSize = 2 * dim_ * dim_;
  ends_ = P.ends;
  for (int node = 0; node < fine.matrix->numRows() && !P.turned.empty(); ++node) {
    const double* turned = P.blocks(node);
    turned_.push_back(turned ? int(blocks_.size()) : -1);
    if (turned)
      blocks_.insert(blocks_.end(), turned, turned + blockSize);
  }
  const auto seenMap = heldMap(P.vertices, dim_, coarseMap_->getComm());
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
