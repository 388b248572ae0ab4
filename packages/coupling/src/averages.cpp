#include "averages.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

using Block = std::vector<std::size_t>;

/// Rows that share entries with each other, directly or through others.
std::vector<Block> connected(const std::vector<SparseRow>& B, const std::vector<SparseRow>& users)
{
  std::vector<Block> blocks;
  std::vector<char> isTaken(B.size(), 0);
  for (std::size_t first = 0; first < B.size(); ++first) {
    if (isTaken[first])
      continue;
    isTaken[first] = 1;
    Block block{first};
    for (std::size_t next = 0; next < block.size(); ++next)
      for (const auto& [entry, value] : B[block[next]])
        for (const auto& [other, share] : users[std::size_t(entry)])
          if (!std::exchange(isTaken[std::size_t(other)], char(1)))
            block.push_back(std::size_t(other));
    std::sort(block.begin(), block.end());
    blocks.push_back(std::move(block));
  }
  return blocks;
}

/// B W B^T of a block.
DenseMatrix gramOf(const Block& block, const std::vector<SparseRow>& B, const std::vector<SparseRow>& users,
                   const Vector& weights)
{
  DenseMatrix gram(int(block.size()), int(block.size()));
  for (std::size_t i = 0; i < block.size(); ++i)
    for (const auto& [entry, value] : B[block[i]])
      for (const auto& [other, share] : users[std::size_t(entry)]) {
        const auto j = std::lower_bound(block.begin(), block.end(), std::size_t(other)) - block.begin();
        gram(int(i), int(j)) += value * share * weights[std::size_t(entry)];
      }
  return gram;
}

} // namespace

Averages averagesOf(const std::vector<SparseRow>& B, const Vector& weights)
{
  const auto size = int(weights.size());
  const std::vector<SparseRow> users = transposed(B, size);
  Averages result{std::vector<SparseRow>(B.size()), Vector(B.size(), 0.0)};
  SparseSum sum(size);
  for (const Block& block : connected(B, users)) {
    DenseMatrix gram = gramOf(block, B, users, weights);
    for (std::size_t i = 0; i < block.size(); ++i)
      result.gramDiagonal[block[i]] = gram(int(i), int(i));
    const DenseCholesky factor(std::move(gram));
    for (std::size_t i = 0; i < block.size(); ++i) {
      Vector unit(block.size(), 0.0);
      unit[i] = 1.0;
      const Vector inverse = factor.solve(std::move(unit));
      for (std::size_t j = 0; j < block.size(); ++j)
        for (const auto& [entry, value] : B[block[j]])
          sum.add(entry, inverse[j] * value * weights[std::size_t(entry)]);
      result.rows[block[i]] = sum.take();
    }
  }
  return result;
}

} // namespace ndframe
