#include "ndframe/interface/composed_operator.hpp"

#include <algorithm>
#include <utility>

#include "ndframe/interface/applied_operator.hpp"

namespace ndframe
{
namespace
{

/// Each value of a part is one unknown, each unknown belongs to at most one part.
bool areBlocks(const std::vector<OperatorPart>& parts, int size)
{
  std::vector<int> uses(std::size_t(size), 0);
  for (const auto& part : parts)
    for (const auto& input : part.inputs) {
      if (input[0] < 0 || input[1] >= 0)
        return false;
      ++uses[std::size_t(input[0])];
    }
  return std::all_of(uses.begin(), uses.end(), [](int count) { return count <= 1; });
}

/// The parts' own inverses.
class BlockInverse final : public RestrictedInverse
{
public:
  BlockInverse(const std::vector<OperatorPart>& parts, const std::vector<char>& isFree, double shift) : parts_(parts)
  {
    for (const auto& part : parts) {
      std::vector<char> own;
      for (const auto& input : part.inputs)
        own.push_back(isFree[std::size_t(input[0])]);
      inverses_.push_back(part.S->inverseOn(own, shift));
    }
  }

  Vector solve(const Vector& b) const override
  {
    Vector x(b.size(), 0.0);
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      Vector own;
      for (const auto& input : parts_[p].inputs)
        own.push_back(b[std::size_t(input[0])]);
      own = inverses_[p]->solve(own);
      for (std::size_t k = 0; k < own.size(); ++k)
        x[std::size_t(parts_[p].inputs[k][0])] = own[k];
    }
    return x;
  }

private:
  const std::vector<OperatorPart>& parts_;
  std::vector<std::unique_ptr<RestrictedInverse>> inverses_;
};

/// One value u_k of a part as the sum of at most two unknowns, x_alone or x_alone + x_other, where every unknown is the
/// `alone` of one value only: then x follows from all values.
struct PairedValue
{
  std::size_t part = 0, entry = 0;
  int alone = -1; ///< the unknown that this value determines
  int other = -1; ///< determined by another value before
};

/// The values in an order in which they determine the unknowns that they know one after the other; empty if they do
/// not.
std::vector<PairedValue> pairValues(const std::vector<OperatorPart>& parts, int size)
{
  std::vector<PairedValue> values;
  std::vector<char> known(std::size_t(size), 0);
  const auto determine = [&](std::size_t p, std::size_t k, int unknown, int other) {
    if (known[std::size_t(unknown)])
      return false;
    known[std::size_t(unknown)] = 1;
    values.push_back({p, k, unknown, other});
    return true;
  };
  for (const bool pairs : {false, true})
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (std::size_t k = 0; k < parts[p].inputs.size(); ++k) {
        const auto [a, b] = parts[p].inputs[k];
        if (a < 0 || (b >= 0) != pairs)
          continue;
        if (!pairs && !determine(p, k, a, -1))
          return {};
        if (pairs && !(known[std::size_t(a)] ? determine(p, k, b, a) : known[std::size_t(b)] && determine(p, k, a, b)))
          return {};
      }
  std::size_t count = 0;
  for (const auto& part : parts)
    count += part.inputs.size();
  return count == values.size() ? values : std::vector<PairedValue>();
}

class ComposedOperator final : public AppliedOperator
{
public:
  ComposedOperator(std::vector<OperatorPart> parts, int size, double tolerance)
      : AppliedOperator(tolerance), parts_(std::move(parts)), size_(size), areBlocks_(areBlocks(parts_, size))
  {
    const auto knows = [](const OperatorPart& part) {
      const AppliedOperator* S = asApplied(*part.S);
      return S != nullptr && S->hasPreconditioner();
    };
    if (std::all_of(parts_.begin(), parts_.end(), knows))
      values_ = pairValues(parts_, size);
  }
  int size() const override { return size_; }
  Vector apply(const Vector& x) const override
  {
    Vector y(x.size(), 0.0);
    for (const auto& part : parts_) {
      Vector u(part.inputs.size(), 0.0);
      for (std::size_t k = 0; k < u.size(); ++k)
        for (const int i : part.inputs[k])
          u[k] += i < 0 ? 0.0 : x[std::size_t(i)];
      const Vector r = part.S->apply(u);
      for (std::size_t k = 0; k < u.size(); ++k)
        for (const int i : part.inputs[k])
          if (i >= 0)
            y[std::size_t(i)] += r[k];
    }
    return y;
  }

  std::unique_ptr<RestrictedInverse> inverseOn(const std::vector<char>& isFree, double shift) const override
  {
    if (areBlocks_)
      return std::make_unique<BlockInverse>(parts_, isFree, shift);
    return AppliedOperator::inverseOn(isFree, shift);
  }

  bool hasPreconditioner() const override { return !values_.empty(); }

  /// P^-1 diag(S_b^-1) P^-T where the values P x of all parts together determine x.
  Vector precondition(const Vector& b) const override
  {
    if (values_.empty())
      return b;
    std::vector<Vector> parts;
    for (const auto& part : parts_)
      parts.emplace_back(part.inputs.size(), 0.0);
    Vector rest = b;
    for (auto value = values_.rbegin(); value != values_.rend(); ++value) { // P^T f = b, the last one first
      const double force = rest[std::size_t(value->alone)];
      parts[value->part][value->entry] = force;
      if (value->other >= 0)
        rest[std::size_t(value->other)] -= force;
    }
    for (std::size_t p = 0; p < parts_.size(); ++p)
      parts[p] = asApplied(*parts_[p].S)->precondition(parts[p]);
    Vector x(b.size(), 0.0);
    for (const auto& value : values_)
      x[std::size_t(value.alone)] =
          parts[value.part][value.entry] - (value.other >= 0 ? x[std::size_t(value.other)] : 0.0);
    return x;
  }

private:
  std::vector<OperatorPart> parts_;
  int size_;
  bool areBlocks_;
  std::vector<PairedValue> values_; ///< empty: no preconditioner
};

bool isIdentity(const OperatorPart& part, int size)
{
  if (int(part.inputs.size()) != size)
    return false;
  for (int k = 0; k < size; ++k)
    if (part.inputs[std::size_t(k)] != std::array<int, 2>{k, -1})
      return false;
  return true;
}

DenseMatrix sumOfParts(const std::vector<OperatorPart>& parts, int size)
{
  DenseMatrix sum(size, size);
  for (const auto& part : parts) {
    const DenseMatrix& S = *part.S->dense();
    for (int k = 0; k < S.cols(); ++k)
      for (const int j : part.inputs[std::size_t(k)])
        for (int l = 0; j >= 0 && l < S.rows(); ++l)
          for (const int i : part.inputs[std::size_t(l)])
            if (i >= 0)
              sum(i, j) += S(l, k);
  }
  return sum;
}

} // namespace

std::shared_ptr<const SymmetricOperator> composeOperators(std::vector<OperatorPart> parts, int size)
{
  if (parts.size() == 1 && isIdentity(parts.front(), size))
    return parts.front().S;
  if (std::all_of(parts.begin(), parts.end(), [](const OperatorPart& part) { return part.S->dense() != nullptr; }))
    return makeDenseOperator(sumOfParts(parts, size));
  double tolerance = 0.0;
  for (const auto& part : parts)
    tolerance = std::max(tolerance, toleranceOf(*part.S));
  return std::make_shared<ComposedOperator>(std::move(parts), size, tolerance);
}

} // namespace ndframe
