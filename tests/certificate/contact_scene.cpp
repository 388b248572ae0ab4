#include <algorithm>

#include "certificate/drawn_scene.hpp"

namespace ndframe::test
{
namespace
{

/// An upper body on a lower one that is as wide or wider; X from 0 to 1 is where they touch.
class ContactScene
{
public:
  explicit ContactScene(Draw& draw, bool turning = false)
      : draw_(draw), frame_{draw.pick<double>({1.0, 1.0, 1e-3, 2e3}),
                            draw.chance(0.4) ? draw.uniform(0.0, 360.0) : 0.0},
        turning_(turning)
  {}

  DrawnScene take();

private:
  void drawBodies();
  void drawMeshes();
  std::function<double(double)> drawShape(const std::vector<double>& x);
  void supportUpper();
  void supportLower();
  void loadUpper();
  void loadMore(const std::string& body, const std::string& side);
  void drawGap();
  void drawCoupling();
  void support(const std::string& path, const std::string& type, const std::string& side);
  void setVector(const std::string& list, double scale);

  Draw& draw_;
  const Frame frame_;
  const bool turning_; ///< the sides are curved or kinked, and the coupling converges
  DrawnScene scene_{"sweep"};
  double stress_ = 1.0, displacement_ = 1.0; ///< sizes to expect
  std::string contactSide_;
  bool kinked_ = false, held_ = false, lifts_ = false;
};

void ContactScene::drawBodies()
{
  const double soft = draw_.pick<double>({1.0, 1.0, 2e5}), ratio = draw_.logarithmic(1.0, 1e3);
  const bool softUpper = draw_.chance(0.5);
  const std::string hypothesis = draw_.chance(0.5) ? "Plane Strain" : "Plane Stress";
  drawMaterial(scene_, "upper", softUpper ? soft : soft * ratio, hypothesis, draw_);
  drawMaterial(scene_, "lower", softUpper ? soft * ratio : soft, hypothesis, draw_);
  stress_ = 0.01 * soft;
  displacement_ = 0.01 * frame_.length;
}

/// A curve or a kink at a vertex, and its word.
std::function<double(double)> ContactScene::drawShape(const std::vector<double>& x)
{
  const double size = draw_.logarithmic(0.02, 0.2) * (draw_.chance(0.5) ? 1.0 : -1.0);
  const std::string shape = draw_.pick<std::string>({"arc", "wave", "hump", "kinked", "kinked"});
  scene_.kind = shape;
  if (shape == "arc")
    return [=](double X) { return 4.0 * size * X * (1.0 - X); };
  if (shape == "wave")
    return [=](double X) { return size * std::cos(std::acos(-1.0) * X); };
  if (shape == "hump") // between straight parts
    return [=](double X) { return size * std::pow(std::max(0.0, 4.0 * (X - 0.25) * (0.75 - X)), 2); };
  const double at = x[std::size_t(draw_.integer(1, int(x.size()) - 2))];
  const double slope = size * (draw_.chance(0.5) ? 10.0 : 4.0); // a corner, or what a curve may be
  return [=](double X) { return slope * std::max(0.0, X - at); };
}

void ContactScene::drawMeshes()
{
  MeshStyle style = drawMeshStyle(draw_);
  kinked_ = draw_.chance(0.15);
  if (kinked_)
    style = {true, {}, 1.0, "kinked"};
  if (turning_)
    style = {true, {}, 1.0, ""};
  const int cells = turning_ ? draw_.integer(3, 9) : draw_.integer(2, 5),
            more = draw_.chance(0.5) ? draw_.integer(1, 3) : 0;
  Rectangle upper, lower;
  upper.x = gridLines(0.0, 1.0, cells);
  if (style.random)
    upper.x = shaken(upper.x, draw_);
  upper.y = gridLines(0.0, draw_.logarithmic(0.15, 1.5), draw_.integer(2, 4));
  lower.x = upper.x;
  for (int i = 1; i <= more; ++i)
    lower.x.push_back(1.0 + double(i) / cells);
  lower.y = gridLines(-draw_.logarithmic(0.15, 1.5), 0.0, draw_.integer(2, 4));
  upper.split = "top";
  upper.at = upper.x[std::size_t(draw_.integer(1, cells - 1))];
  upper.first = "loaded";
  upper.second = "unloaded";
  contactSide_ = more > 0 ? "contact" : "top";
  if (more > 0)
    std::tie(lower.split, lower.at, lower.first, lower.second) = std::tuple("top", 1.0, "contact", "free");
  const double slope = kinked_ ? draw_.uniform(-0.3, 0.3) : 0.0, start = upper.x[1];
  std::function<double(double)> lift = [=](double x) { return slope * std::max(0.0, x - start); };
  if (turning_)
    lift = drawShape(upper.x);
  drawMesh(scene_, "upper", upper, style, lift, frame_, draw_);
  drawMesh(scene_, "lower", lower, style, lift, frame_, draw_);
  scene_.kind += style.word;
}

void ContactScene::support(const std::string& path, const std::string& type, const std::string& side)
{
  scene_.deck.set("Bodies/" + path + "/Type", type);
  scene_.deck.set("Bodies/" + path + "/Side", side);
}

/// X and Y of a list: a random vector field of this size.
void ContactScene::setVector(const std::string& list, double scale)
{
  for (const char* component : {"X", "Y"})
    scene_.deck.set(list + "/" + component, fmt::format("{} * ({})", scale, frame_.expression(drawField(draw_))));
}

void ContactScene::supportUpper()
{
  const int way = draw_.integer(0, 3);
  if (way <= 1) { // held along Y by contact alone
    support("upper/Supports/symmetry", "Roller", "left");
    if (draw_.chance(0.3))
      support("upper/Supports/guide", "Roller", "right");
    scene_.kind += " floating";
  } else if (way == 2) {
    held_ = true;
    support("upper/Supports/wall", "Clamp", "left");
    lifts_ = draw_.chance(0.5);
    scene_.kind += " cantilever";
  } else { // pressed down by its top
    held_ = true;
    support("upper/Supports/press", "Displacement", "top");
    const auto down = frame_.turned(0.0, -displacement_ * draw_.uniform(0.2, 2.0));
    const std::string field = frame_.expression(drawPressure(draw_));
    scene_.deck.set("Bodies/upper/Supports/press/X", fmt::format("{} * ({})", down[0], field));
    scene_.deck.set("Bodies/upper/Supports/press/Y", fmt::format("{} * ({})", down[1], field));
    scene_.kind += " pressed";
  }
}

void ContactScene::supportLower()
{
  const int way = draw_.integer(0, 3);
  if (way == 0 && !kinked_ && !turning_) {
    support("lower/Supports/ground", "Roller", "bottom");
    support("lower/Supports/symmetry", "Roller", "left");
  } else if (way == 1) {
    support("lower/Supports/ground", "Displacement", "bottom");
    setVector("Bodies/lower/Supports/ground", 0.3 * displacement_);
  } else {
    support("lower/Supports/ground", "Clamp", "bottom");
    if (draw_.chance(0.3))
      support("lower/Supports/symmetry", "Roller", "left");
  }
}

void ContactScene::loadMore(const std::string& body, const std::string& side)
{
  const std::string list = "Bodies/" + body + "/Loads/";
  if (draw_.chance(0.3)) {
    scene_.deck.set(list + "shear/Type", "Traction");
    scene_.deck.set(list + "shear/Side", side);
    setVector(list + "shear", 0.3 * stress_);
  }
  if (draw_.chance(0.3)) {
    scene_.deck.set(list + "weight/Type", "Body Force");
    setVector(list + "weight", 0.3 * stress_ / frame_.length);
  }
}

void ContactScene::loadUpper()
{
  if (scene_.kind.find("pressed") == std::string::npos) {
    const std::string list = "Bodies/upper/Loads/press/";
    scene_.deck.set(list + "Type", "Pressure");
    scene_.deck.set(list + "Side", draw_.chance(0.5) ? "top" : draw_.chance(0.7) ? "loaded" : "unloaded");
    scene_.deck.set(list + "Value", fmt::format("{} * ({})", stress_, frame_.expression(drawPressure(draw_))));
  }
  if (lifts_) {
    const auto up = frame_.turned(0.0, stress_ * draw_.uniform(0.2, 2.0));
    scene_.deck.set("Bodies/upper/Loads/lift/Type", "Traction");
    scene_.deck.set("Bodies/upper/Loads/lift/Side", "right");
    scene_.deck.set("Bodies/upper/Loads/lift/X", up[0]);
    scene_.deck.set("Bodies/upper/Loads/lift/Y", up[1]);
    scene_.kind += " lift-off";
  }
  loadMore("upper", "right");
  loadMore("lower", "right");
}

void ContactScene::drawGap()
{
  scene_.deck.set("Interfaces/contact/Dirichlet Body", "upper");
  scene_.deck.set("Interfaces/contact/Dirichlet Side", "bottom");
  scene_.deck.set("Interfaces/contact/Neumann Body", "lower");
  scene_.deck.set("Interfaces/contact/Neumann Side", contactSide_);
  if (draw_.chance(0.5))
    return;
  const std::string shape =
      draw_.pick<std::string>({"1", "X", "1 - X", "X*X", "(X - 0.5)*(X - 0.5)", "0.5 + 0.5*sin(9*X)", "abs(sin(7*X))",
                               "exp(-3*X)", "abs(X - 0.37)"});
  const double size = displacement_ * draw_.logarithmic(0.01, 1.0);
  scene_.deck.set("Interfaces/contact/Gap", fmt::format("{} * ({})", size, frame_.expression(shape)));
  scene_.kind += " gap";
}

void ContactScene::drawCoupling()
{
  if (turning_ || draw_.chance(0.2)) {
    scene_.deck.set("Coupling/Type", "Monolithic");
    scene_.kind += " monolithic";
    return;
  }
  const bool aitken = draw_.chance(0.3), stops = draw_.chance(0.7);
  scene_.deck.set("Coupling/Initial Traction", !held_ && draw_.chance(0.3) ? "Balanced" : "Zero");
  scene_.deck.set("Coupling/Dirichlet Body", "As Given");
  scene_.deck.set("Coupling/Relaxation/Type", aitken ? "Aitken" : "Constant");
  scene_.deck.set(std::string("Coupling/Relaxation/") + (aitken ? "Initial Theta" : "Theta"), draw_.uniform(0.2, 0.9));
  scene_.deck.set("Coupling/Stopping/Tolerance", 1e-9);
  scene_.deck.set("Coupling/Stopping/Maximum Sweeps", stops ? draw_.integer(1, 12) : 100);
  scene_.kind += stops ? " stopped" : " iterated";
}

DrawnScene ContactScene::take()
{
  drawBodies();
  drawMeshes();
  supportUpper();
  supportLower();
  loadUpper();
  drawGap();
  drawCoupling();
  drawCertificate(scene_, 2, true, draw_);
  return std::move(scene_);
}

} // namespace

DrawnScene drawContactScene(Draw& draw)
{
  return ContactScene(draw).take();
}

DrawnScene drawTurningScene(std::uint64_t seed, int index)
{
  Draw draw(seed * 1000003u + std::uint64_t(index));
  return ContactScene(draw, true).take();
}

} // namespace ndframe::test
