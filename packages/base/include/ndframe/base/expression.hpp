#pragma once

#include <memory>
#include <string>

namespace ndframe
{

/// A scalar function of the position written in the deck, e.g. "0.5*x^2" (parsed by muParser).
class Expression
{
public:
  /// Throws std::invalid_argument with muParser's reason and the position when `text` does not parse.
  explicit Expression(const std::string& text);

  double operator()(double x, double y, double z) const; ///< value at a point; not finite where it is not defined
  const std::string& text() const { return text_; }      ///< as given to the constructor
  /// True when the text uses none of x, y, z.
  bool isConstant() const;

private:
  struct Parser;
  std::string text_;
  std::shared_ptr<Parser> parser_;
};

} // namespace ndframe
