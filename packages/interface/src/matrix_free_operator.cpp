#include "ndframe/interface/applied_operator.hpp"
#include "operators.hpp"

namespace ndframe
{
namespace
{

class MatrixFreeSchur final : public AppliedOperator
{
public:
  MatrixFreeSchur(const CondensedBody& body, int size, double tolerance)
      : AppliedOperator(tolerance), body_(body), size_(size)
  {}
  int size() const override { return size_; }
  Vector apply(const Vector& x) const override { return body_.applySchur(x); }

private:
  const CondensedBody& body_;
  int size_;
};

class MatrixFreeOperator final : public InterfaceOperator
{
public:
  explicit MatrixFreeOperator(double tolerance) : tolerance_(tolerance) {}
  std::unique_ptr<SymmetricOperator> represent(const CondensedBody& body, int size) const override
  {
    return makeMatrixFree(body, size, tolerance_);
  }

private:
  double tolerance_;
};

} // namespace

std::unique_ptr<SymmetricOperator> makeMatrixFree(const CondensedBody& body, int size, double tolerance)
{
  return std::make_unique<MatrixFreeSchur>(body, size, tolerance);
}

void registerMatrixFreeOperator(Registry<InterfaceOperator>& registry)
{
  registry.add("Matrix Free", "S applied by one back-solve a time, inverted by conjugate gradients: no n^2 memory.",
               {ParamSpec("Tolerance", interfaceTolerance, inOpenRange(0.0, 1.0),
                          "Relative residual of the conjugate gradients on the interface.")},
               [](const Params& p) { return std::make_unique<MatrixFreeOperator>(p.get<double>("Tolerance")); });
}

} // namespace ndframe
