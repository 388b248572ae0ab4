#include "stress_blocks.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/simd/block_kernels.hpp"

namespace ndframe
{
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
      for (std::size_t s = 0; s < (*edges_)[e].ring.size(); ++s)
        if (const int cell = (*edges_)[e].ring[s].cell; cell >= 0 && !isShared(faces_->size() + int(e)))
          visit(std::size_t(cell), int(e), s);
  };
  each([&](std::size_t cell, int, std::size_t) { ++firstEdge_[cell + 2]; });
  std::partial_sum(firstEdge_.begin(), firstEdge_.end(), firstEdge_.begin());
  edgesOf_.resize(std::size_t(firstEdge_.back()));
  each([&](std::size_t cell, int e, std::size_t step) {
    edgesOf_[std::size_t(firstEdge_[cell + 1]++)] = {e, insideAt((*edges_)[std::size_t(e)], step)};
  });
}

/// The facets of a cell between which a step of a ring goes, if nothing is to be known of them but where they are.
CellBlocks::Pair StressBlocks::insideAt(const StressEdge& edge, std::size_t step) const
{
  const auto& ring = edge.ring;
  const StressEdge::Step &out = ring[step], &in = ring[(step + ring.size() - 1) % ring.size()];
  if (out.through != nullptr || in.through != nullptr)
    return {-1, -1};
  const auto facet = [&](const StressEdge::Step& taken) {
    const StressFace& face = (*faces_)[taken.face];
    return face.facet[face.sideOf(out.cell)];
  };
  return {std::min(facet(in), facet(out)), std::max(facet(in), facet(out))};
}

/// take(block) for those that a cell's faces, then its edges, have alone.
template <class Take>
void StressBlocks::eachBlock(int cell, const Take& take) const
{
  for (int facet = 0; facet < 4; ++facet)
    if (!isShared(faces_->of(cell, facet)))
      take(faces_->of(cell, facet));
  for (int at = firstEdge_[std::size_t(cell)]; at < firstEdge_[std::size_t(cell) + 1]; ++at)
    take(faces_->size() + edgesOf_[std::size_t(at)].edge);
}

/// addFace(facet, sum) and addEdge(edge, facets, sum) for what the cell's faces, then its edges, have alone.
template <class AddFace, class AddEdge>
Vector StressBlocks::parts(int cell, const AddFace& addFace, const AddEdge& addEdge) const
{
  std::size_t size = 0;
  eachBlock(cell, [&](int block) { size += entries(block); });
  Vector parts(size, 0.0);
  double* sum = parts.data();
  for (int facet = 0; facet < 4; ++facet)
    if (const int face = faces_->of(cell, facet); !isShared(face)) {
      addFace(facet, sum);
      sum += entries(face);
    }
  for (int at = firstEdge_[std::size_t(cell)]; at < firstEdge_[std::size_t(cell) + 1]; ++at) {
    const auto& [edge, facets] = edgesOf_[std::size_t(at)];
    addEdge(edge, facets, sum);
    sum += entries(faces_->size() + edge);
  }
  return parts;
}

Vector StressBlocks::parts(const CellBlocks& found, int lane, int cell) const
{
  return parts(
      cell, [&](int facet, double* sum) { found.addFace(lane, facet, sum); },
      [&](int edge, CellBlocks::Pair facets, double* sum) {
        found.addEdge(lane, (*edges_)[std::size_t(edge)], facets, sum);
      });
}

Vector StressBlocks::partsOfClass(int cell) const
{
  std::array<double, std::size_t(mostUnknowns) * mostUnknowns> square;
  const auto pack = [&](int block, double* sum, const auto& add) {
    const auto size = std::size_t(sizeOf(block));
    std::fill_n(square.begin(), size * size, 0.0);
    add(square.data());
    block_kernels::eachBelow(
        size, [&](std::size_t i, std::size_t j, std::size_t place) { sum[place] += square[j * size + i]; });
  };
  return parts(
      cell,
      [&](int facet, double* sum) {
        pack(faces_->of(cell, facet), sum, [&](double* all) { ofClasses_.addFace(cell, facet, all); });
      },
      [&](int edge, CellBlocks::Pair, double* sum) {
        pack(faces_->size() + edge, sum, [&](double* all) { ofClasses_.addEdge(cell, edge, all); });
      });
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
  std::stable_sort(kept.begin(), kept.end(), [this](int a, int b) { return sizeOf(a) < sizeOf(b); });
  isExact_.assign(at_.size(), 0);
  Vector scales(at_.size(), 1.0);
  definiteOnEveryRank(sharing.comm(), [&] {
    runInRanges(int(kept.size()), threads,
                [&](int first, int last) { invertAlike(kept.data() + first, kept.data() + last, scales); });
  });
  for (std::size_t b = 0; b < factor_.size(); ++b) {
    factor_[b] *= scales[std::size_t(first_[b])];
    isExact_[b] = isExact_[std::size_t(first_[b])];
    if (sharing.owns(int(b)) && sizeOf(int(b)) > 0)
      unit_ = std::max(unit_, factor_[b]);
  }
  unit_ = sharing.unitOf(unit_);
}

/// Some blocks, those of one size side by side.
void StressBlocks::invertAlike(const int* first, const int* last, Vector& scales)
{
  constexpr std::size_t lanes = CellForms::lanes;
  constexpr double leastPivot = 1e-13; // of the largest diagonal entry
  Vector side;
  for (const int *begin = first, *end = first; begin < last; begin = end) {
    const auto size = std::size_t(sizeOf(*begin));
    while (end < last && end < begin + lanes && std::size_t(sizeOf(*end)) == size)
      ++end;
    side.resize(size * size * lanes);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const int block = begin[std::min(lane, std::size_t(end - begin) - 1)];
      const Vector square = this->square(block);
      for (std::size_t i = 0; i < square.size(); ++i)
        side[i * lanes + lane] = square[i];
    }
    Vector diagonals(size * lanes);
    for (std::size_t i = 0; i < size; ++i)
      std::copy_n(side.data() + i * (size + 1) * lanes, lanes, diagonals.data() + i * lanes);
    if (!block_kernels::invert(side.data(), int(size), leastPivot))
      throw NotPositiveDefinite(-1);
    for (std::size_t lane = 0; begin + lane < end; ++lane)
      scales[std::size_t(begin[lane])] = keep(begin[lane], side.data() + lane, diagonals.data() + lane);
  }
}

/// A block with both triangles.
Vector StressBlocks::square(int block) const
{
  const auto size = std::size_t(sizeOf(block));
  Vector square(size * size, 0.0);
  const int edge = block - faces_->size();
  if (isShared(block) && edge < 0)
    ofClasses_.addAllOfFace(block, square.data());
  else if (isShared(block))
    ofClasses_.addAllOfEdge(edge, square.data());
  else
    block_kernels::eachBelow(size, [&](std::size_t i, std::size_t j, std::size_t place) {
      square[i * size + j] = square[j * size + i] = blocks_[at_[std::size_t(block)] + place];
    });
  return square;
}

/// Puts an inverse in a block's place and returns its scale: in single precision, unless its round-off, up to 6e-8 of
/// the diagonal, could be as large as the least eigenvalue. inverse, diagonal (of the block): one number in so many
/// lanes.
double StressBlocks::keep(int block, const double* inverse, const double* diagonal)
{
  constexpr std::size_t lanes = CellForms::lanes;
  constexpr double mostForFew = 1e5;
  const auto size = std::size_t(sizeOf(block));
  double trace = 0.0, scale = 0.0; // of the inverse with a diagonal of one, inverted: no eigenvalue is larger
  for (std::size_t i = 0; i < size; ++i) {
    const double entry = inverse[i * (size + 1) * lanes];
    trace += diagonal[i * lanes] * entry;
    scale = std::max(scale, entry);
  }
  double* place = blocks_.data() + at_[std::size_t(block)];
  if (!(trace < mostForFew)) {
    isExact_[std::size_t(block)] = 1;
    block_kernels::eachBelow(size, [&](std::size_t i, std::size_t j, std::size_t at) {
      place[at] = inverse[(j * size + i) * lanes] / scale;
    });
    return scale;
  }
  std::array<float, std::size_t(mostUnknowns) * mostUnknowns> numbers;
  for (std::size_t i = 0; i < size * size; ++i)
    numbers[i] = float(inverse[i * lanes] / scale);
  std::memcpy(static_cast<void*>(place), numbers.data(), size * size * sizeof(float));
  return scale;
}

void StressBlocks::precondition(const std::vector<float>& gradient, const std::vector<char>& held, int threads,
                                std::vector<float>& result) const
{
  result.resize(gradient.size());
  runInRanges(numBlocks(), threads, [&](int begin, int end) {
    for (int b = begin; b < end; ++b) {
      const auto first = std::size_t(begin_[std::size_t(b)]), size = std::size_t(sizeOf(b));
      const double *A = blocks_.data() + at_[std::size_t(b)], factor = factor_[std::size_t(b)] / unit_;
      float* z = result.data() + first;
      if (held[std::size_t(b)] != 0)
        std::fill_n(z, size, 0.0F);
      else if (isExact_[std::size_t(b)] != 0)
        block_kernels::multiplyTriangle(A, gradient.data() + first, size, factor, z);
      else
        block_kernels::multiplyRounded(A, gradient.data() + first, size, float(factor), z);
    }
  });
}

} // namespace ndframe
