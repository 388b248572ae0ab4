#include "own_dofs.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

Vector ownPart(const BlockMatrix& K, const Vector& all)
{
  Vector own;
  own.reserve(std::size_t(K.numRows()) * std::size_t(K.dim));
  for (int r = 0; r < K.numRows(); ++r) {
    const auto first = all.begin() + std::ptrdiff_t(K.rowNode(r)) * K.dim;
    own.insert(own.end(), first, first + K.dim);
  }
  return own;
}

Vector gathered(const BlockMatrix& K, const double* own, const Comm& comm)
{
  Vector all(std::size_t(K.numDofs()), 0.0);
  for (int r = 0; r < K.numRows(); ++r, own += K.dim)
    std::copy_n(own, K.dim, all.begin() + std::ptrdiff_t(K.rowNode(r)) * K.dim);
  comm.sum(all);
  return all;
}

OwnDofs::OwnDofs(const std::vector<const SolverProblem*>& problems, const Comm& comm) : problems_(problems), comm_(comm)
{
  for (const SolverProblem* problem : problems_) {
    const BlockMatrix& K = *problem->matrix;
    const int first = int(isFree_.size());
    for (const int dof : problem->kept) {
      const int row = dof < 0 ? -1 : K.rowOf(dof / K.dim);
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

Vector OwnDofs::part(const std::vector<const SparseField*>& loads) const
{
  Vector own(size(), 0.0);
  std::ptrdiff_t first = 0;
  for (std::size_t b = 0; b < loads.size(); ++b) {
    const BlockMatrix& K = *problems_[b]->matrix;
    loads[b]->each([&](int node, const double* values) {
      if (const int row = K.rowOf(node); row >= 0)
        std::copy_n(values, K.dim, own.begin() + first + std::ptrdiff_t(row) * K.dim);
    });
    first += std::ptrdiff_t(K.numRows()) * K.dim;
  }
  for (std::size_t i = 0; i < own.size(); ++i)
    if (!isFree_[i])
      own[i] = 0.0;
  return own;
}

Vector OwnDofs::part(const std::vector<const Vector*>& all) const
{
  Vector own;
  own.reserve(size());
  for (std::size_t b = 0; b < all.size(); ++b) {
    const Vector ofBody = ownPart(*problems_[b]->matrix, *all[b]);
    own.insert(own.end(), ofBody.begin(), ofBody.end());
  }
  for (std::size_t i = 0; i < own.size(); ++i)
    if (!isFree_[i])
      own[i] = 0.0;
  return own;
}

std::vector<Vector> OwnDofs::gathered(const Vector& own) const
{
  std::vector<Vector> all;
  const double* next = own.data();
  for (const SolverProblem* problem : problems_) {
    const BlockMatrix& K = *problem->matrix;
    all.push_back(ndframe::gathered(K, next, comm_));
    next += std::ptrdiff_t(K.numRows()) * K.dim;
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
