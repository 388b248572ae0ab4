// Guesses what holds and moves two bodies that are drawn apart, and writes it as the lists of a deck.
#include "ndframe/base/deck.hpp"
#include "ndframe/drawing/drawn_checks.hpp"
#include "ndframe/drawing/guessed_scene.hpp"

/// A square of two triangles, with its sides below and above.
ndframe::DrawnBody square(const std::string& name, double x, double y, double size, ndframe::DrawnSide below,
                          ndframe::DrawnSide above)
{
  ndframe::Mesh mesh;
  mesh.dim = 2;
  mesh.points = {x, y, x + size, y, x + size, y + size, x, y + size};
  mesh.cells = {0, 1, 2, 0, 2, 3};
  mesh.sides = {{below.name, {{0, 2}}}, {above.name, {{1, 0}}}}; // the facets opposite to these vertices
  return {name, false, mesh, {x + size / 2, y + size / 2, 0.0}, {std::move(below), std::move(above)}};
}

int main()
{
  using namespace ndframe;
  const DrawnBody plate = square("plate", -1.0, -2.0, 2.0, {"ground", {0.0, -2.0, 0.0}, {0.0, -1.0, 0.0}, 2.0},
                                 {"table", {}, {0.0, 1.0, 0.0}, 2.0, true});
  const DrawnBody block = square("block", -0.5, 0.25, 1.0, {"sole", {0.0, 0.25, 0.0}, {0.0, -1.0, 0.0}, 1.0, true},
                                 {"top", {0.0, 1.25, 0.0}, {0.0, 1.0, 0.0}, 1.0});
  const DrawnAssembly scene{2, 4.0, {plate, block}, {{0, 1, "table", "sole", 0.25}}};
  refuseNamelessSides(scene);

  const GuessedScene guessed(scene);
  DeckWriter writer;
  writer.open("Bodies");
  for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
    writer.open(scene.bodies[body].name);
    guessed.write(body, writer);
    writer.close();
  }
  writer.close();

  const DeckList bodies = parseDeck(writer.written(), "guess.xml");
  const DeckList& held = bodies.lists[0].lists[0].lists[0]; // plate, Supports
  const DeckList& moved = bodies.lists[1].lists[0].lists[0];
  const double down = -std::stod(moved.findEntry("Y")->value); // through the opening, and a little more
  const bool ok = !overlapOf(scene) && held.findEntry("Type")->value == "Clamp" &&
                  held.findEntry("Side")->value == "ground" && moved.findEntry("Side")->value == "top" &&
                  std::stod(moved.findEntry("X")->value) == 0.0 && down > 0.25 && down < 0.26;
  return ok ? 0 : 1;
}
