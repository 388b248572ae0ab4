#include "ndframe/simd/stress_cells.hpp"

#include <algorithm>

namespace ndframe
{

namespace
{

std::vector<const BodyModel*> modelsOf(const std::vector<const StarBody*>& bodies)
{
  std::vector<const BodyModel*> models;
  for (const StarBody* body : bodies)
    models.push_back(body == nullptr ? nullptr : &body->model());
  return models;
}

} // namespace

StressCells::StressCells(std::vector<const StarBody*> bodies) : bodies_(std::move(bodies)), classes_(modelsOf(bodies_))
{
  count();
}

StressCells::StressCells(std::vector<const StarBody*> bodies, const std::vector<const BodyPiece*>& pieces,
                         const Comm& comm)
    : bodies_(std::move(bodies)), classes_(pieces, comm), rank_(comm.rank())
{
  for (const BodyPiece* piece : pieces)
    if (piece != nullptr)
      owner_.insert(owner_.end(), piece->owner.begin(), piece->owner.end());
  count();
}

void StressCells::count()
{
  for (const StarBody* body : bodies_) {
    first_.push_back(first_.back() + (body == nullptr ? 0 : body->model().mesh.numCells()));
    any_ = body == nullptr ? any_ : body;
  }
  NDFRAME_ASSERT(any_ != nullptr && any_->dim() == 3, "cells of solids");
}

int StressCells::bodyOf(int number) const
{
  return int(std::upper_bound(first_.begin(), first_.end(), number) - first_.begin()) - 1;
}

SortedCell StressCells::sorted(int number) const
{
  const int body = bodyOf(number);
  return sortedCell(this->body(body).model().mesh, number - first_[std::size_t(body)]);
}

} // namespace ndframe
