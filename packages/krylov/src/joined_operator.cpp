#include "joined_operator.hpp"

#include <algorithm>

namespace ndframe
{

JoinedOperator::JoinedOperator(const std::vector<const RankProblem*>& bodies, const IndexMap& nodes,
                               const std::vector<RankProblem::Global>& kept, const Comm& comm)
    : dofMap_(ownedMap(nodes, bodies.front()->matrix->dim, teuchosComm(comm))),
      kept_(kept, nodes, bodies.front()->matrix->dim, dofMap_->getComm()), work_(dofMap_->getNodeNumElements())
{
  std::int64_t first = 0;
  for (const RankProblem* body : bodies) {
    firstNumbers_.push_back(first);
    first += body->matrix->nodes.globalSize() * body->matrix->dim;
    parts_.push_back(Teuchos::rcp(new BlockOperator(*body, comm)));
    moved_.push_back(Teuchos::rcp(new TpetraVectors(parts_.back()->getDomainMap(), 1)));
  }
}

void JoinedOperator::follow(const JoinedUnknowns& unknowns)
{
  spread_.follow(kept_, unknowns.rows.kept);
  diagonal_.clear();
  springs_.clear();
  for (const auto& place : kept_.own()) {
    diagonal_.push_back(unknowns.diagonal[std::size_t(place.kept)]);
    if (!unknowns.springs.empty())
      springs_.push_back(unknowns.springs[std::size_t(place.kept)]);
  }
}

template <class Take>
void JoinedOperator::eachBody(const double* x, double* y, const Take& take) const
{
  std::size_t first = 0;
  for (std::size_t b = 0; b < parts_.size(); ++b) {
    const std::size_t size = moved_[b]->getLocalLength();
    std::copy_n(x + first, size, moved_[b]->getDataNonConst(0).getRawPtr());
    take(*parts_[b], *moved_[b], y + first);
    first += size;
  }
}

void JoinedOperator::multiplyBodies(const double* x, double* y) const
{
  eachBody(x, y, [](const BlockOperator& K, const TpetraVectors& own, double* to) { K.multiply(own, to); });
}

void JoinedOperator::sizesOfBodies(const double* x, double* y) const
{
  eachBody(x, y, [](const BlockOperator& K, const TpetraVectors& own, double* to) { K.sizes(own, to); });
}

void JoinedOperator::multiply(const TpetraVectors& x, double* y) const
{
  const auto given = x.getData(0);
  std::copy_n(given.getRawPtr(), work_.size(), work_.data());
  spread_.apply(work_.data());
  multiplyBodies(work_.data(), y);
  spread_.applyTranspose(y);
  for (std::size_t k = 0; k < springs_.size(); ++k) {
    const std::size_t dof = kept_.own()[k].dof;
    y[dof] += springs_[k] * given.getRawPtr()[dof];
  }
}

std::vector<std::int64_t> JoinedOperator::numbers() const
{
  std::vector<std::int64_t> all;
  for (std::size_t b = 0; b < parts_.size(); ++b)
    for (const std::int64_t number : parts_[b]->numbers())
      all.push_back(firstNumbers_[b] + number);
  return all;
}

std::vector<double> JoinedOperator::inverseDiagonal() const
{
  std::vector<double> inverse;
  for (const auto& part : parts_) {
    const std::vector<double> own = part->inverseDiagonal();
    inverse.insert(inverse.end(), own.begin(), own.end());
  }
  for (std::size_t k = 0; k < diagonal_.size(); ++k)
    inverse[kept_.own()[k].dof] = diagonal_[k] > 0.0 ? 1.0 / diagonal_[k] : 0.0;
  return inverse;
}

Traffic JoinedOperator::traffic() const
{
  Traffic sum = spread_.traffic();
  for (const auto& part : parts_)
    sum += part->traffic();
  return sum;
}

} // namespace ndframe
