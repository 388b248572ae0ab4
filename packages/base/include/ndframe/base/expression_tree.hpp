#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace ndframe
{

/// What a node of an expression computes from its operands.
enum class Operation
{
  Constant,
  X,
  Y,
  Z,
  Add,
  Subtract,
  Multiply,
  Divide,
  Power,
  Negate,
  IsNegative, ///< the six comparisons, of a difference with zero
  IsNonPositive,
  IsPositive,
  IsNonNegative,
  IsZero,
  IsNonZero,
  And,
  Or,
  Choose,  ///< a ? b : c
  Minimum, ///< of a and b; c is a - b
  Maximum,
  Abs,
  Sign,
  Round,
  Sin,
  Cos,
  Tan,
  Asin,
  Acos,
  Atan,
  Atan2,
  Sinh,
  Cosh,
  Tanh,
  Asinh,
  Acosh,
  Atanh,
  Exp,
  Log,
  Sqrt
};

/// c_0 + c_1 x + c_2 y + c_3 z.
using AffineFunction = std::array<double, 4>;

/// One operation of an expression.
struct ExpressionNode
{
  Operation operation = Operation::Constant; ///< what the node computes
  std::array<int, 3> operands{-1, -1, -1};   ///< places in the tree, all before this one; -1: unused
  double constant = 0.0;                     ///< the value of a Constant
  int degree = -1;                           ///< of the polynomial in x, y, z that it is; -1: it is none
  AffineFunction affine{};                   ///< its coefficients when degree <= 1
  bool isFeature = false;                    ///< an affine function that something not affine is made of

  bool isAffine() const { return degree == 0 || degree == 1; } ///< constants are, too
};

/// An expression in x, y, z as its operations, operands first, the whole expression last. Equal operations stand once.
class ExpressionTree
{
public:
  /// Reads the grammar of muParser 2.3 (docs/dependencies.md says why it is read here): + - * / ^, comparisons, && ||,
  /// ?:, its functions, pi. Throws std::invalid_argument for what it does not know.
  explicit ExpressionTree(const std::string& text);

  const std::vector<ExpressionNode>& nodes() const { return nodes_; } ///< the last one is the whole expression
  const ExpressionNode& root() const { return nodes_.back(); }        ///< the whole expression
  /// The text uses none of x, y, z.
  bool isConstant() const { return isConstant_; }

  /// Its values at `count` points of three coordinates each. Not finite where it is not defined.
  void values(const double* points, int count, double* result) const;

  /// The expression that one of its operations is.
  ExpressionTree part(int place) const;
  /// The same operations.
  bool isSame(const ExpressionTree& other) const;

  /// Adds an operation unless it is there; returns its place. Operations on constants are carried out.
  int add(Operation operation, int a, int b = -1, int c = -1);
  int addConstant(double value); ///< place of a Constant of this value

private:
  int place(const ExpressionNode& node);
  void finish(int root);

  std::vector<ExpressionNode> nodes_;
  bool isConstant_ = true;
};

/// The affine function that an operation makes of affine functions; nothing when it makes none or an operand is none.
std::optional<AffineFunction> affineOf(const ExpressionNode& node, const std::optional<AffineFunction>& a,
                                       const std::optional<AffineFunction>& b);

/// The value of an operation on numbers; operands that it does not have are ignored.
double valueOf(Operation operation, double a, double b, double c);

} // namespace ndframe
