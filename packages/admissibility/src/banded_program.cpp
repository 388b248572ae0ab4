#include "banded_program.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ndframe/algebra/band.hpp"
#include "ndframe/algebra/sparse_cholesky.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Signs are judged and conditions met to this, relative to the largest entry.
constexpr double roundOff = 1e-13;
/// The proximal term against the response of the conditions.
constexpr double proximal = 1e-10;
constexpr int maxProximalSteps = 100;
/// Steps of full exchange that may fail to reduce the number of wrong signs.
constexpr int patience = 3;
/// Then of steps that exchange entries which are wrong by this part of the largest at least.
constexpr int patienceOfMost = 50;
constexpr double most = 0.1;
/// Wider bands are those of surfaces: mostly zeros.
constexpr int widestBand = 64;

/// A part of M that nothing couples with the rest, and the conditions on it.
struct Block
{
  int first, last; ///< entries
  std::vector<int> conditions;
  std::vector<char> factoredSet; ///< fixed entries that the following belongs to
  Vector x;                      ///< M^-1 f
  std::vector<Vector> moved;     ///< M^-1 W, per condition
};

struct WrongSign
{
  std::size_t entry;
  double by; ///< in the units of x
};

std::vector<Block> blocksOf(const BandedProgram& program)
{
  const int n = program.M.size();
  std::vector<Block> blocks;
  for (int i = 0, reach = -1; i < n; ++i) {
    if (i > reach)
      blocks.push_back({i, i, {}, {}, {}, {}});
    for (const auto& [j, value] : program.M.rows()[std::size_t(i)])
      if (value != 0.0)
        reach = std::max(reach, j);
    blocks.back().last = i + 1;
  }
  std::vector<int> blockOf;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    blockOf.insert(blockOf.end(), std::size_t(blocks[b].last - blocks[b].first), int(b));
  for (int k = 0; k < program.W.cols(); ++k)
    for (const auto& entry : program.W.column(k)) {
      auto& conditions = blocks[std::size_t(blockOf[std::size_t(entry.first)])].conditions;
      if (conditions.empty() || conditions.back() != k)
        conditions.push_back(k);
    }
  return blocks;
}

/// What one block adds to  W^T M^-1 W.
void addResponse(const Block& block, const SparseColumns& W, SymmetricEntries& response)
{
  for (std::size_t a = 0; a < block.conditions.size(); ++a)
    for (std::size_t b = a; b < block.conditions.size(); ++b) {
      double sum = 0.0;
      for (const auto& [i, value] : W.column(block.conditions[a]))
        if (i >= block.first && i < block.last)
          sum += value * block.moved[b][std::size_t(i - block.first)];
      response.add(block.conditions[a], block.conditions[b], sum);
    }
}

/// Factor of a matrix with a narrow band, of its entries alone where the band is wide.
class BandFactor
{
public:
  explicit BandFactor(const SymmetricEntries& M)
  {
    int width = 0;
    for (std::size_t entry = 0; entry < M.values.size(); ++entry)
      width = std::max(width, M.columns[entry] - M.rows[entry]);
    if (width > widestBand) {
      sparse_.emplace(M);
      return;
    }
    BandMatrix band(M.size, width);
    for (std::size_t entry = 0; entry < M.values.size(); ++entry)
      band(M.columns[entry], M.rows[entry]) += M.values[entry];
    band_.emplace(std::move(band));
  }
  Vector solve(Vector b) const { return sparse_ ? sparse_->solve(b) : band_->solve(std::move(b)); }

private:
  std::optional<BandCholesky> band_;
  std::optional<SparseCholesky> sparse_;
};

class BlockPivoting
{
public:
  explicit BlockPivoting(const BandedProgram& program)
      : program_(program), blocks_(blocksOf(program)), fixed_(program.f.size(), 0), x_(program.f.size(), 0.0),
        multipliers_(program.r.size(), 0.0)
  {
    double response = 0.0;
    for (int k = 0; k < program.W.cols(); ++k) {
      double sum = 0.0;
      for (const auto& [i, value] : program.W.column(k))
        sum += value * value / program.M(i, i);
      response = std::max(response, sum);
    }
    shift_ = proximal * response;
  }

  std::optional<Vector> run()
  {
    for (int step = 0; step < maxProximalSteps; ++step) {
      const Vector old = multipliers_;
      pivot(old);
      if (conditionsMet(old)) {
        for (double& value : x_)
          value = std::min(value, 0.0);
        return x_;
      }
    }
    return std::nullopt;
  }

private:
  void pivot(const Vector& oldMultipliers)
  {
    std::size_t fewest = fixed_.size() + 1;
    int tries = patience;
    for (;;) {
      solve(oldMultipliers);
      const std::vector<WrongSign> wrong = wrongSigns();
      if (wrong.empty())
        return;
      const bool fewer = wrong.size() < fewest;
      tries = fewer ? patience : tries - 1;
      fewest = std::min(fewest, wrong.size());
      exchange(wrong, tries);
    }
  }

  /// All of them; after `patience` failures those that are wrong most, which the others may follow; in the end only the
  /// last one.
  void exchange(const std::vector<WrongSign>& wrong, int tries)
  {
    if (tries < -patienceOfMost) {
      exchange(wrong.back());
      return;
    }
    double largest = 0.0;
    for (const WrongSign& sign : wrong)
      largest = std::max(largest, sign.by);
    const double least = tries < 0 ? most * largest : 0.0;
    for (const WrongSign& sign : wrong)
      if (sign.by >= least)
        exchange(sign);
  }

  void exchange(const WrongSign& sign) { fixed_[sign.entry] = !fixed_[sign.entry]; }

  /// x and the multipliers for the entries that are fixed now: [M W; W^T -e] (x, lambda) = (f, r - e lambda_old).
  void solve(const Vector& oldMultipliers)
  {
    for (Block& block : blocks_) {
      factor(block);
      std::copy(block.x.begin(), block.x.end(), x_.begin() + block.first);
    }
    const int conditions = program_.W.cols();
    if (conditions == 0 || shift_ == 0.0)
      return;
    SymmetricEntries response;
    response.size = conditions;
    Vector gap = program_.W.transposedTimes(x_);
    for (int k = 0; k < conditions; ++k) {
      const auto at = std::size_t(k);
      response.add(k, k, shift_);
      gap[at] += shift_ * oldMultipliers[at] - program_.r[at];
    }
    for (const Block& block : blocks_)
      addResponse(block, program_.W, response);
    multipliers_ = SparseCholesky(response).solve(gap);
    for (const Block& block : blocks_)
      for (std::size_t c = 0; c < block.conditions.size(); ++c)
        for (std::size_t i = 0; i < block.moved[c].size(); ++i)
          x_[std::size_t(block.first) + i] -= block.moved[c][i] * multipliers_[std::size_t(block.conditions[c])];
  }

  /// Solutions of a block, if the ones that it has are of other fixed entries.
  void factor(Block& block) const
  {
    std::vector<char> fixed(fixed_.begin() + block.first, fixed_.begin() + block.last);
    if (fixed == block.factoredSet)
      return;
    const BandFactor M(freePart(block, fixed));
    const auto solution = [&](Vector right) {
      for (std::size_t i = 0; i < right.size(); ++i)
        if (fixed[i])
          right[i] = 0.0;
      return M.solve(std::move(right));
    };
    block.x = solution({program_.f.begin() + block.first, program_.f.begin() + block.last});
    block.moved.clear();
    for (const int k : block.conditions) {
      Vector column(fixed.size(), 0.0);
      for (const auto& [i, value] : program_.W.column(k))
        if (i >= block.first && i < block.last)
          column[std::size_t(i - block.first)] = value;
      block.moved.push_back(solution(std::move(column)));
    }
    block.factoredSet = std::move(fixed);
  }

  /// M with the rows and columns of fixed entries those of a diagonal matrix.
  SymmetricEntries freePart(const Block& block, const std::vector<char>& fixed) const
  {
    SymmetricEntries M;
    M.size = block.last - block.first;
    for (int i = 0; i < M.size; ++i)
      for (const auto& [column, value] : program_.M.rows()[std::size_t(block.first + i)]) {
        const int j = column - block.first; // of the block: nothing couples it with others
        if (i == j || (i < j && value != 0.0 && !fixed[std::size_t(i)] && !fixed[std::size_t(j)]))
          M.add(i, j, value);
      }
    return M;
  }

  /// Free entries above their bound, fixed entries that are held back (f - M x - W lambda < 0).
  std::vector<WrongSign> wrongSigns() const
  {
    Vector pull = program_.f;
    const Vector stress = product(program_.M.rows(), x_), held = program_.W.times(multipliers_);
    double scale = 0.0;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double diagonal = program_.M(int(i), int(i));
      scale = std::max({scale, std::abs(x_[i]), std::abs(pull[i]) / diagonal, std::abs(held[i]) / diagonal});
      pull[i] -= stress[i] + held[i];
    }
    std::vector<WrongSign> wrong;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const double by = fixed_[i] ? -pull[i] / program_.M(int(i), int(i)) : x_[i];
      if (by > roundOff * scale)
        wrong.push_back({i, by});
    }
    return wrong;
  }

  /// W^T x - r = e (lambda - lambda_old) is round-off of its terms.
  bool conditionsMet(const Vector& oldMultipliers) const
  {
    for (int k = 0; k < program_.W.cols(); ++k) {
      const auto at = std::size_t(k);
      const double terms = std::abs(program_.r[at]) + program_.W.magnitude(k, x_);
      if (shift_ * std::abs(multipliers_[at] - oldMultipliers[at]) > roundOff * std::max(terms, program_.force))
        return false;
    }
    return true;
  }

  const BandedProgram& program_;
  std::vector<Block> blocks_;
  std::vector<char> fixed_; ///< per entry: 1 = at its bound
  Vector x_, multipliers_;
  double shift_ = 0.0;
};

} // namespace

std::optional<Vector> minimise(const BandedProgram& program)
{
  const std::size_t n = program.f.size();
  NDFRAME_ASSERT(std::size_t(program.M.size()) == n && std::size_t(program.W.cols()) == program.r.size() &&
                     (program.r.empty() || std::size_t(program.W.rows()) == n),
                 "shapes do not match");
  return BlockPivoting(program).run();
}

} // namespace ndframe
