#include "joined_operator.hpp"

#include <Teuchos_CommHelpers.hpp>

namespace ndframe
{

KeptPlaces::KeptPlaces(const std::vector<int>& kept, const Teuchos::RCP<const TpetraMap>& dofMap)
    : size_(kept.size()), comm_(dofMap->getComm())
{
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const auto local = kept[k] < 0 ? -1 : dofMap->getLocalElement(kept[k]);
    if (local >= 0)
      own_.emplace_back(k, std::size_t(local));
  }
}

std::vector<double> KeptPlaces::gather(const double* x) const
{
  std::vector<double> own(size_, 0.0);
  for (const auto& [k, dof] : own_)
    own[k] = x[dof];
  if (comm_->getSize() == 1)
    return own;
  std::vector<double> all(size_, 0.0);
  Teuchos::reduceAll(*comm_, Teuchos::REDUCE_SUM, int(size_), own.data(), all.data());
  return all;
}

void KeptPlaces::scatter(const std::vector<double>& kept, double* x) const
{
  for (const auto& [k, dof] : own_)
    x[dof] = kept[k];
}

void KeptPlaces::replace(const std::vector<SparseRow>& rows, double* x) const
{
  const std::vector<double> given = gather(x);
  std::vector<double> result(size_, 0.0);
  for (std::size_t k = 0; k < size_; ++k)
    for (const auto& [other, share] : rows[k])
      result[k] += share * given[std::size_t(other)];
  scatter(result, x);
}

void KeptPlaces::replaceTransposed(const std::vector<SparseRow>& rows, double* x) const
{
  const std::vector<double> given = gather(x);
  std::vector<double> result(size_, 0.0);
  for (std::size_t k = 0; k < size_; ++k)
    for (const auto& [other, share] : rows[k])
      result[std::size_t(other)] += share * given[k];
  scatter(result, x);
}

JoinedOperator::JoinedOperator(const std::vector<const SolverProblem*>& bodies, Teuchos::RCP<const TpetraMap> dofMap,
                               const std::vector<int>& kept, const Comm& comm)
    : dofMap_(std::move(dofMap)), kept_(kept, dofMap_), work_(dofMap_->getNodeNumElements())
{
  for (const SolverProblem* body : bodies) {
    parts_.push_back(Teuchos::rcp(new BlockOperator(*body, comm)));
    moved_.push_back(Teuchos::rcp(new TpetraVectors(parts_.back()->getDomainMap(), 1)));
  }
}

void JoinedOperator::multiply(const TpetraVectors& x, double* y) const
{
  const auto given = x.getData(0);
  std::copy_n(given.getRawPtr(), work_.size(), work_.data());
  kept_.replace(unknowns_.rows.kept, work_.data());
  std::size_t first = 0;
  for (std::size_t b = 0; b < parts_.size(); ++b) {
    const std::size_t size = moved_[b]->getLocalLength();
    std::copy_n(work_.data() + first, size, moved_[b]->getDataNonConst(0).getRawPtr());
    parts_[b]->multiply(*moved_[b], y + first);
    first += size;
  }
  kept_.replaceTransposed(unknowns_.rows.kept, y);
  if (unknowns_.springs.empty())
    return;
  std::vector<double> pulled = kept_.gather(given.getRawPtr()), forces = kept_.gather(y);
  for (std::size_t k = 0; k < pulled.size(); ++k)
    forces[k] += unknowns_.springs[k] * pulled[k];
  kept_.scatter(forces, y);
}

std::vector<double> JoinedOperator::inverseDiagonal() const
{
  std::vector<double> inverse;
  for (const auto& part : parts_) {
    const std::vector<double> own = part->inverseDiagonal();
    inverse.insert(inverse.end(), own.begin(), own.end());
  }
  std::vector<double> kept = unknowns_.diagonal;
  for (double& value : kept)
    value = value > 0.0 ? 1.0 / value : 0.0;
  kept_.scatter(kept, inverse.data());
  return inverse;
}

} // namespace ndframe
