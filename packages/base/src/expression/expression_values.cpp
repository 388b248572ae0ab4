#include <algorithm>
#include <cmath>
#include <iterator>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/expression_tree.hpp"

namespace ndframe
{
namespace
{

/// Points that are worked on at a time: the values of all operations stay in the first cache.
constexpr int blockSize = 64;

using Block = std::array<double, blockSize>;

double power(double a, double b)
{
  if (b == 2.0)
    return a * a;
  return b == 3.0 ? a * a * a : std::pow(a, b);
}

double sign(double a)
{
  return a < 0.0 ? -1.0 : a > 0.0 ? 1.0 : 0.0;
}

double comparison(Operation operation, double a)
{
  switch (operation) {
  case Operation::IsNegative:
    return a < 0.0;
  case Operation::IsNonPositive:
    return a <= 0.0;
  case Operation::IsPositive:
    return a > 0.0;
  case Operation::IsNonNegative:
    return a >= 0.0;
  case Operation::IsZero:
    return a == 0.0;
  default:
    return a != 0.0;
  }
}

using Function = double (*)(double);

/// The functions of one number, Abs to Sqrt; Atan2 among them has two.
constexpr Function elementary[] = {[](double a) { return std::abs(a); },         sign,
                                   [](double a) { return std::floor(a + 0.5); }, [](double a) { return std::sin(a); },
                                   [](double a) { return std::cos(a); },         [](double a) { return std::tan(a); },
                                   [](double a) { return std::asin(a); },        [](double a) { return std::acos(a); },
                                   [](double a) { return std::atan(a); },        nullptr,
                                   [](double a) { return std::sinh(a); },        [](double a) { return std::cosh(a); },
                                   [](double a) { return std::tanh(a); },        [](double a) { return std::asinh(a); },
                                   [](double a) { return std::acosh(a); },       [](double a) { return std::atanh(a); },
                                   [](double a) { return std::exp(a); },         [](double a) { return std::log(a); },
                                   [](double a) { return std::sqrt(a); }};
static_assert(std::size(elementary) == std::size_t(Operation::Sqrt) - std::size_t(Operation::Abs) + 1);

Function elementaryFunction(Operation operation)
{
  NDFRAME_ASSERT(operation >= Operation::Abs && operation <= Operation::Sqrt && operation != Operation::Atan2,
                 "an operation without a value");
  return elementary[std::size_t(operation) - std::size_t(Operation::Abs)];
}

bool isComparison(Operation operation)
{
  return operation >= Operation::IsNegative && operation <= Operation::IsNonZero;
}

template <class Value>
void fill(Block& result, int count, const Value& value)
{
  for (std::size_t i = 0; i < std::size_t(count); ++i)
    result[i] = value(i);
}

void evaluate(const ExpressionNode& node, const double* points, int count, std::vector<Block>& values, Block& result)
{
  const auto operand = [&](std::size_t k) {
    return node.operands[k] < 0 ? result.data() : values[std::size_t(node.operands[k])].data();
  };
  const double *a = operand(0), *b = operand(1), *c = operand(2);
  switch (node.operation) {
  case Operation::Constant:
    return fill(result, count, [&](std::size_t) { return node.constant; });
  case Operation::X:
  case Operation::Y:
  case Operation::Z: {
    const std::size_t axis = std::size_t(node.operation) - std::size_t(Operation::X);
    return fill(result, count, [&](std::size_t i) { return points[3 * i + axis]; });
  }
  case Operation::Add:
    return fill(result, count, [&](std::size_t i) { return a[i] + b[i]; });
  case Operation::Subtract:
    return fill(result, count, [&](std::size_t i) { return a[i] - b[i]; });
  case Operation::Multiply:
    return fill(result, count, [&](std::size_t i) { return a[i] * b[i]; });
  default:
    return fill(result, count, [&](std::size_t i) { return valueOf(node.operation, a[i], b[i], c[i]); });
  }
}

} // namespace

double valueOf(Operation operation, double a, double b, double c)
{
  switch (operation) {
  case Operation::Add:
    return a + b;
  case Operation::Subtract:
    return a - b;
  case Operation::Multiply:
    return a * b;
  case Operation::Divide:
    return a / b;
  case Operation::Power:
    return power(a, b);
  case Operation::Negate:
    return -a;
  case Operation::And:
    return a != 0.0 && b != 0.0;
  case Operation::Or:
    return a != 0.0 || b != 0.0;
  case Operation::Choose:
    return a != 0.0 ? b : c;
  case Operation::Minimum:
    return std::min(a, b);
  case Operation::Maximum:
    return std::max(a, b);
  case Operation::Atan2:
    return std::atan2(a, b);
  default:
    return isComparison(operation) ? comparison(operation, a) : elementaryFunction(operation)(a);
  }
}

void ExpressionTree::values(const double* points, int count, double* result) const
{
  thread_local std::vector<Block> values;
  if (values.size() < nodes_.size())
    values.resize(nodes_.size());
  for (int first = 0; first < count; first += blockSize) {
    const int size = std::min(blockSize, count - first);
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      evaluate(nodes_[n], points + std::ptrdiff_t(3) * first, size, values, values[n]);
    std::copy_n(values[nodes_.size() - 1].begin(), size, result + first);
  }
}

} // namespace ndframe
