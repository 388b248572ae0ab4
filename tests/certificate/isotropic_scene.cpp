#include "certificate/isotropic_scene.hpp"

#include <algorithm>

namespace ndframe::test
{
namespace
{

/// Where a scene's bodies are and what presses them; stresses are of size 0.01, lengths of size 1.
class IsotropicScene
{
public:
  IsotropicScene(double aspect, int finest, Draw& draw) : draw_(draw)
  {
    const int cells = int(draw.logarithmic(6.0, finest + 1.0));
    width_ = 1.0 / cells;
    height_ = draw.chance(0.5) ? width_ / aspect : width_ * aspect;
    drawStyle();
    scene_.deck.set("Discretization/Order", 2);
  }

  void punch();
  void contactLoss();
  void linear();
  void random();
  DrawnScene take() { return std::move(scene_); }

private:
  void drawStyle();
  std::vector<double> rows(double tall) const { return lines(tall, height_); }
  static std::vector<double> lines(double length, double size);
  std::vector<double> columns(double wide) const { return lines(wide, width_); }
  void mesh(const std::string& body, const Rectangle& rectangle);
  void material(const std::string& body, double stiffness, const std::string& hypothesis);
  void drawBodies(double upperHeight, double lowerHeight, double lowerWidth);
  void supportHalf();
  void support(const std::string& path, const std::string& type, const std::string& side);
  void press(const std::string& body, const std::string& side);
  void pull(const std::string& list, const std::string& type, const std::string& side, double size);
  void drawGap();

  Draw& draw_;
  DrawnScene scene_{"sharpness"};
  MeshStyle style_;
  double width_, height_; ///< of a cell
};

void IsotropicScene::drawStyle()
{
  const std::string pattern = draw_.pick<std::string>({"Right", "Alternating", "Crossed"});
  const std::vector<MeshStyle> styles{{false, pattern, 1.0, pattern},
                                      {false, pattern, draw_.logarithmic(0.6, 1.6), "graded"},
                                      {true, {}, 1.0, "perturbed"}};
  style_ = draw_.pick(styles);
  scene_.kind = style_.word;
}

/// Whole cells of this size, at least two: sides of two bodies match.
std::vector<double> IsotropicScene::lines(double length, double size)
{
  const int cells = std::max(2, int(std::lround(length / size)));
  return gridLines(0.0, cells * size, cells);
}

void IsotropicScene::mesh(const std::string& body, const Rectangle& rectangle)
{
  drawMesh(
      scene_, body, rectangle, style_, [](double) { return 0.0; }, Frame{}, draw_);
}

void IsotropicScene::material(const std::string& body, double stiffness, const std::string& hypothesis)
{
  const std::string list = "Bodies/" + body + "/Material/";
  scene_.deck.set(list + "Hypothesis", hypothesis);
  scene_.deck.set(list + "Young Modulus", stiffness);
  scene_.deck.set(list + "Poisson Ratio", draw_.uniform(0.0, 0.45));
}

/// The upper body is one unit wide; sides loaded and unloaded of its top; side contact of the lower one.
void IsotropicScene::drawBodies(double upperHeight, double lowerHeight, double lowerWidth)
{
  Rectangle upper, lower;
  upper.x = columns(1.0);
  upper.y = rows(upperHeight);
  upper.split = lower.split = "top";
  upper.at = upper.x[upper.x.size() / 2];
  std::tie(upper.first, upper.second) = std::pair("loaded", "unloaded");
  lower.x = columns(lowerWidth);
  lower.y = rows(lowerHeight);
  for (double& y : lower.y)
    y -= lower.y.back();
  lower.at = 1.0;
  std::tie(lower.first, lower.second) = std::pair("contact", "free");
  mesh("upper", upper);
  mesh("lower", lower);
  const std::string hypothesis = draw_.chance(0.5) ? "Plane Strain" : "Plane Stress";
  material("upper", 1.0, hypothesis);
  material("lower", draw_.chance(0.3) ? 1.0 : draw_.logarithmic(0.01, 100.0), hypothesis);
  scene_.deck.set("Coupling/Type", "Monolithic");
  const std::string list = "Interfaces/contact/";
  scene_.deck.set(list + "Dirichlet Body", "upper");
  scene_.deck.set(list + "Dirichlet Side", "bottom");
  scene_.deck.set(list + "Neumann Body", "lower");
  scene_.deck.set(list + "Neumann Side", "contact");
}

void IsotropicScene::support(const std::string& path, const std::string& type, const std::string& side)
{
  scene_.deck.set("Bodies/" + path + "/Type", type);
  scene_.deck.set("Bodies/" + path + "/Side", side);
}

void IsotropicScene::press(const std::string& body, const std::string& side)
{
  const std::string list = "Bodies/" + body + "/Loads/press/";
  scene_.deck.set(list + "Type", "Pressure");
  scene_.deck.set(list + "Side", side);
  scene_.deck.set(list + "Value", "0.01 * (" + Frame{}.expression(drawPressure(draw_)) + ")");
}

/// A load or a support with components; `side` is empty for body forces.
void IsotropicScene::pull(const std::string& list, const std::string& type, const std::string& side, double size)
{
  scene_.deck.set("Bodies/" + list + "/Type", type);
  if (!side.empty())
    scene_.deck.set("Bodies/" + list + "/Side", side);
  for (const char* component : {"X", "Y"})
    scene_.deck.set("Bodies/" + list + "/" + component,
                    fmt::format("{} * ({})", size, Frame{}.expression(drawField(draw_))));
}

/// The half right of a line of symmetry on a clamped ground.
void IsotropicScene::supportHalf()
{
  support("upper/Supports/symmetry", "Roller", "left");
  support("lower/Supports/ground", "Clamp", "bottom");
  support("lower/Supports/symmetry", "Roller", "left");
}

void IsotropicScene::punch()
{
  drawBodies(draw_.uniform(0.5, 1.0), draw_.uniform(0.5, 1.0), 2.0);
  supportHalf();
  press("upper", "top");
}

void IsotropicScene::contactLoss()
{
  drawBodies(draw_.uniform(0.5, 1.0), draw_.uniform(0.5, 1.5), 2.0);
  supportHalf();
  press("upper", "loaded");
}

void IsotropicScene::linear()
{
  Rectangle body;
  body.x = columns(draw_.uniform(0.6, 1.5));
  body.y = rows(draw_.uniform(0.6, 1.5));
  mesh("body", body);
  material("body", 1.0, draw_.chance(0.5) ? "Plane Strain" : "Plane Stress");
  const bool clamped = draw_.chance(0.5);
  if (clamped) {
    support("body/Supports/wall", "Clamp", "left");
  } else {
    support("body/Supports/ground", "Roller", "bottom");
    support("body/Supports/symmetry", "Roller", "left");
  }
  press("body", "top");
  if (!clamped || draw_.chance(0.5)) // a column under constant pressure has no error at all
    pull("body/Loads/pull", "Traction", "right", 0.01);
  if (draw_.chance(0.3))
    pull("body/Loads/weight", "Body Force", "", 0.01);
}

void IsotropicScene::drawGap()
{
  const std::string shape = draw_.pick<std::string>({"1", "X", "1 - X", "X*X", "(X - 0.5)*(X - 0.5)"});
  if (draw_.chance(0.5))
    scene_.deck.set("Interfaces/contact/Gap",
                    fmt::format("{} * ({})", draw_.logarithmic(1e-4, 5e-3), Frame{}.expression(shape)));
}

void IsotropicScene::random()
{
  drawBodies(draw_.uniform(0.3, 1.0), draw_.uniform(0.3, 1.0), draw_.chance(0.5) ? 1.5 : 2.0);
  support("lower/Supports/ground", "Clamp", "bottom");
  const int way = draw_.integer(0, 2);
  if (way == 0) { // pressed down by its top
    scene_.deck.set("Bodies/upper/Supports/press/X", 0.0);
    scene_.deck.set("Bodies/upper/Supports/press/Y", -0.01 * draw_.uniform(0.5, 2.0));
    support("upper/Supports/press", "Displacement", "top");
  } else { // a cantilever, or a block with a guide
    support("upper/Supports/guide", way == 1 ? "Clamp" : "Roller", "left");
    press("upper", draw_.chance(0.5) ? "top" : "loaded");
  }
  drawGap();
  if (draw_.chance(0.4))
    pull("upper/Loads/shear", "Traction", "right", 0.003);
  if (draw_.chance(0.3))
    pull("lower/Loads/weight", "Body Force", "", 0.003);
}

} // namespace

DrawnScene drawIsotropicScene(const std::string& kind, double aspect, int finest, Draw& draw)
{
  const std::map<std::string, void (IsotropicScene::*)()> kinds{{"punch", &IsotropicScene::punch},
                                                                {"contact-loss", &IsotropicScene::contactLoss},
                                                                {"linear", &IsotropicScene::linear},
                                                                {"random", &IsotropicScene::random}};
  IsotropicScene drawn(aspect, finest, draw);
  (drawn.*kinds.at(kind))();
  DrawnScene scene = drawn.take();
  scene.kind = kind + " " + scene.kind;
  return scene;
}

} // namespace ndframe::test
