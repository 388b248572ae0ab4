#include "kept_rows.hpp"

#include <algorithm>

namespace ndframe
{

KeptPlaces::KeptPlaces(const std::vector<IndexMap::Global>& kept, const IndexMap& nodes, int dim,
                       Teuchos::RCP<const Teuchos::Comm<int>> comm)
    : comm_(std::move(comm))
{
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const int node = kept[k] < 0 ? -1 : nodes.local(kept[k] / dim);
    if (nodes.owns(node))
      own_.push_back({int(k), std::size_t(node) * std::size_t(dim) + std::size_t(kept[k] % dim)});
  }
}

KeptRows::KeptRows(const KeptPlaces& places, const std::vector<SparseRow>& rows) : places_(&places)
{
  std::vector<IndexMap::Global> own, read;
  for (const auto& place : places.own()) {
    own.push_back(place.kept);
    for (const auto& entry : rows[std::size_t(place.kept)])
      read.push_back(entry.first);
  }
  const IndexMap kept(IndexMap::Global(rows.size()), std::move(own), std::move(read));
  for (const auto& place : places.own()) {
    rows_.emplace_back();
    for (const auto& [other, share] : rows[std::size_t(place.kept)])
      rows_.back().emplace_back(kept.local(other), share);
  }
  given_.resize(std::size_t(kept.size()));
  if (places.comm()->getSize() == 1)
    return;
  const auto ownMap = ownedMap(kept, 1, places.comm()), neededMap = heldMap(kept, 1, places.comm());
  sent_.emplace(Sent{Halo(ownMap, neededMap), Teuchos::rcp(new TpetraVectors(ownMap, 1)),
                     Teuchos::rcp(new TpetraVectors(neededMap, 1))});
}

void KeptRows::apply(double* x) const
{
  if (!places_)
    return;
  const auto& own = places_->own();
  for (std::size_t k = 0; k < own.size(); ++k)
    given_[k] = x[own[k].dof];
  if (sent_) {
    std::copy_n(given_.data(), own.size(), sent_->own->getDataNonConst(0).getRawPtr());
    sent_->halo.fetch(*sent_->own, *sent_->needed);
    const auto values = sent_->needed->getData(0);
    std::copy(values.begin(), values.end(), given_.begin());
  }
  for (std::size_t k = 0; k < own.size(); ++k) {
    double& value = x[own[k].dof] = 0.0;
    for (const auto& [other, share] : rows_[k])
      value += share * given_[std::size_t(other)];
  }
}

} // namespace ndframe
