#include "ndframe/interface/congruence.hpp"

#include <algorithm>
#include <utility>

#include "ndframe/interface/applied_operator.hpp"
#include "substitution.hpp"

namespace ndframe
{
namespace
{

/// Added to the stiffness of a motion, relative to the stiffest, so that it has an inverse.
constexpr double softest = 1e-6;

/// P_F^-1 diag(S_FF^-1) P_F^-T of a set that no value leaves.
class SubstitutedInverse final : public RestrictedInverse
{
public:
  SubstitutedInverse(const Substitution& substitution, std::vector<std::unique_ptr<RestrictedInverse>> inverses,
                     std::vector<char> isFree)
      : substitution_(substitution), inverses_(std::move(inverses)), isFree_(std::move(isFree))
  {}

  Vector solve(const Vector& b) const override
  {
    std::vector<Vector> values = substitution_.forces(b);
    for (std::size_t p = 0; p < values.size(); ++p)
      values[p] = inverses_[p]->solve(values[p]);
    Vector x = substitution_.unknowns(values);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = isFree_[i] ? x[i] : 0.0;
    return x;
  }

private:
  const Substitution& substitution_;
  std::vector<std::unique_ptr<RestrictedInverse>> inverses_;
  std::vector<char> isFree_;
};

/// Each value is an unknown itself.
bool isSelection(const std::vector<CongruencePart>& parts)
{
  return std::all_of(parts.begin(), parts.end(), [](const CongruencePart& part) {
    return std::all_of(part.P.begin(), part.P.end(),
                       [](const SparseRow& row) { return row.size() == 1 && row.front().second == 1.0; });
  });
}

class CongruentOperator final : public AppliedOperator
{
public:
  CongruentOperator(std::vector<CongruencePart> parts, int size, int motions, double tolerance)
      : AppliedOperator(tolerance), parts_(std::move(parts)), size_(size), motions_(motions),
        isSelection_(isSelection(parts_)), substitution_(parts_, size - motions)
  {
    knowsInverses_ = std::all_of(parts_.begin(), parts_.end(), [](const CongruencePart& part) {
      const AppliedOperator* S = asApplied(*part.S);
      return S != nullptr && S->hasPreconditioner();
    });
  }

  int size() const override { return size_; }

  Vector apply(const Vector& x) const override
  {
    Vector y(x.size(), 0.0);
    for (const CongruencePart& part : parts_) {
      Vector values(part.P.size(), 0.0);
      for (std::size_t k = 0; k < values.size(); ++k)
        for (const auto& [i, coefficient] : part.P[k])
          values[k] += coefficient * x[std::size_t(i)];
      const Vector forces = part.S->apply(values);
      for (std::size_t k = 0; k < forces.size(); ++k)
        for (const auto& [i, coefficient] : part.P[k])
          y[std::size_t(i)] += coefficient * forces[k];
    }
    return y;
  }

  std::unique_ptr<RestrictedInverse> inverseOn(const std::vector<char>& isFree, double shift) const override
  {
    if (motions_ > 0 || !substitution_.exists() || (shift > 0.0 && !isSelection_))
      return AppliedOperator::inverseOn(isFree, shift);
    const auto values = substitution_.valuesOf(isFree);
    if (values.size() != parts_.size())
      return AppliedOperator::inverseOn(isFree, shift);
    std::vector<std::unique_ptr<RestrictedInverse>> inverses;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      inverses.push_back(parts_[p].S->inverseOn(values[p], shift));
    return std::make_unique<SubstitutedInverse>(substitution_, std::move(inverses), isFree);
  }

  void forgetSolutions() const override
  {
    for (const CongruencePart& part : parts_)
      part.S->forgetSolutions();
    motionInverse_ = {};
  }

  bool hasPreconditioner() const override { return knowsInverses_ && substitution_.exists(); }

  Vector precondition(const Vector& b) const override
  {
    if (!hasPreconditioner())
      return b;
    const auto n = std::ptrdiff_t(size_ - motions_);
    std::vector<Vector> values = substitution_.forces(Vector(b.begin(), b.begin() + n));
    for (std::size_t p = 0; p < parts_.size(); ++p)
      values[p] = asApplied(*parts_[p].S)->precondition(values[p]);
    Vector x = substitution_.unknowns(values);
    if (motions_ > 0) {
      if (motionInverse_.rows() == 0)
        invertMotions();
      const Vector motion = multiply(motionInverse_, Vector(b.begin() + n, b.end()));
      x.insert(x.end(), motion.begin(), motion.end());
    }
    return x;
  }

private:
  /// Of the operator on the motions alone; the unit matrix times a stiffness where it does not feel one.
  void invertMotions() const
  {
    const int n = size_ - motions_;
    DenseMatrix A(motions_, motions_);
    double largest = 0.0;
    for (int m = 0; m < motions_; ++m) {
      Vector unit(std::size_t(size_), 0.0);
      unit[std::size_t(n) + std::size_t(m)] = 1.0;
      const Vector column = apply(unit);
      std::copy(column.begin() + n, column.end(), A.col(m));
      largest = std::max(largest, A(m, m));
    }
    for (int m = 0; m < motions_; ++m)
      A(m, m) += largest > 0.0 ? softest * largest : 1.0;
    motionInverse_ = pseudoInverse(A, 0.0);
  }

  std::vector<CongruencePart> parts_;
  int size_, motions_;
  bool isSelection_, knowsInverses_ = false;
  Substitution substitution_;
  mutable DenseMatrix motionInverse_; ///< empty until it is needed
};

bool isUnit(const CongruencePart& part, int size)
{
  if (int(part.P.size()) != size)
    return false;
  for (int k = 0; k < size; ++k)
    if (part.P[std::size_t(k)] != SparseRow{{k, 1.0}})
      return false;
  return true;
}

void addStored(const CongruencePart& part, DenseMatrix& sum)
{
  const DenseMatrix& S = *part.S->dense();
  const int n = S.rows();
  DenseMatrix SP(n, sum.cols());
  for (int l = 0; l < n; ++l)
    for (const auto& [j, coefficient] : part.P[std::size_t(l)])
      for (int k = 0; k < n; ++k)
        SP(k, j) += coefficient * S(k, l);
  for (int j = 0; j < sum.cols(); ++j)
    for (int k = 0; k < n; ++k)
      for (const auto& [i, coefficient] : part.P[std::size_t(k)])
        sum(i, j) += coefficient * SP(k, j);
}

} // namespace

std::shared_ptr<const SymmetricOperator> congruence(std::vector<CongruencePart> parts, int size, int motions)
{
  if (parts.size() == 1 && isUnit(parts.front(), size))
    return parts.front().S;
  if (std::all_of(parts.begin(), parts.end(), [](const CongruencePart& part) { return part.S->dense() != nullptr; })) {
    DenseMatrix sum(size, size);
    for (const CongruencePart& part : parts)
      addStored(part, sum);
    return makeDenseOperator(std::move(sum));
  }
  double tolerance = 0.0;
  for (const CongruencePart& part : parts)
    tolerance = std::max(tolerance, toleranceOf(*part.S));
  return std::make_shared<CongruentOperator>(std::move(parts), size, motions, tolerance);
}

} // namespace ndframe
