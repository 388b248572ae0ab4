#include "expression_parser.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

namespace ndframe
{
namespace
{

/// A name of the grammar.
struct Name
{
  std::string_view text;
  Operation operation;
};

/// Functions of one number, by their names in muParser.
constexpr Name functions[] = {
    {"abs", Operation::Abs},     {"sign", Operation::Sign},   {"rint", Operation::Round},  {"sin", Operation::Sin},
    {"cos", Operation::Cos},     {"tan", Operation::Tan},     {"asin", Operation::Asin},   {"acos", Operation::Acos},
    {"atan", Operation::Atan},   {"sinh", Operation::Sinh},   {"cosh", Operation::Cosh},   {"tanh", Operation::Tanh},
    {"asinh", Operation::Asinh}, {"acosh", Operation::Acosh}, {"atanh", Operation::Atanh}, {"exp", Operation::Exp},
    {"log", Operation::Log},     {"ln", Operation::Log},      {"sqrt", Operation::Sqrt}};

/// The longer names first.
constexpr Name comparisons[] = {{"<=", Operation::IsNonPositive}, {">=", Operation::IsNonNegative},
                                {"==", Operation::IsZero},        {"!=", Operation::IsNonZero},
                                {"<", Operation::IsNegative},     {">", Operation::IsPositive}};

/// Functions of any number of numbers: one operation from the first to the last.
struct Fold
{
  std::string_view text;
  Operation operation;
  bool isMean;
};

constexpr Fold folds[] = {{"min", Operation::Minimum, false},
                          {"max", Operation::Maximum, false},
                          {"sum", Operation::Add, false},
                          {"avg", Operation::Add, true}};

template <class Named, std::size_t count>
const Named* find(const Named (&list)[count], std::string_view text)
{
  const auto* found =
      std::find_if(std::begin(list), std::end(list), [text](const Named& named) { return named.text == text; });
  return found == std::end(list) ? nullptr : found;
}

/// Recursive descent; the priorities are muParser's, so -x^2 is -(x^2) and 2^3^2 is 2^9.
class Parser
{
public:
  Parser(const std::string& text, ExpressionTree& tree) : text_(text), tree_(tree) {}

  int whole()
  {
    const int root = conditional();
    if (skipped() != text_.size())
      refuse();
    return root;
  }

private:
  std::size_t skipped()
  {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])))
      ++at_;
    return at_;
  }

  bool take(std::string_view token)
  {
    if (text_.compare(skipped(), token.size(), token) != 0)
      return false;
    at_ += token.size();
    return true;
  }

  void expect(std::string_view token)
  {
    if (!take(token))
      refuse();
  }

  [[noreturn]] void refuse() const
  {
    throw std::invalid_argument(fmt::format("\"{}\" at character {} is not understood", text_.substr(at_), at_ + 1));
  }

  /// Refuses what is nested deeper than the stack is sure to hold.
  struct Level
  {
    explicit Level(int& depth) : depth_(depth)
    {
      if (++depth_ > 200)
        throw std::invalid_argument("it is nested more than 200 levels deep");
    }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    int& depth_;
  };

  int conditional()
  {
    const Level level(depth_);
    const int condition = disjunction();
    if (!take("?"))
      return condition;
    const int yes = conditional();
    expect(":");
    return tree_.add(Operation::Choose, condition, yes, conditional());
  }

  int disjunction()
  {
    int left = conjunction();
    while (take("||"))
      left = tree_.add(Operation::Or, left, conjunction());
    return left;
  }

  int conjunction()
  {
    int left = comparison();
    while (take("&&"))
      left = tree_.add(Operation::And, left, comparison());
    return left;
  }

  int comparison()
  {
    int left = sum();
    for (;;) {
      const auto* found = std::find_if(std::begin(comparisons), std::end(comparisons),
                                       [this](const Name& name) { return take(name.text); });
      if (found == std::end(comparisons))
        return left;
      left = tree_.add(found->operation, tree_.add(Operation::Subtract, left, sum()));
    }
  }

  int sum()
  {
    int left = product();
    for (;;)
      if (take("+"))
        left = tree_.add(Operation::Add, left, product());
      else if (take("-"))
        left = tree_.add(Operation::Subtract, left, product());
      else
        return left;
  }

  int product()
  {
    int left = signedPower();
    for (;;)
      if (take("*"))
        left = tree_.add(Operation::Multiply, left, signedPower());
      else if (take("/"))
        left = tree_.add(Operation::Divide, left, signedPower());
      else
        return left;
  }

  int signedPower()
  {
    const Level level(depth_);
    if (take("-"))
      return tree_.add(Operation::Negate, signedPower());
    if (take("+"))
      return signedPower();
    const int base = primary();
    return take("^") ? tree_.add(Operation::Power, base, signedPower()) : base;
  }

  int primary()
  {
    if (take("(")) {
      const int inside = conditional();
      expect(")");
      return inside;
    }
    if (skipped() == text_.size())
      refuse();
    return std::isalpha(static_cast<unsigned char>(text_[at_])) ? named() : number();
  }

  int number()
  {
    double value = 0.0;
    const char* end = text_.data() + text_.size();
    const auto result = std::from_chars(text_.data() + at_, end, value);
    if (result.ec != std::errc())
      refuse();
    at_ = std::size_t(result.ptr - text_.data());
    return tree_.addConstant(value);
  }

  int named();
  int call(std::string_view name);
  int combined(std::string_view name, const std::vector<int>& arguments);

  const std::string& text_;
  ExpressionTree& tree_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

int Parser::named()
{
  const std::size_t start = at_;
  while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_'))
    ++at_;
  const std::string_view name = std::string_view(text_).substr(start, at_ - start);
  if (name == "pi")
    return tree_.addConstant(3.14159265358979323846);
  if (name.size() == 1 && name[0] >= 'x' && name[0] <= 'z')
    return tree_.add(Operation(int(Operation::X) + (name[0] - 'x')), -1);
  if (!take("("))
    refuse();
  return call(name);
}

int Parser::call(std::string_view name)
{
  std::vector<int> arguments{conditional()};
  while (take(","))
    arguments.push_back(conditional());
  expect(")");
  if (const Name* function = find(functions, name); function != nullptr && arguments.size() == 1)
    return tree_.add(function->operation, arguments[0]);
  if (name == "log2" || name == "log10")
    return tree_.add(Operation::Divide, tree_.add(Operation::Log, arguments[0]),
                     tree_.addConstant(name == "log2" ? 0.693147180559945309417 : 2.30258509299404568402));
  return combined(name, arguments);
}

int Parser::combined(std::string_view name, const std::vector<int>& arguments)
{
  if (name == "atan2" && arguments.size() == 2)
    return tree_.add(Operation::Atan2, arguments[0], arguments[1]);
  const Fold* fold = find(folds, name);
  if (fold == nullptr)
    refuse();
  int result = arguments[0];
  for (std::size_t k = 1; k < arguments.size(); ++k) {
    const bool isSum = fold->operation == Operation::Add;
    const int difference = isSum ? -1 : tree_.add(Operation::Subtract, result, arguments[k]);
    result = tree_.add(fold->operation, result, arguments[k], difference);
  }
  return fold->isMean ? tree_.add(Operation::Divide, result, tree_.addConstant(double(arguments.size()))) : result;
}

} // namespace

int parseExpression(const std::string& text, ExpressionTree& tree)
{
  return Parser(text, tree).whole();
}

} // namespace ndframe
