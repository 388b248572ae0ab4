#include <algorithm>
#include <cmath>

#include "certificate/drawn_scene.hpp"

namespace ndframe::test
{
namespace
{

/// A function of one coordinate that points may miss, with its integral over [0, length] and that of its absolute
/// value, from above.
struct Needle
{
  std::string text;
  double integral = 0.0, size = 0.0;
  bool isSmooth = false; ///< a displacement may be so: it does not jump, and its slope is bounded
};

/// 1 + 20 times a Gauss bell, a strip, a hat, a steep step; or |x|, sqrt|x|: at a random place with a random width.
Needle drawNeedle(const char* axis, double length, Draw& draw)
{
  const double c = draw.uniform(0.0, length), w = length * draw.logarithmic(1e-4, 0.5);
  const double left = std::max(0.0, c - w), right = std::min(length, c + w);
  const std::string X = fmt::format("({} - {:.17g})", axis, c), W = fmt::format("{:.17g}", w);
  switch (draw.integer(0, 5)) {
  case 0: {
    const double bell = 0.5 * std::sqrt(M_PI) * w * (std::erf((length - c) / w) + std::erf(c / w));
    return {"(1 + 20*exp(-(" + X + "/" + W + ")^2))", length + 20.0 * bell, length + 20.0 * bell, true};
  }
  case 1:
    return {"(1 + 10*(" + X + " > -" + W + ")*(" + X + " < " + W + "))", length + 10.0 * (right - left),
            length + 10.0 * (right - left), false};
  case 2: {
    const auto F = [&](double s) { return s - s * s / (2.0 * w); };
    return {"max(0, 1 - abs(" + X + ")/" + W + ")", F(c - left) + F(right - c), F(c - left) + F(right - c), true};
  }
  case 3: {
    const auto F = [&](double s) { return s + w * std::log1p(std::exp(-2.0 * s / w)); }; // int_0^s tanh + constant
    return {"(2 + tanh(" + X + "/" + W + "))", 2.0 * length + F(length - c) - F(c), 3.0 * length, true};
  }
  case 4: {
    const double integral = 0.5 * (c * c + (length - c) * (length - c));
    return {"abs" + X, integral, integral, true};
  }
  default: {
    const double integral = 2.0 / 3.0 * (std::pow(c, 1.5) + std::pow(length - c, 1.5));
    return {"sqrt(abs(" + X + "))", integral, integral, false};
  }
  }
}

/// 1, and 10 more in an ellipse inside [0, width] x [0, height] of x and y, or in a part of it below a parabola.
Needle drawPatch(double width, double height, Draw& draw)
{
  const auto number = [](double value) { return fmt::format("({:.17g})", value); };
  Needle patch;
  if (draw.chance(0.5)) {
    const double a = width * draw.logarithmic(1e-3, 0.5), b = height * draw.logarithmic(1e-3, 0.5);
    const double x = draw.uniform(a, width - a), y = draw.uniform(b, height - b);
    patch.text =
        "(1 + 10*(((x - " + number(x) + ")/" + number(a) + ")^2 + ((y - " + number(y) + ")/" + number(b) + ")^2 < 1))";
    patch.integral = width * height + 10.0 * M_PI * a * b;
  } else {
    const double low = draw.uniform(0.0, 0.5) * height, rise = draw.uniform(0.0, 0.5) * height;
    patch.text = "(1 + 10*(y < " + number(low) + " + " + number(rise) + "*(x/" + number(width) + ")^2))";
    patch.integral = width * height + 10.0 * width * (low + rise / 3.0);
  }
  patch.size = patch.integral;
  return patch;
}

/// A box of a body, with its supports and the needle among its loads.
class NeedleScene
{
public:
  explicit NeedleScene(Draw& draw)
      : draw_(draw), dim_(draw.chance(0.1) ? 3 : 2), touches_(dim_ == 2 && draw.chance(0.6))
  {}

  DrawnScene take();

private:
  void drawBox(const std::string& body, std::vector<double> lower, std::vector<double> upper);
  void drawLoad();
  void drawContact();

  Draw& draw_;
  const int dim_;
  const bool touches_;
  DrawnScene scene_{"needle"};
  std::vector<double> size_;
};

void NeedleScene::drawBox(const std::string& body, std::vector<double> lower, std::vector<double> upper)
{
  const std::string list = "Bodies/" + body + "/";
  std::vector<int> cells;
  for (int k = 0; k < dim_; ++k)
    cells.push_back(dim_ == 3 ? draw_.integer(1, 2) : draw_.integer(2, 5));
  if (touches_)
    cells[0] = 4;
  scene_.deck.set(list + "Mesh/Type", "Box");
  scene_.deck.set(list + "Mesh/Lower", lower);
  scene_.deck.set(list + "Mesh/Upper", upper);
  scene_.deck.set(list + "Mesh/Cells", cells);
  if (dim_ == 3)
    scene_.deck.set(list + "Material/Hypothesis", "Three Dimensional");
  scene_.deck.set(list + "Material/Young Modulus", draw_.logarithmic(0.3, 3.0));
  scene_.deck.set(list + "Material/Poisson Ratio", draw_.uniform(0.0, 0.45));
}

/// Downwards on the first body: on its top, or in all of it; the expected resultant in the scene.
void NeedleScene::drawLoad()
{
  const std::string list = "Bodies/upper/Loads/needle/";
  const int way = draw_.integer(0, 2);
  const bool isPatch = dim_ == (way == 2 ? 2 : 3) && draw_.chance(0.4);
  Needle f = isPatch ? drawPatch(size_[0], size_[1], draw_) : drawNeedle("x", size_[0], draw_);
  double measure = dim_ == 3 ? size_[way == 2 ? 1 : 2] : 1.0; // of what f does not depend on
  if (way == 0) {
    scene_.deck.set(list + "Type", "Pressure");
    scene_.deck.set(list + "Side", "top");
    scene_.deck.set(list + "Value", "0.001*" + f.text);
    if (dim_ == 3) // the top of a box in space: z is up
      measure = size_[1];
  } else if (way == 1) {
    scene_.deck.set(list + "Type", "Traction");
    scene_.deck.set(list + "Side", "top");
    scene_.deck.set(list + (dim_ == 3 ? "Z" : "Y"), "-0.001*" + f.text);
    if (dim_ == 3)
      measure = size_[1];
  } else {
    scene_.deck.set(list + "Type", "Body Force");
    std::string text = f.text;
    if (!isPatch && draw_.chance(0.5)) { // a product
      const Needle g = drawNeedle("y", size_[1], draw_);
      text += "*" + g.text;
      f.integral *= g.integral;
      f.size *= g.size;
      measure = dim_ == 3 ? size_[2] : 1.0;
    } else
      measure = dim_ == 3 ? size_[1] * size_[2] : size_[1];
    scene_.deck.set(list + (dim_ == 3 ? "Z" : "Y"), "-0.001*" + text);
  }
  scene_.kind += way == 0 ? " pressure" : way == 1 ? " traction" : " force";
  if (isPatch) {
    measure = 1.0;
    scene_.kind += " patch";
  }
  scene_.load = ExpectedLoad{-0.001 * measure * f.integral, 0.001 * measure * f.size};
}

void NeedleScene::drawContact()
{
  drawBox("lower", {0.0, -1.0}, {1.0, 0.0});
  scene_.deck.set("Bodies/lower/Supports/ground/Type", "Clamp");
  scene_.deck.set("Bodies/lower/Supports/ground/Side", "bottom");
  scene_.deck.set("Interfaces/contact/Dirichlet Body", "upper");
  scene_.deck.set("Interfaces/contact/Dirichlet Side", "bottom");
  scene_.deck.set("Interfaces/contact/Neumann Body", "lower");
  scene_.deck.set("Interfaces/contact/Neumann Side", "top");
  scene_.deck.set("Coupling/Type", "Monolithic");
  if (draw_.chance(0.4)) {
    scene_.deck.set("Interfaces/contact/Gap", "0.0003*" + drawNeedle("x", 1.0, draw_).text);
    scene_.kind += " gap";
  }
}

DrawnScene NeedleScene::take()
{
  size_ = {1.0, draw_.uniform(0.5, 1.0), 0.7};
  size_.resize(std::size_t(dim_));
  scene_.kind = fmt::format("{}-D", dim_);
  drawBox("upper", std::vector<double>(std::size_t(dim_), 0.0), size_);
  drawLoad();
  const std::string list = "Bodies/upper/Supports/";
  scene_.deck.set(list + "side/Type", "Roller");
  scene_.deck.set(list + "side/Side", "left");
  if (touches_) {
    drawContact();
  } else {
    const Needle f = drawNeedle("x", 1.0, draw_);
    const bool moves = dim_ == 2 && draw_.chance(0.4) && f.isSmooth;
    scene_.deck.set(list + "ground/Type", moves ? "Displacement" : "Clamp");
    scene_.deck.set(list + "ground/Side", "bottom");
    if (moves)
      scene_.deck.set(list + "ground/Y", "0.0003*" + f.text);
    scene_.kind += moves ? " moved" : " clamped";
  }
  if (dim_ == 3) {
    scene_.deck.set(list + "front/Type", "Roller");
    scene_.deck.set(list + "front/Side", "front");
  }
  scene_.deck.set("Discretization/Order", draw_.chance(0.3) ? 1 : 2);
  scene_.deck.set("Error Estimation/Estimators", std::vector<std::string>{"Global", "Reference"});
  scene_.deck.set("Error Estimation/Check Equilibrium", true);
  scene_.deck.set("Error Estimation/Reference/Refinements", 3);
  scene_.deck.set("Error Estimation/Reference/Maximum Dofs", 400000);
  if (dim_ == 2 && draw_.chance(0.25)) {
    scene_.deck.set("Accuracy/Target", 0.15);
    scene_.deck.set("Accuracy/Maximum Dofs", 3000);
    scene_.kind += " target";
  }
  return std::move(scene_);
}

} // namespace

DrawnScene drawNeedleScene(std::uint64_t seed, int index)
{
  Draw draw(seed * 1000003u + std::uint64_t(index));
  return NeedleScene(draw).take();
}

} // namespace ndframe::test
