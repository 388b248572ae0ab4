#include "ndframe/interface/composed_operator.hpp"

#include <algorithm>
#include <utility>

#include "ndframe/interface/applied_operator.hpp"

namespace ndframe
{
namespace
{

class ComposedOperator final : public AppliedOperator
{
public:
  ComposedOperator(std::vector<OperatorPart> parts, int size, double tolerance)
      : AppliedOperator(tolerance), parts_(std::move(parts)), size_(size)
  {}
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

private:
  std::vector<OperatorPart> parts_;
  int size_;
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
