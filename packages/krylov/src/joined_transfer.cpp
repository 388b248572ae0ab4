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
  before_ += taken_.traffic();
  before_ += given_.traffic();
  taken_ = KeptRows(kept_, unknowns);
  given_ = KeptRows(kept_, transposed(unknowns, int(unknowns.size())));
}

void JoinedTransfer::followOnVertices(const std::vector<SparseRow>& kept)
{
  before_ += coarseSpread_.traffic();
  before_ += coarseCollected_.traffic();
  coarseSpread_ = KeptRows(coarseKept_, kept);
  coarseCollected_ = KeptRows(coarseKept_, transposed(kept, int(kept.size())));
}

Traffic JoinedTransfer::traffic() const
{
  Traffic sum = before_;
  for (const LinearTransfer& body : bodies_)
    sum += body.traffic();
  for (const KeptRows* rows : {&taken_, &given_, &coarseSpread_, &coarseCollected_})
    sum += rows->traffic();
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
  given_.apply(work_.data());
  const auto result = coarse.getDataNonConst(0);
  toVertices(work_.data(), result.getRawPtr());
  coarseCollected_.apply(result.getRawPtr());
}

void JoinedTransfer::toFine(TpetraVectors& coarse, double* fine)
{
  const auto given = coarse.getDataNonConst(0);
  coarseSpread_.apply(given.getRawPtr());
  fromVertices(given.getRawPtr(), fine);
  taken_.apply(fine);
}

} // namespace ndframe
