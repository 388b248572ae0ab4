#include "own_dofs.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

OwnDofs::OwnDofs(const std::vector<const SolverProblem*>& problems, const Comm& comm) : problems_(problems), comm_(comm)
{
  for (const SolverProblem* problem : problems_) {
    const BlockMatrix& K = *problem->matrix;
    const int first = int(isFree_.size());
    for (const int dof : problem->kept) {
      const int row = K.rowOf(dof / K.dim);
      place_.push_back(row >= 0 ? first + row * K.dim + dof % K.dim : -1);
    }
    for (int r = 0; r < K.numRows(); ++r)
      for (int i = 0; i < K.dim; ++i)
        isFree_.push_back(problem->roles[std::size_t(K.rowNode(r)) * std::size_t(K.dim) + std::size_t(i)] ==
                          DofRole::Interior);
  }
  isKept_.assign(isFree_.size(), 0);
  for (const int place : place_)
    if (place >= 0)
      isKept_[std::size_t(place)] = 1;
}

Vector OwnDofs::part(const std::vector<const Vector*>& all) const
{
  Vector own;
  own.reserve(size());
  for (std::size_t b = 0; b < all.size(); ++b) {
    const BlockMatrix& K = *problems_[b]->matrix;
    for (int r = 0; r < K.numRows(); ++r)
      for (int i = 0; i < K.dim; ++i)
        own.push_back(isFree_[own.size()] ? (*all[b])[std::size_t(K.rowNode(r)) * std::size_t(K.dim) + std::size_t(i)]
                                          : 0.0);
  }
  return own;
}

std::vector<Vector> OwnDofs::gathered(const Vector& own) const
{
  std::vector<Vector> all;
  auto next = own.begin();
  for (const SolverProblem* problem : problems_) {
    const BlockMatrix& K = *problem->matrix;
    all.emplace_back(std::size_t(K.numDofs()), 0.0);
    for (int r = 0; r < K.numRows(); ++r) {
      std::copy_n(next, K.dim, all.back().begin() + std::ptrdiff_t(K.rowNode(r)) * K.dim);
      next += K.dim;
    }
    comm_.sum(all.back());
  }
  return all;
}

Vector OwnDofs::atKept(const Vector& own) const
{
  Vector kept(place_.size(), 0.0);
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (place_[k] >= 0)
      kept[k] = own[std::size_t(place_[k])];
  comm_.sum(kept);
  return kept;
}

void OwnDofs::setKept(const Vector& kept, Vector& own) const
{
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (place_[k] >= 0)
      own[std::size_t(place_[k])] = kept[k];
}

double OwnDofs::norm(const Vector& own) const
{
  Vector squares{dot(own, own)};
  comm_.sum(squares);
  return std::sqrt(squares.front());
}

} // namespace ndframe
