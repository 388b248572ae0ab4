#include "stress_blocks.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "cell_block_kernels.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

/// y = factor A x, A column by column: `most` rows, or `size` where most is 18, the data of a face at most.
template <std::size_t most>
inline __attribute__((always_inline)) void multiplyUpTo(const double* A, const double* x, std::size_t size,
                                                        double factor, double* y)
{
  double sums[most] = {};
  for (std::size_t j = 0; j < size; ++j, A += size)
    for (std::size_t i = 0; i < (most < 18 ? most : size); ++i)
      sums[i] += A[i] * x[j];
  for (std::size_t i = 0; i < size; ++i)
    y[i] = factor * sums[i];
}

/// Inside, faces have 12 unknowns and edges 6 where displacements are of the second order.
NDFRAME_EVERY_PROCESSOR void multiplyBlock(const double* A, const double* x, std::size_t size, double factor, double* y)
{
  if (size == 12)
    multiplyUpTo<12>(A, x, 12, factor, y);
  else if (size == 6)
    multiplyUpTo<6>(A, x, 6, factor, y);
  else
    multiplyUpTo<18>(A, x, size, factor, y);
}

} // namespace

StressBlocks::StressBlocks(const StressFaces& faces, const std::vector<StressEdge>& edges,
                           const ClassMatrices& matrices)
    : faces_(&faces), edges_(&edges), ofClasses_(faces, edges, matrices)
{
  for (int f = 0; f < faces.size(); ++f)
    begin_.push_back(begin_.back() + (faces.isNear(f) ? faces[f].numOwn() : 0));
  for (const StressEdge& edge : edges)
    begin_.push_back(begin_.back() + edge.unknowns);
  place();
  listEdges();
  blocks_.assign(alone_, 0.0);
}

/// Finds which blocks are shared, and where blocks are.
void StressBlocks::place()
{
  std::map<std::vector<int>, int> known; // faces' keys are shorter than edges'
  at_.assign(std::size_t(numBlocks()), 0);
  isShared_.assign(at_.size(), 0);
  factor_.assign(at_.size(), 1.0);
  first_.resize(at_.size());
  std::vector<int> shared;
  for (int b = 0; b < numBlocks(); ++b) {
    const bool isFace = b < faces_->size();
    const int edge = b - faces_->size();
    first_[std::size_t(b)] = b;
    auto key = sizeOf(b) == 0 ? std::vector<int>() : (isFace ? ofClasses_.keyOfFace(b) : ofClasses_.keyOfEdge(edge));
    if (key.empty()) {
      at_[std::size_t(b)] = alone_;
      alone_ += entries(b);
      numKept_ += int(sizeOf(b) > 0);
      continue;
    }
    key.push_back(int(isFace));
    const int first = known.emplace(std::move(key), b).first->second;
    const auto scale = [&](int block) {
      return isFace ? ofClasses_.scaleOfFace(block) : ofClasses_.scaleOfEdge(block - faces_->size());
    };
    first_[std::size_t(b)] = first;
    isShared_[std::size_t(b)] = 1;
    factor_[std::size_t(b)] = scale(first) / scale(b);
    shared.push_back(b);
  }
  std::size_t end = alone_;
  for (const int b : shared) {
    at_[std::size_t(b)] = first_[std::size_t(b)] == b ? end : at_[std::size_t(first_[std::size_t(b)])];
    if (first_[std::size_t(b)] == b) {
      end += entries(b);
      ++numKept_;
    }
  }
}

/// Edges with blocks of their own, by cells.
void StressBlocks::listEdges()
{
  firstEdge_.assign(std::size_t(faces_->cells().size()) + 2, 0);
  const auto each = [&](const auto& visit) {
    for (std::size_t e = 0; e < edges_->size(); ++e)
      for (const StressEdge::Step& step : (*edges_)[e].ring)
        if (step.cell >= 0 && !isShared(faces_->size() + int(e)))
          visit(std::size_t(step.cell), int(e));
  };
  each([&](std::size_t cell, int) { ++firstEdge_[cell + 2]; });
  std::partial_sum(firstEdge_.begin(), firstEdge_.end(), firstEdge_.begin());
  edgesOf_.resize(std::size_t(firstEdge_.back()));
  each([&](std::size_t cell, int e) { edgesOf_[std::size_t(firstEdge_[cell + 1]++)] = e; });
}

/// take(block) for those that a cell's faces, then its edges, have alone.
template <class Take>
void StressBlocks::eachBlock(int cell, const Take& take) const
{
  for (int facet = 0; facet < 4; ++facet)
    if (!isShared(faces_->of(cell, facet)))
      take(faces_->of(cell, facet));
  for (int at = firstEdge_[std::size_t(cell)]; at < firstEdge_[std::size_t(cell) + 1]; ++at)
    take(faces_->size() + edgesOf_[std::size_t(at)]);
}

/// addFace(facet, sum) and addEdge(edge, sum) for what the cell's faces, then its edges, have alone.
template <class AddFace, class AddEdge>
Vector StressBlocks::parts(int cell, const AddFace& addFace, const AddEdge& addEdge) const
{
  std::size_t size = 0;
  eachBlock(cell, [&](int block) { size += entries(block); });
  Vector parts(size, 0.0);
  double* sum = parts.data();
  int facet = 0;
  eachBlock(cell, [&](int block) {
    if (block >= faces_->size())
      addEdge(block - faces_->size(), sum);
    else {
      while (faces_->of(cell, facet) != block)
        ++facet;
      addFace(facet++, sum);
    }
    sum += entries(block);
  });
  return parts;
}

Vector StressBlocks::parts(const CellBlocks& found, int lane, int cell) const
{
  return parts(
      cell, [&](int facet, double* sum) { found.addFace(lane, facet, sum); },
      [&](int edge, double* sum) { found.addEdge(lane, (*edges_)[std::size_t(edge)], sum); });
}

Vector StressBlocks::partsOfClass(int cell) const
{
  return parts(
      cell, [&](int facet, double* sum) { ofClasses_.addFace(cell, facet, sum); },
      [&](int edge, double* sum) { ofClasses_.addEdge(cell, edge, sum); });
}

void StressBlocks::add(int cell, const Vector& parts)
{
  const double* part = parts.data();
  eachBlock(cell, [&](int block) {
    for (std::size_t entry = at_[std::size_t(block)], i = 0; i < entries(block); ++i)
      blocks_[entry + i] += *part++;
  });
}

void StressBlocks::invert(const StressSharing& sharing, int threads)
{
  sharing.values().add(
      [&](int b) {
        return SharedValues::Place{at_[std::size_t(b)], isShared(b) ? 0 : entries(b)};
      },
      blocks_);
  std::vector<int> kept;
  std::size_t end = alone_;
  for (int b = 0; b < numBlocks(); ++b)
    if (first_[std::size_t(b)] == b && sizeOf(b) > 0 && (isShared(b) || sharing.owns(b))) {
      kept.push_back(b);
      end = std::max(end, at_[std::size_t(b)] + entries(b));
    }
  blocks_.resize(end, 0.0);
  for (const int b : kept)
    if (isShared(b) && b < faces_->size())
      ofClasses_.addAllOfFace(b, blocks_.data() + at_[std::size_t(b)]);
    else if (isShared(b))
      ofClasses_.addAllOfEdge(b - faces_->size(), blocks_.data() + at_[std::size_t(b)]);
  std::stable_sort(kept.begin(), kept.end(), [this](int a, int b) { return sizeOf(a) < sizeOf(b); });
  definiteOnEveryRank(sharing.comm(), [&] {
    runInRanges(int(kept.size()), threads, [&](int first, int last) { invertAlike(kept, first, last); });
  });
}

/// Some of the given blocks, those of one size side by side.
void StressBlocks::invertAlike(const std::vector<int>& blocks, int first, int last)
{
  constexpr std::size_t lanes = CellForms::lanes;
  constexpr double leastPivot = 1e-13; // of the largest diagonal entry
  Vector side;
  for (int begin = first, end = first; begin < last; begin = end) {
    const std::size_t size = std::size_t(sizeOf(blocks[std::size_t(begin)])), count = size * size;
    while (end < last && end < begin + int(lanes) && std::size_t(sizeOf(blocks[std::size_t(end)])) == size)
      ++end;
    side.resize(count * lanes);
    const auto each = [&](const auto& visit) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const int block = blocks[std::size_t(std::min(begin + int(lane), end - 1))];
        for (std::size_t i = 0; i < count; ++i)
          visit(blocks_[at_[std::size_t(block)] + i], side[i * lanes + lane]);
      }
    };
    each([](double value, double& copy) { copy = value; });
    if (!block_kernels::invert(side.data(), int(size), leastPivot))
      throw NotPositiveDefinite(-1);
    each([](double& value, double inverse) { value = inverse; });
  }
}

void StressBlocks::precondition(const Vector& gradient, const std::vector<char>& held, int threads,
                                Vector& result) const
{
  result.resize(gradient.size());
  runInRanges(numBlocks(), threads, [&](int begin, int end) {
    for (int b = begin; b < end; ++b) {
      const auto first = std::size_t(begin_[std::size_t(b)]), size = std::size_t(sizeOf(b));
      double* z = result.data() + first;
      if (held[std::size_t(b)] != 0)
        std::fill_n(z, size, 0.0);
      else
        multiplyBlock(blocks_.data() + at_[std::size_t(b)], gradient.data() + first, size, factor_[std::size_t(b)], z);
    }
  });
}

} // namespace ndframe
