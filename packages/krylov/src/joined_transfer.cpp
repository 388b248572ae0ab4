#include "joined_transfer.hpp"

#include <algorithm>

namespace ndframe
{

JoinedTransfer::JoinedTransfer(std::vector<LinearTransfer> bodies, KeptPlaces kept, KeptPlaces coarseKept)
    : bodies_(std::move(bodies)), kept_(std::move(kept)), coarseKept_(std::move(coarseKept))
{
  std::size_t size = 0;
  for (const LinearTransfer& body : bodies_) {
    coarse_.push_back(Teuchos::rcp(new TpetraVectors(body.coarseMap(), 1)));
    fineStarts_.push_back(size);
    size += body.fineSize();
  }
  work_.resize(size);
}

void JoinedTransfer::follow(const std::vector<SparseRow>& unknowns)
{
  taken_.follow(kept_, unknowns);
}

void JoinedTransfer::followOnVertices(const std::vector<SparseRow>& kept)
{
  coarseSpread_.follow(coarseKept_, kept);
}

Traffic JoinedTransfer::traffic() const
{
  Traffic sum = taken_.traffic();
  sum += coarseSpread_.traffic();
  for (const LinearTransfer& body : bodies_)
    sum += body.traffic();
  return sum;
}

void JoinedTransfer::toVertices(const double* fine, double* vertices)
{
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    bodies_[b].toCoarse(fine + fineStarts_[b], *coarse_[b]);
    const auto own = coarse_[b]->getData(0);
    vertices = std::copy_n(own.getRawPtr(), own.size(), vertices);
  }
}

void JoinedTransfer::fromVertices(const double* vertices, double* fine)
{
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const auto size = std::ptrdiff_t(coarse_[b]->getLocalLength());
    std::copy_n(vertices, size, coarse_[b]->getDataNonConst(0).getRawPtr());
    bodies_[b].toFine(*coarse_[b], fine + fineStarts_[b]);
    vertices += size;
  }
}

void JoinedTransfer::toCoarse(const double* fine, TpetraVectors& coarse)
{
  std::copy_n(fine, work_.size(), work_.data());
  taken_.applyTranspose(work_.data());
  const auto result = coarse.getDataNonConst(0);
  toVertices(work_.data(), result.getRawPtr());
  coarseSpread_.applyTranspose(result.getRawPtr());
}

void JoinedTransfer::toFine(TpetraVectors& coarse, double* fine)
{
  const auto given = coarse.getDataNonConst(0);
  coarseSpread_.apply(given.getRawPtr());
  fromVertices(given.getRawPtr(), fine);
  taken_.apply(fine);
}

} // namespace ndframe
