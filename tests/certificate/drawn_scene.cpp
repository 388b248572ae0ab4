#include "certificate/drawn_scene.hpp"

#include "reading/mesh_files.hpp"

namespace ndframe::test
{

MeshStyle drawMeshStyle(Draw& draw)
{
  const std::string pattern = draw.pick<std::string>({"Right", "Alternating", "Crossed"});
  if (draw.chance(0.4))
    return {true, {}, 1.0, "random"};
  if (draw.chance(0.35))
    return {false, pattern, draw.logarithmic(0.1, 10.0), "graded"};
  return {false, pattern, 1.0, pattern};
}

void drawMesh(DrawnScene& scene, const std::string& body, const Rectangle& rectangle, const MeshStyle& style,
              const std::function<double(double)>& lift, const Frame& frame, Draw& draw)
{
  const std::string list = "Bodies/" + body + "/Mesh/";
  if (style.random) {
    const std::string file = body + ".msh";
    scene.files[file] = asMsh22(randomMesh(rectangle, draw.uniform(0.05, 0.2), lift, frame, draw));
    scene.deck.set(list + "Type", "Gmsh");
    scene.deck.set(list + "File", file);
    return;
  }
  const auto &x = rectangle.x, &y = rectangle.y;
  const double L = frame.length;
  scene.deck.set(list + "Type", "Box");
  scene.deck.set(list + "Lower", std::vector<double>{L * x.front(), L * y.front()});
  scene.deck.set(list + "Upper", std::vector<double>{L * x.back(), L * y.back()});
  scene.deck.set(list + "Cells", std::vector<int>{int(x.size()) - 1, int(y.size()) - 1});
  scene.deck.set(list + "Pattern", style.pattern);
  scene.deck.set(list + "Grading", std::vector<double>{1.0, style.grading});
  scene.deck.set(list + "Rotation", frame.degrees);
  if (rectangle.split.empty())
    return;
  scene.deck.set(list + "Splits/parts/Side", rectangle.split);
  scene.deck.set(list + "Splits/parts/At", std::vector<double>{L * rectangle.at});
  scene.deck.set(list + "Splits/parts/Names", std::vector<std::string>{rectangle.first, rectangle.second});
}

void drawMaterial(DrawnScene& scene, const std::string& body, double stiffness, const std::string& hypothesis,
                  Draw& draw)
{
  const std::string list = "Bodies/" + body + "/Material/";
  scene.deck.set(list + "Hypothesis", hypothesis);
  if (draw.chance(0.2)) {
    // Sorted moduli and ratios below 0.3: the compliance is diagonally dominant.
    scene.deck.set(list + "Type", "Orthotropic");
    const double third = stiffness * draw.uniform(0.3, 1.0), second = third * draw.uniform(1.0, 2.0);
    scene.deck.set(list + "Young Modulus 1", second * draw.uniform(1.0, 8.0));
    scene.deck.set(list + "Young Modulus 2", second);
    scene.deck.set(list + "Young Modulus 3", third);
    for (const char* plane : {"12", "23", "13"}) {
      scene.deck.set(list + "Poisson Ratio " + plane, draw.uniform(0.0, 0.3));
      scene.deck.set(list + "Shear Modulus " + plane, stiffness * draw.uniform(0.2, 0.6));
    }
    scene.deck.set(list + "Angle", draw.uniform(0.0, 180.0));
    return;
  }
  scene.deck.set(list + "Young Modulus", stiffness);
  scene.deck.set(list + "Poisson Ratio",
                 draw.chance(0.6) ? draw.uniform(0.0, 0.45) : draw.pick<double>({0.0, 0.3, 0.49, 0.499, 0.4999}));
}

std::string drawField(Draw& draw)
{
  const double a = draw.uniform(-1.0, 1.0), b = draw.uniform(-1.0, 1.0), k = draw.uniform(1.0, 8.0);
  return draw.pick<std::string>({fmt::format("{}", a), fmt::format("0.5*({} + {}*X + {}*Y)", a, b, 1.0 - std::abs(b)),
                                 fmt::format("0.5*({}*X*X + {}*X*Y)", a, b),
                                 fmt::format("{}*sin({}*X + {}*Y)", a, k, 3.0 * b)});
}

std::string drawPressure(Draw& draw)
{
  const double a = draw.uniform(0.2, 1.0), k = draw.uniform(1.0, 8.0);
  return draw.pick<std::string>({"1", fmt::format("0.2 + {}*X", a), fmt::format("1 - {}*X", 0.8 * a),
                                 fmt::format("1 - 4*{}*X*(1 - X)", 0.8 * a), fmt::format("0.55 + 0.45*sin({}*X)", k)});
}

void drawCertificate(DrawnScene& scene, int dim, bool touches, Draw& draw)
{
  const int order = draw.chance(0.3) ? 1 : 2;
  const int highest = dim == 2 ? order + 1 : 2;
  const int degree = draw.chance(0.5) ? 0 : draw.integer(order, highest);
  const bool byElements = dim == 2 && draw.chance(0.15);
  const bool projects = touches && (byElements || draw.chance(0.3));
  scene.deck.set("Discretization/Order", order);
  const std::string list = "Error Estimation/";
  std::vector<std::string> estimators{"Global", "Reference", "Zienkiewicz-Zhu", "Residual"};
  if (touches)
    estimators.insert(estimators.end(), {"Algorithm", "Discretization", "Split"});
  scene.deck.set(list + "Estimators", estimators);
  scene.deck.set(list + "Check Equilibrium", true);
  scene.deck.set(list + "Recovery/Type", byElements ? "Element" : "Star");
  scene.deck.set(list + "Recovery/Degree", degree);
  if (!byElements)
    scene.deck.set(list + "Recovery/Sweeps", draw.integer(0, 2));
  scene.deck.set(list + "Interface Traction/Type", projects ? "Projected" : "Optimal");
  scene.deck.set(list + "Interface Traction/Mean", draw.chance(0.2) ? "Updated" : "Previous");
  scene.deck.set(list + "Reference/Refinements", 3);
  scene.deck.set(list + "Reference/Maximum Dofs", 400000);
}

DrawnScene drawScene(std::uint64_t seed, int index)
{
  Draw draw(seed * 1000003u + std::uint64_t(index));
  if (draw.chance(0.75))
    return drawContactScene(draw);
  return drawLinearScene(draw.chance(0.7) ? 2 : 3, draw);
}

} // namespace ndframe::test
