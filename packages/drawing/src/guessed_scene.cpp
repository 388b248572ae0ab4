#include "ndframe/drawing/guessed_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drawn_travel.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

constexpr double smallStrain = 1e-3; ///< of what is guessed
constexpr double roundOff = 1e-12;   ///< of the scene, in coordinates
constexpr double oneSided = 0.3;     ///< of the mean normal's length: what is touched lies in one direction

double length(const Vector3& v)
{
  return std::sqrt(dot(v, v));
}

Vector3 scaled(Vector3 v, double factor)
{
  for (double& x : v)
    x *= factor;
  return v;
}

/// Mean outward normal of all that touches, without what goes against a plane of symmetry.
Vector3 towardsNeighbours(const DrawnBody& body)
{
  Vector3 sum{};
  double total = 0.0;
  for (const DrawnSide& side : body.sides)
    if (side.touches) {
      for (std::size_t i = 0; i < 3; ++i)
        sum[i] += side.measure * side.normal[i];
      total += side.measure;
    }
  for (const DrawnSide& side : body.sides)
    if (const double along = dot(side.normal, sum); side.isSymmetry)
      for (std::size_t i = 0; i < 3; ++i)
        sum[i] -= along * side.normal[i];
  return scaled(sum, total > 0.0 ? 1.0 / total : 0.0);
}

/// The free side that lies farthest along a direction, if any; faces: only of those that look that way.
const DrawnSide* farthest(const DrawnBody& body, const Vector3& direction, bool faces = false)
{
  const DrawnSide* found = nullptr;
  for (const DrawnSide& side : body.sides)
    if (side.isFree() && (!faces || dot(side.normal, direction) > oneSided) &&
        (found == nullptr || dot(side.centre, direction) > dot(found->centre, direction)))
      found = &side;
  return found;
}

/// The lowest body with a side to hold.
std::size_t baseOf(const DrawnAssembly& scene)
{
  std::optional<std::size_t> base;
  const auto height = [&](std::size_t b) { return scene.bodies[b].centre[std::size_t(scene.dim - 1)]; };
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (farthest(scene.bodies[b], {}) != nullptr && (!base || height(b) < height(*base)))
      base = b;
  if (!base)
    throw InputError(
        "every named side touches another body or is a plane of symmetry: name one more that holds a body.");
  return *base;
}

void writeSymmetry(const DrawnBody& body, DeckWriter& deck)
{
  for (const DrawnSide& side : body.sides)
    if (side.isSymmetry) {
      deck.comment("Guessed: a plane of symmetry, as several bodies have this flat side.");
      deck.open(side.name);
      deck.text("Type", "Roller");
      deck.text("Side", side.name);
      deck.close();
    }
}

} // namespace

GuessedScene::GuessedScene(const DrawnAssembly& scene) : scene_(scene), base_(baseOf(scene)) {}

void GuessedScene::write(std::size_t body, DeckWriter& deck) const
{
  const DrawnBody& drawn = scene_.bodies[body];
  Vector3 push = towardsNeighbours(drawn);
  const bool hasDirection = length(push) > oneSided;
  if (!hasDirection)
    push = down();
  push = scaled(push, 1.0 / length(push));
  if (body == base_)
    return writeBase(drawn, push, deck);
  const bool mayBeDriven = hasDirection || held_.count(body) != 0;
  const DrawnSide* driven = mayBeDriven ? farthest(drawn, scaled(push, -1.0), true) : nullptr;
  if (driven == nullptr && hasDirection) // none to press; one to pull, like the foot of a bolt?
    driven = farthest(drawn, push, true);
  if (driven != nullptr)
    return writeDriven(drawn, *driven, path(body, push), deck);
  writeHeld(body, hasDirection || numNeighbours(body) == 1 ? push : Vector3{}, deck);
}

bool GuessedScene::holdsAVertex() const
{
  return std::any_of(held_.begin(), held_.end(),
                     [&](std::size_t body) { return farthest(scene_.bodies[body], {}) == nullptr; });
}

Vector3 GuessedScene::down() const
{
  Vector3 direction{};
  direction[std::size_t(scene_.dim - 1)] = -1.0;
  return direction;
}

std::size_t GuessedScene::numNeighbours(std::size_t body) const
{
  return std::size_t(std::count_if(scene_.contacts.begin(), scene_.contacts.end(), [&](const DrawnContact& contact) {
    return contact.first == body || contact.second == body;
  }));
}

/// How a body is moved: until a first side touches, and on.
Vector3 GuessedScene::path(std::size_t body, const Vector3& push) const
{
  double opening = scene_.extent;
  for (const DrawnContact& contact : scene_.contacts)
    if (contact.first == body || contact.second == body)
      opening = std::min(opening, travelUntilContact(scene_, contact, body, push).value_or(contact.opening));
  return scaled(push, opening + smallStrain * scene_.extent);
}

/// All of them; those that are round-off are 0.
void GuessedScene::writeComponents(const Vector3& vector, DeckWriter& deck) const
{
  for (std::size_t i = 0; i < std::size_t(scene_.dim); ++i)
    deck.number(std::string(1, "XYZ"[i]), std::abs(vector[i]) > 1e-6 * length(vector) ? vector[i] : 0.0);
}

void GuessedScene::writeBase(const DrawnBody& body, const Vector3& push, DeckWriter& deck) const
{
  const bool isAlone = scene_.contacts.empty();
  const DrawnSide* const held = farthest(body, scaled(push, isAlone ? 1.0 : -1.0));
  deck.open("Supports");
  writeSymmetry(body, deck);
  writeClamp(*held, deck);
  deck.close();
  if (isAlone)
    writePressed(body, held, deck);
}

void GuessedScene::writeClamp(const DrawnSide& side, DeckWriter& deck) const
{
  deck.comment("Guessed: no displacement at all on this side.");
  deck.open("held");
  deck.text("Type", "Clamp");
  deck.text("Side", side.name);
  deck.close();
}

/// The load of a body that touches nothing.
void GuessedScene::writePressed(const DrawnBody& body, const DrawnSide* held, DeckWriter& deck) const
{
  const DrawnSide* const pressed = farthest(body, scaled(down(), -1.0));
  deck.open("Loads");
  if (pressed == held) {
    writeBodyForce(down(), deck);
  } else {
    deck.comment("Guessed: a pressure, force per area, against the normal.");
    deck.open("press");
    deck.text("Type", "Pressure");
    deck.text("Side", pressed->name);
    deck.number("Value", smallStrain);
    deck.close();
  }
  deck.close();
}

void GuessedScene::writeDriven(const DrawnBody& body, const DrawnSide& side, const Vector3& path,
                               DeckWriter& deck) const
{
  deck.open("Supports");
  writeSymmetry(body, deck);
  deck.comment("Guessed: this side is moved, which presses the body against what it touches. Loads, Type = Pressure, "
               "is a force.");
  deck.open("moved");
  deck.text("Type", "Displacement");
  deck.text("Side", side.name);
  writeComponents(path, deck);
  deck.close();
  deck.close();
}

void GuessedScene::writeBodyForce(const Vector3& direction, DeckWriter& deck) const
{
  deck.comment("Guessed: a force per volume, such as a weight.");
  deck.open("weight");
  deck.text("Type", "Body Force");
  writeComponents(scaled(direction, smallStrain / scene_.extent), deck);
  deck.close();
}

/// A round body in a hole: contact holds it, but for round-off only against rolling.
void GuessedScene::writeStill(const DrawnBody& body, const Vector3& push, DeckWriter& deck) const
{
  const auto depth = [&](int vertex) {
    double sum = 0.0;
    for (int i = 0; i < scene_.dim; ++i)
      sum += push[std::size_t(i)] * body.mesh.point(vertex)[i];
    return sum;
  };
  int deepest = 0;
  for (int vertex = 1; vertex < body.mesh.numPoints(); ++vertex)
    if (depth(vertex) > depth(deepest))
      deepest = vertex;
  std::vector<double> at(body.mesh.point(deepest), body.mesh.point(deepest) + scene_.dim);
  for (double& x : at)
    x = std::abs(x) > roundOff * scene_.extent ? x : 0.0;
  deck.comment(
      "Guessed: stops the body from rolling, at a vertex; loads that it has to carry have no guaranteed bound.");
  deck.open("still");
  deck.text("Type", "Point");
  deck.entry("At", "Array(double)", fmt::format("{{{}}}", fmt::join(at, ", ")));
  for (std::size_t i = 0; i < std::size_t(scene_.dim); ++i)
    if (std::abs(push[i]) < oneSided)
      deck.number(std::string(1, "XYZ"[i]), 0.0);
  deck.close();
}

/// A body that contact and planes of symmetry carry. Where these leave motions along the contact, Hold takes them.
void GuessedScene::writeHeld(std::size_t index, const Vector3& push, DeckWriter& deck) const
{
  const DrawnBody& body = scene_.bodies[index];
  const auto planes =
      std::count_if(body.sides.begin(), body.sides.end(), [](const auto& side) { return side.isSymmetry; });
  deck.open("Supports");
  writeSymmetry(body, deck);
  if (planes < scene_.dim - 1 && held_.count(index) == 0) {
    deck.comment("Carries no force: sets to zero the mean motion that neither supports nor contact hold.");
    deck.open(holdName);
    deck.text("Type", "Hold");
    deck.close();
  }
  if (held_.count(index) != 0) {
    if (const DrawnSide* const side = farthest(body, scaled(push, -1.0)); side != nullptr)
      writeClamp(*side, deck);
    else if (length(push) > 0.0)
      writeStill(body, push, deck);
  }
  deck.close();
  if (length(push) == 0.0)
    return;
  deck.open("Loads");
  writeBodyForce(push, deck);
  deck.close();
}

} // namespace ndframe
