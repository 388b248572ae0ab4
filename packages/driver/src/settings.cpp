#include "ndframe/driver/settings.hpp"

#include <algorithm>
#include <filesystem>

#include "accuracy_list.hpp"
#include "automatic_list.hpp"
#include "error_list.hpp"
#include "ndframe/report/summary_text.hpp"
#include "output_list.hpp"

namespace ndframe
{
namespace
{

/// True if the mesh is a script that the gmsh library has to mesh; mesh files are read without it.
bool isScript(const Params& mesh)
{
  if (mesh.has("File"))
    return std::filesystem::path(mesh.get<std::string>("File")).extension() == ".geo";
  if (!mesh.hasSub("Joints"))
    return false;
  const auto parts = mesh.sub("Parts").subs();
  return std::any_of(parts.begin(), parts.end(), isScript);
}

bool needsGmsh(const Params& deck)
{
  const auto bodies = deck.sub("Bodies").subs();
  return std::any_of(bodies.begin(), bodies.end(),
                     [](const Params& body) { return !body.hasSub("Rigid") && isScript(body.sub("Mesh")); });
}

/// True where the deck has an entry that would stop the sweeps.
bool namesTolerance(const Params& coupling)
{
  return coupling.hasSub("Stopping") && coupling.sub("Stopping").isGiven("Tolerance");
}

} // namespace

RunSettings readSettings(const Params& deck)
{
  const Params solver = deck.sub("Linear Solver"), coupling = deck.sub("Coupling");
  RunSettings settings;
  settings.deck = deck;
  settings.title = deck.get<std::string>("Title");
  settings.strictInput = deck.get<bool>("Strict Input");
  const auto bodies = deck.sub("Bodies").subs();
  const auto elastic =
      std::count_if(bodies.begin(), bodies.end(), [](const Params& body) { return !body.hasSub("Rigid"); });
  settings.outline = {std::size_t(elastic), deck.sub("Interfaces").subs().size(), findsInterfaces(deck),
                      needsGmsh(deck)};
  settings.scene = readScene(deck);
  settings.couplingList = coupling;
  settings.strainLimit = deck.get<double>("Strain Limit");
  settings.coupling = coupling.get<std::string>("Type");
  settings.linearSolver = solver.get<std::string>("Type");
  if (solver.has("Tolerance"))
    settings.solverTolerance = solver.get<double>("Tolerance");
  settings.namesTolerance = namesTolerance(coupling);
  if (deck.hasSub("Error Estimation"))
    settings.errors = errorOptions(deck);
  if (deck.hasSub("Accuracy"))
    settings.accuracy = accuracyOptions(deck);
  settings.output = outputOptions(deck);
  settings.expectations = expectationsOf(deck);
  settings.numberOf = summaryValue;
  return settings;
}

} // namespace ndframe
