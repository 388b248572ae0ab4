#include "ndframe/simd/stress_cells.hpp"

#include <algorithm>

namespace ndframe
{

namespace
{

const BodyPiece* pieceOf(const std::vector<const BodyPiece*>& pieces, std::size_t body)
{
  return pieces.empty() ? nullptr : pieces[body];
}

/// Of the whole bodies.
std::vector<const BodyModel*> modelsOf(const std::vector<const StarBody*>& bodies,
                                       const std::vector<const BodyPiece*>& pieces)
{
  std::vector<const BodyModel*> models;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const BodyPiece* piece = pieceOf(pieces, b);
    models.push_back(bodies[b] == nullptr ? nullptr : (piece == nullptr ? &bodies[b]->model() : piece->whole));
  }
  return models;
}

/// Found for all cells, so that ranks agree on what is the same.
CellClasses classesOf(const std::vector<const StarBody*>& bodies, const std::vector<const BodyPiece*>& pieces)
{
  const std::vector<const BodyModel*> models = modelsOf(bodies, pieces);
  CellClasses all(models);
  if (pieces.empty())
    return all;
  std::vector<int> held;
  int first = 0;
  for (std::size_t b = 0; b < models.size(); ++b) {
    if (models[b] == nullptr)
      continue;
    for (const int cell : pieces[b]->cells)
      held.push_back(first + cell);
    first += models[b]->mesh.numCells();
  }
  return all.among(held);
}

} // namespace

StressCells::StressCells(std::vector<const StarBody*> bodies, const std::vector<const BodyPiece*>& pieces)
    : bodies_(std::move(bodies)), classes_(classesOf(bodies_, pieces))
{
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const StarBody* body = bodies_[b];
    first_.push_back(first_.back() + (body == nullptr ? 0 : body->model().mesh.numCells()));
    if (body == nullptr)
      continue;
    any_ = body;
    if (const BodyPiece* piece = pieceOf(pieces, b)) {
      owner_.insert(owner_.end(), piece->owner.begin(), piece->owner.end());
      rank_ = piece->rank;
    }
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
