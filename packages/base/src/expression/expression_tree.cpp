#include "ndframe/base/expression_tree.hpp"

#include <algorithm>

#include "expression_parser.hpp"

namespace ndframe
{
namespace
{

bool isVariable(Operation operation)
{
  return operation == Operation::X || operation == Operation::Y || operation == Operation::Z;
}

/// A whole number >= 0 that is a sensible degree; -1: none.
int exponentOf(const ExpressionNode& node)
{
  constexpr int largest = 64;
  const double value = node.constant;
  const bool counts = node.operation == Operation::Constant && value >= 0.0 && value <= largest;
  return counts && value == int(value) ? int(value) : -1;
}

/// The degree of a polynomial made by an operation of polynomials; -1: it makes none.
int degreeOf(const ExpressionNode& node, const std::vector<ExpressionNode>& nodes)
{
  const auto degree = [&](std::size_t k) { return nodes[std::size_t(node.operands[k])].degree; };
  if (node.operation == Operation::Constant)
    return 0;
  if (isVariable(node.operation))
    return 1;
  if (node.operation == Operation::Negate)
    return degree(0);
  if (node.operands[1] < 0 || degree(0) < 0 || degree(1) < 0)
    return -1;
  switch (node.operation) {
  case Operation::Add:
  case Operation::Subtract:
    return std::max(degree(0), degree(1));
  case Operation::Multiply:
    return degree(0) + degree(1);
  case Operation::Divide: {
    const ExpressionNode& divisor = nodes[std::size_t(node.operands[1])];
    return divisor.operation == Operation::Constant && divisor.constant != 0.0 ? degree(0) : -1;
  }
  case Operation::Power: {
    const int exponent = exponentOf(nodes[std::size_t(node.operands[1])]);
    return exponent < 0 ? -1 : degree(0) * exponent;
  }
  default:
    return -1;
  }
}

bool isSameOperation(const ExpressionNode& a, const ExpressionNode& b)
{
  return a.operation == b.operation && a.operands == b.operands && a.constant == b.constant;
}

} // namespace

std::optional<AffineFunction> affineOf(const ExpressionNode& node, const std::optional<AffineFunction>& a,
                                       const std::optional<AffineFunction>& b)
{
  const auto isNumber = [](const auto& f) { return f && (*f)[1] == 0.0 && (*f)[2] == 0.0 && (*f)[3] == 0.0; };
  const Operation operation = node.operation;
  if (operation == Operation::Constant)
    return AffineFunction{node.constant, 0.0, 0.0, 0.0};
  if (isVariable(operation))
    return AffineFunction{0.0, double(operation == Operation::X), double(operation == Operation::Y),
                          double(operation == Operation::Z)};
  if (operation == Operation::Negate && a)
    return AffineFunction{-(*a)[0], -(*a)[1], -(*a)[2], -(*a)[3]};
  const bool isSum = operation == Operation::Add || operation == Operation::Subtract;
  const bool isScaled = (operation == Operation::Multiply || operation == Operation::Divide) && isNumber(b);
  if (!a || !b || !(isSum || isScaled || (operation == Operation::Multiply && isNumber(a))))
    return {};
  AffineFunction f{};
  for (std::size_t i = 0; i < f.size(); ++i)
    f[i] = isSum      ? valueOf(operation, (*a)[i], (*b)[i], 0.0)
           : isScaled ? valueOf(operation, (*a)[i], (*b)[0], 0.0)
                      : (*a)[0] * (*b)[i];
  return f;
}

ExpressionTree::ExpressionTree(const std::string& text)
{
  finish(parseExpression(text, *this));
}

ExpressionTree ExpressionTree::part(int place) const
{
  ExpressionTree tree = *this;
  tree.finish(place);
  return tree;
}

bool ExpressionTree::isSame(const ExpressionTree& other) const
{
  return std::equal(nodes_.begin(), nodes_.end(), other.nodes_.begin(), other.nodes_.end(), isSameOperation);
}

int ExpressionTree::place(const ExpressionNode& node)
{
  const auto found = std::find_if(nodes_.begin(), nodes_.end(),
                                  [&](const ExpressionNode& other) { return isSameOperation(node, other); });
  if (found == nodes_.end()) {
    nodes_.push_back(node);
    return int(nodes_.size()) - 1;
  }
  return int(found - nodes_.begin());
}

int ExpressionTree::addConstant(double value)
{
  ExpressionNode node;
  node.constant = value;
  node.degree = 0;
  node.affine[0] = value;
  return place(node);
}

int ExpressionTree::add(Operation operation, int a, int b, int c)
{
  ExpressionNode node;
  node.operation = operation;
  node.operands = {a, b, c};
  const auto isNumber = [&](int k) { return k < 0 || nodes_[std::size_t(k)].operation == Operation::Constant; };
  if (isVariable(operation))
    isConstant_ = false;
  else if (isNumber(a) && isNumber(b) && isNumber(c)) {
    const auto number = [&](int k) { return k < 0 ? 0.0 : nodes_[std::size_t(k)].constant; };
    return addConstant(valueOf(operation, number(a), number(b), number(c)));
  } else if (operation == Operation::Power && exponentOf(nodes_[std::size_t(b)]) == 0)
    return addConstant(1.0);
  node.degree = degreeOf(node, nodes_);
  const auto affine = [&](int k) {
    const bool isAffine = k >= 0 && nodes_[std::size_t(k)].isAffine();
    return isAffine ? std::optional<AffineFunction>(nodes_[std::size_t(k)].affine) : std::nullopt;
  };
  if (const auto f = affineOf(node, affine(a), affine(b)); f && node.isAffine())
    node.affine = *f;
  else if (node.isAffine()) // a first power
    node.affine = nodes_[std::size_t(a)].affine;
  return place(node);
}

/// Leaves out what the root does not need and marks the features.
void ExpressionTree::finish(int root)
{
  std::vector<char> isNeeded(nodes_.size(), 0);
  isNeeded[std::size_t(root)] = 1;
  for (int n = root; n >= 0; --n)
    for (const int operand : nodes_[std::size_t(n)].operands)
      if (isNeeded[std::size_t(n)] && operand >= 0)
        isNeeded[std::size_t(operand)] = 1;
  std::vector<int> renumbered(nodes_.size(), -1);
  std::vector<ExpressionNode> kept;
  for (int n = 0; n <= root; ++n) {
    if (!isNeeded[std::size_t(n)])
      continue;
    ExpressionNode node = nodes_[std::size_t(n)];
    for (int& operand : node.operands)
      operand = operand < 0 ? -1 : renumbered[std::size_t(operand)];
    for (const int operand : node.operands)
      if (operand >= 0 && !node.isAffine() && kept[std::size_t(operand)].degree == 1)
        kept[std::size_t(operand)].isFeature = true;
    renumbered[std::size_t(n)] = int(kept.size());
    kept.push_back(node);
  }
  nodes_ = std::move(kept);
}

} // namespace ndframe
