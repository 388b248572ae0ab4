#include "own_dofs.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/diagnostics.hpp"

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

namespace
{

/// y_row += take(entry, x) for all entries.
template <class Take>
Vector sumsOfRows(const BlockMatrix& K, const Vector& held, const Take& take)
{
  const auto dim = std::size_t(K.dim);
  Vector y(std::size_t(K.numRows()) * dim, 0.0);
  const double* entry = K.values.data();
  for (std::size_t r = 0; r < std::size_t(K.numRows()); ++r)
    for (auto b = std::size_t(K.rowPtr[r]); b < std::size_t(K.rowPtr[r + 1]); ++b)
      for (std::size_t i = 0; i < dim; ++i)
        for (std::size_t j = 0; j < dim; ++j)
          y[r * dim + i] += take(*entry++ * held[std::size_t(K.cols[b]) * dim + j]);
  return y;
}

} // namespace

Vector ownProduct(const BlockMatrix& K, const Vector& held)
{
  return sumsOfRows(K, held, [](double product) { return product; });
}

Vector ownSizes(const BlockMatrix& K, const Vector& held)
{
  return sumsOfRows(K, held, [](double product) { return std::abs(product); });
}

double meanDiagonal(const BlockMatrix& K, const Comm& comm)
{
  NDFRAME_ASSERT(!K.values.empty() || K.cols.empty(), "the matrix was given back");
  Vector sums{0.0, double(K.numRows()) * K.dim};
  for (int r = 0; r < K.numRows(); ++r) {
    const double* entry = K.block(r, r);
    NDFRAME_ASSERT(entry != nullptr, "a row has no diagonal block");
    for (int i = 0; i < K.dim; ++i)
      sums[0] += entry[i * K.dim + i];
  }
  comm.sum(sums);
  return sums[0] / sums[1];
}

double normOf(const Vector& own, const Comm& comm)
{
  if (comm.size() == 1)
    return norm(own);
  Vector squares{dot(own, own)};
  comm.sum(squares);
  return std::sqrt(squares.front());
}

OwnDofs::OwnDofs(const std::vector<const RankProblem*>& problems, const Comm& comm) : problems_(problems), comm_(comm)
{
  for (const RankProblem* problem : problems_) {
    const BlockMatrix& K = *problem->matrix;
    const int first = int(isFree_.size());
    for (const RankProblem::Global dof : problem->kept) {
      const int own = problem->held(dof);
      place_.push_back(own >= 0 && own < K.numRows() * K.dim ? first + own : -1);
    }
    for (int r = 0; r < K.numRows(); ++r)
      for (int i = 0; i < K.dim; ++i)
        isFree_.push_back(problem->role(r, i) == DofRole::Interior);
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
    loads[b]->each([&](IndexMap::Global node, const double* values) {
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

Vector OwnDofs::part(const std::vector<NodalField>& fields) const
{
  Vector own;
  own.reserve(size());
  for (const NodalField& field : fields)
    own.insert(own.end(), field.begin(), field.end());
  NDFRAME_ASSERT(own.size() == size(), "fields have values at own nodes");
  for (std::size_t i = 0; i < own.size(); ++i)
    if (!isFree_[i])
      own[i] = 0.0;
  return own;
}

std::vector<NodalField> OwnDofs::fields(const Vector& own) const
{
  std::vector<NodalField> fields;
  auto next = own.begin();
  for (const RankProblem* problem : problems_) {
    const BlockMatrix& K = *problem->matrix;
    const auto end = next + std::ptrdiff_t(K.numRows()) * K.dim;
    fields.emplace_back(K.nodes.withoutGhosts(), K.dim, Vector(next, end));
    next = end;
  }
  return fields;
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
