#include "vertex_transfer.hpp"

#include <algorithm>

namespace ndframe
{

VertexTransfer::VertexTransfer(const std::vector<const LinearLevel*>& levels, KeptPlaces kept) : kept_(std::move(kept))
{
  std::size_t dof = 0;
  for (const LinearLevel* level : levels) {
    const BlockMatrix& K = level->matrix;
    for (int r = 0; r < K.numRows(); ++r)
      for (int i = 0; i < K.dim; ++i, ++dof)
        if (level->problem.role(r, i) != DofRole::Interior)
          held_.push_back(dof);
  }
  size_ = dof;
}

void VertexTransfer::follow(const std::vector<SparseRow>& unknowns)
{
  taken_.follow(kept_, unknowns);
}

void VertexTransfer::followOnVertices(const std::vector<SparseRow>& kept)
{
  spread_.follow(kept_, kept);
}

Traffic VertexTransfer::traffic() const
{
  Traffic sum = taken_.traffic();
  sum += spread_.traffic();
  return sum;
}

void VertexTransfer::annul(double* values) const
{
  for (const std::size_t dof : held_)
    values[dof] = 0.0;
}

void VertexTransfer::toCoarse(const double* fine, TpetraVectors& coarse)
{
  const auto result = coarse.getDataNonConst(0);
  double* const all = result.getRawPtr();
  std::copy_n(fine, size_, all);
  taken_.applyTranspose(all);
  annul(all);
  spread_.applyTranspose(all);
}

void VertexTransfer::toFine(TpetraVectors& coarse, double* fine)
{
  const auto given = coarse.getDataNonConst(0);
  double* const all = given.getRawPtr();
  spread_.apply(all);
  annul(all);
  std::copy_n(all, size_, fine);
  taken_.apply(fine);
}

} // namespace ndframe
