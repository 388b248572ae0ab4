#include "drawn_deck.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drawn_scene.hpp"
#include "drawn_trial.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/drawing/guessed_scene.hpp"
#include "shell_files.hpp"

namespace ndframe
{

namespace
{

std::string sideNames(const DrawnBody& body)
{
  std::vector<std::string> names;
  for (const DrawnSide& side : body.sides)
    names.push_back(side.name);
  return names.empty() ? "none is named" : fmt::format("{}", fmt::join(names, ", "));
}

void writeBody(const DrawnAssembly& scene, std::size_t index, const std::string& drawing, const GuessedScene& guessed,
               DeckWriter& deck)
{
  const DrawnBody& body = scene.bodies[index];
  deck.comment(fmt::format("Sides: {}.", sideNames(body)));
  deck.open(body.name);
  deck.open("Mesh");
  deck.text("Type", "Gmsh");
  deck.text("File", drawing);
  if (!body.isWholeFile)
    deck.entry("Regions", "Array(string)", "{" + body.name + "}");
  deck.close();
  deck.open("Material");
  deck.comment("To be set: stresses have the unit of Young's modulus, lengths that of the drawing.");
  deck.entry("Young Modulus", "double", "1.0");
  deck.entry("Poisson Ratio", "double", "0.3");
  deck.text("Hypothesis", scene.dim == 2 ? "Plane Strain" : "Three Dimensional");
  deck.close();
  guessed.write(index, deck);
  deck.close();
}

void writeInterfaces(const DrawnAssembly& scene, DeckWriter& deck)
{
  if (scene.contacts.empty())
    return;
  deck.emptyLine();
  deck.open("Interfaces");
  deck.comment("Sides that face each other, without friction. Tied = true (bool) glues two sides.");
  for (const DrawnContact& contact : scene.contacts) {
    const std::string &first = scene.bodies[contact.first].name, &second = scene.bodies[contact.second].name;
    deck.open(fmt::format("{} {} - {} {}", first, contact.firstSide, second, contact.secondSide));
    deck.text("Dirichlet Body", first);
    deck.text("Dirichlet Side", contact.firstSide);
    deck.text("Neumann Body", second);
    deck.text("Neumann Side", contact.secondSide);
    deck.close();
  }
  deck.close();
}

bool touchesAtACurve(const DrawnAssembly& scene)
{
  for (const DrawnBody& body : scene.bodies)
    if (std::any_of(body.sides.begin(), body.sides.end(),
                    [](const DrawnSide& side) { return side.touches && !side.isFlat(); }))
      return true;
  return false;
}

/// Where contact meets the corners between the chords of a curve its pressure is several times too high.
void writeRefinement(DeckWriter& deck)
{
  deck.comment(
      "Some sides that touch are curved: gmsh makes finer meshes along the curve. Bisection keeps the chords of "
      "the first mesh.");
  deck.open("Refinement");
  deck.text("Type", "Remesh");
  deck.close();
}

void writeGoal(const DrawnAssembly& scene, bool mayRemesh, DeckWriter& deck)
{
  deck.emptyLine();
  if (scene.dim == 2) {
    deck.comment("The error that you accept, guaranteed: meshes are refined until the bound is below it.");
    deck.open("Accuracy");
    deck.entry("Target", "double", "0.05");
    if (mayRemesh && touchesAtACurve(scene))
      writeRefinement(deck);
  } else {
    deck.comment(
        "How wrong the answer is. A list Accuracy with Target = 0.05 refines the meshes until 5 % are reached.");
    deck.open("Error Estimation");
    deck.entry("Estimators", "Array(string)", "{Global}");
  }
  deck.close();
}

/// As the deck names the file: from its own folder.
std::string namedFrom(const std::string& output, const std::string& drawing)
{
  namespace fs = std::filesystem;
  if (fs::path(drawing).is_absolute())
    return drawing;
  return fs::proximate(fs::absolute(drawing), fs::absolute(output).parent_path()).string();
}

/// Mistakes have their place in the drawing, not in a deck that is not there yet.
DrawnAssembly read(const std::string& drawing, const std::string& output, const Components& components)
{
  try {
    return readDrawing(drawing, output, components);
  } catch (const InputError& error) {
    throw InputError(error.list().front().message);
  }
}

std::string written(const DrawnAssembly& scene, const GuessedScene& guessed, const std::string& file,
                    const std::string& name)
{
  DeckWriter deck;
  deck.comment(fmt::format("What is drawn in {}. Run it: ndframe {}, and see the results: ndframe report {}.", file,
                           forShell(name + ".xml"), forShell(name)));
  deck.comment("Look at what is guessed and set the materials; `ndframe -h Supports` explains a list of the deck.");
  deck.open(name);
  deck.text("Title", name);
  deck.emptyLine();
  deck.open("Bodies");
  for (std::size_t body = 0; body < scene.bodies.size(); ++body)
    writeBody(scene, body, file, guessed, deck);
  deck.close();
  writeInterfaces(scene, deck);
  writeGoal(scene, std::filesystem::path(file).extension() == ".geo" && !guessed.holdsAVertex(), deck);
  deck.close();
  return deck.written();
}

/// Leaves out each Hold that the mistakes name; whether there is one.
bool leaveOutHolds(const std::vector<Diagnostic>& mistakes, const DrawnAssembly& scene, GuessedScene& guessed)
{
  bool found = false;
  for (const Diagnostic& mistake : mistakes)
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
      if (mistake.path == fmt::format("Bodies/{}/Supports/{}", scene.bodies[body].name, GuessedScene::holdName)) {
        guessed.leaveOutHold(body);
        found = true;
      }
  return found;
}

} // namespace

DrawnDeck drawnDeck(const std::string& drawing, const std::string& output, const Components& components)
{
  const std::string file = namedFrom(output, drawing);
  const DrawnAssembly scene = read(file, output, components);
  GuessedScene guessed(scene);
  const std::string name = std::filesystem::path(output).stem().string();
  DrawnDeck deck{written(scene, guessed, file, name), {}};
  deck.mistakes = mistakesOfDeck(deck.text, output, components);
  while (leaveOutHolds(deck.mistakes, scene, guessed)) {
    deck.text = written(scene, guessed, file, name);
    deck.mistakes = mistakesOfDeck(deck.text, output, components);
  }
  return deck;
}

} // namespace ndframe
