#include "certificate/drawn_scene.hpp"

namespace ndframe::test
{
namespace
{

const std::vector<std::string> planeSides{"left", "right", "bottom", "top"};
const std::vector<std::string> solidSides{"left", "right", "front", "back", "bottom", "top"};

/// A field of space: Z takes the part of Y now and then.
std::string fieldIn(int dim, const Frame& frame, Draw& draw)
{
  std::string text = drawField(draw);
  if (dim == 2)
    return frame.expression(text);
  for (char& c : text)
    c = c == 'X' ? 'x' : c == 'Y' ? (draw.chance(0.5) ? 'z' : 'y') : c;
  return text;
}

/// Solids get no sines: sampling them in tetrahedra to round-off takes minutes.
void setVector(DrawnScene& scene, const std::string& list, int dim, double scale, const Frame& frame, Draw& draw)
{
  for (const char* component : {"X", "Y", "Z"}) {
    if (dim == 2 && component[0] == 'Z')
      continue;
    std::string field = fieldIn(dim, frame, draw);
    while (dim == 3 && field.find("sin") != std::string::npos)
      field = fieldIn(dim, frame, draw);
    scene.deck.set(list + "/" + component, fmt::format("{} * ({})", scale, field));
  }
}

void drawSolidBox(DrawnScene& scene, const Frame& frame, Draw& draw)
{
  const std::string list = "Bodies/body/Mesh/";
  scene.deck.set(list + "Type", "Box");
  scene.deck.set(list + "Lower", std::vector<double>{0.0, 0.0, 0.0});
  scene.deck.set(list + "Upper", std::vector<double>{1.0, draw.logarithmic(0.3, 1.0), draw.logarithmic(0.3, 1.0)});
  scene.deck.set(list + "Cells", std::vector<int>{draw.integer(1, 2), draw.integer(1, 2), 1});
  scene.deck.set(list + "Pattern", draw.pick<std::string>({"Right", "Alternating"}));
  scene.deck.set(list + "Grading", std::vector<double>{draw.logarithmic(0.3, 3.0), 1.0, 1.0});
  scene.deck.set(list + "Rotation", frame.degrees);
  scene.kind += " 3-D";
}

void drawPlaneMesh(DrawnScene& scene, const Frame& frame, Draw& draw)
{
  const MeshStyle style = drawMeshStyle(draw);
  Rectangle rectangle;
  rectangle.x = gridLines(0.0, 1.0, draw.integer(2, 5));
  if (style.random)
    rectangle.x = shaken(rectangle.x, draw);
  rectangle.y = gridLines(0.0, draw.logarithmic(0.15, 1.5), draw.integer(2, 5));
  drawMesh(
      scene, "body", rectangle, style, [](double) { return 0.0; }, frame, draw);
  scene.kind += " " + style.word;
}

/// The body is held at its left or bottom; more supports may follow. Returns a side that is free.
std::string drawSupports(DrawnScene& scene, int dim, const Frame& frame, Draw& draw)
{
  const std::string list = "Bodies/body/Supports/";
  const auto& sides = dim == 2 ? planeSides : solidSides;
  const int way = draw.integer(0, 2);
  const std::string first = way == 2 ? "bottom" : "left";
  scene.deck.set(list + "first/Side", first);
  scene.deck.set(list + "first/Type", way == 0 ? "Clamp" : way == 1 ? "Displacement" : "Roller");
  if (way == 1)
    setVector(scene, list + "first", dim, 0.01 * frame.length, frame, draw);
  if (way == 2) {
    scene.deck.set(list + "second/Side", "left");
    scene.deck.set(list + "second/Type", "Roller");
  }
  if (way == 2 && dim == 3) {
    scene.deck.set(list + "third/Side", "front");
    scene.deck.set(list + "third/Type", "Roller");
  }
  if (way == 0 && draw.chance(0.3)) {
    scene.deck.set(list + "second/Side", "top");
    scene.deck.set(list + "second/Type", "Roller");
    return "right";
  }
  return draw.chance(0.5) ? "right" : sides.back();
}

void drawLoads(DrawnScene& scene, int dim, const std::string& side, double stress, const Frame& frame, Draw& draw)
{
  const std::string list = "Bodies/body/Loads/";
  if (draw.chance(0.6)) {
    scene.deck.set(list + "press/Type", "Pressure");
    scene.deck.set(list + "press/Side", side);
    scene.deck.set(list + "press/Value", fmt::format("{} * ({})", stress, fieldIn(dim, frame, draw)));
  }
  if (draw.chance(0.5)) {
    scene.deck.set(list + "weight/Type", "Body Force");
    setVector(scene, list + "weight", dim, stress / frame.length, frame, draw);
  }
  scene.deck.set(list + "pull/Type", "Traction");
  scene.deck.set(list + "pull/Side", "right");
  setVector(scene, list + "pull", dim, stress, frame, draw);
}

} // namespace

DrawnScene drawLinearScene(int dim, Draw& draw)
{
  DrawnScene scene("sweep");
  scene.kind = "linear";
  const Frame frame{dim == 2 ? draw.pick<double>({1.0, 1e-3, 2e3}) : 1.0,
                    draw.chance(0.4) ? draw.uniform(0.0, 360.0) : 0.0};
  const double stiffness = draw.pick<double>({1.0, 2e5});
  dim == 2 ? drawPlaneMesh(scene, frame, draw) : drawSolidBox(scene, frame, draw);
  const std::string plane = draw.chance(0.5) ? "Plane Strain" : "Plane Stress";
  drawMaterial(scene, "body", stiffness, dim == 3 ? "Three Dimensional" : plane, draw);
  const std::string side = drawSupports(scene, dim, frame, draw);
  drawLoads(scene, dim, side, 0.01 * stiffness, frame, draw);
  drawCertificate(scene, dim, false, draw);
  return scene;
}

} // namespace ndframe::test
