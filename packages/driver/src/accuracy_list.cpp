#include "accuracy_list.hpp"

#include <fmt/format.h>

#include "ndframe/base/list_specs.hpp"

namespace ndframe
{
namespace
{

/// True where a deck says how stresses are recovered.
bool namesRecovery(const DeckList& errors)
{
  const DeckList* recovery = errors.findList("Recovery");
  return recovery != nullptr && (recovery->findEntry("Type") != nullptr || recovery->findEntry("Sweeps") != nullptr);
}

/// An optional limit; without it there is none.
double limit(const Params& list, const char* key, double unit)
{
  return list.has(key) ? unit * list.get<double>(key) : std::numeric_limits<double>::infinity();
}

/// Who writes 10 means 10 %.
Range share()
{
  return {"(0, 1); 0.1 is 10 %", inOpenRange(0.0, 1.0).contains};
}

/// True when the sweeps on a mesh end by their part of the error; false when Coupling/Stopping ends them.
bool balancesSweeps(const Params& accuracy, const AccuracyComponents& components)
{
  return components.levelStoppings.build(accuracy.sub("Stopping"))->allowed(1.0, 1.0) > 0.0;
}

} // namespace

ListSpec accuracySpec(const AccuracyComponents& components)
{
  ListSpec list;
  list.name = "Accuracy";
  list.doc = "An accuracy instead of a mesh: the meshes are refined where the error is and the sweeps stopped when "
             "their part is small, until the bound is below the target.";
  list.onlyIfGiven = true;
  list.params = {
      ParamSpec::optional("Target", Kind::Double, share(),
                          "The bound over the energy norm of the solution: 0.01 is 1 %."),
      ParamSpec::optional("Absolute Target", Kind::Double, above(0.0),
                          "The bound itself, in the energy norm (root of an energy); instead of Target."),
      {"Of", std::string("Displacement"), accuracyOfNames().range(),
       "Whose error. Displacement: the computed displacement and its stress. Mean Stress: the mean of the computed and "
       "the equilibrated stress, with about half the error."},
      {"Start", std::string("Coarsest"), accuracyStartNames().range(),
       "The first meshes. Coarsest: boxes with as few cells as their sides and their neighbours allow, meshes from "
       "files as they are. Deck: all as the deck says."},
      {"Iteration Share", 0.3, inOpenRange(0.0, 1.0),
       "The sweeps on a mesh end when their part of the error is below this share of the mesh's."},
      {"Maximum Dofs", 1000000, atLeast(1), "No mesh is refined to more dofs than this."},
      {"Maximum Levels", 40, atLeast(1), "No more meshes than this, the first one included."},
      ParamSpec::optional("Maximum Memory", Kind::Double, above(0.0), "GB that a process may use."),
      ParamSpec::optional("Maximum Time", Kind::Double, above(0.0),
                          "Seconds of elapsed time; a mesh that would not be finished in time is not begun.")};
  list.lists = {
      makeChoice("Marking", "Which cells become smaller, and how small.", components.markings.choices()),
      makeChoice("Refinement", "How the meshes are made.", components.refinements.choices()),
      makeChoice("Transfer", "What the sweeps on a finer mesh start from.", components.contactTransfers.choices()),
      makeChoice("Stopping", "When the sweeps on a mesh end.", components.levelStoppings.choices())};
  return list;
}

void completeAccuracyDeck(DeckList& deck, Diagnostics& diagnostics)
{
  if (deck.findList("Accuracy") == nullptr)
    return;
  if (deck.findList("Error Estimation") == nullptr)
    applySetting(deck, "Error Estimation/Estimators={Global}", diagnostics);
  if (!namesRecovery(*deck.findList("Error Estimation")))
    applySetting(deck, "Error Estimation/Recovery/Sweeps=1", diagnostics);
  const DeckList* coupling = deck.findList("Coupling");
  const DeckEntry* type = coupling == nullptr ? nullptr : coupling->findEntry("Type");
  const bool sweeps = type == nullptr || type->value == "Automatic" || type->value == "Neumann-Dirichlet";
  if (sweeps && (coupling == nullptr || coupling->findEntry("Initial Traction") == nullptr))
    applySetting(deck, "Coupling/Initial Traction=Balanced", diagnostics);
}

AccuracyOptions accuracyOptions(const Params& deck)
{
  const Params list = deck.sub("Accuracy");
  AccuracyOptions options;
  options.place = ListPlace(list);
  options.relative = list.has("Target");
  for (const char* key : {"Absolute Target", "Target"}) // checkAccuracy refuses both and none
    if (list.has(key))
      options.target = list.get<double>(key);
  options.of = accuracyOfNames().value(list.get<std::string>("Of"));
  options.start = accuracyStartNames().value(list.get<std::string>("Start"));
  options.maximumDofs = list.get<int>("Maximum Dofs");
  options.maximumLevels = list.get<int>("Maximum Levels");
  options.maximumMemory = limit(list, "Maximum Memory", 1e9);
  options.maximumSeconds = limit(list, "Maximum Time", 1.0);
  options.iterationShare = list.get<double>("Iteration Share");
  options.lists = {list.sub("Marking"), list.sub("Refinement"), list.sub("Transfer"), list.sub("Stopping")};
  options.marking = options.lists.marking.get<std::string>("Type");
  options.refinement = options.lists.refinement.get<std::string>("Type");
  return options;
}

void checkCheckpoint(const RunSettings& settings, const Coupling& coupling, Diagnostics& diagnostics)
{
  const OutputOptions& output = settings.output;
  const bool sweeps = settings.outline.interfaces > 0 && coupling.keepsSweeps();
  if (!output.checkpoint)
    return;
  if (!settings.accuracy && (settings.outline.interfaces == 0 || output.checkpointSweeps == 0))
    diagnostics.add(output.place.mistake(
        "Checkpoint", "Checkpoint continues from the levels of a run with a target or from the sweeps or status passes "
                      "of bodies in contact (Checkpoint Sweeps), and the deck asks for neither."));
  if (sweeps && output.checkpointSweeps > 0 && output.steps == StepsWritten::AllSweeps)
    diagnostics.add(output.place.mistake(
        "Checkpoint Sweeps", "Checkpoint Sweeps keeps the last state alone, and Steps = All Sweeps writes all of them; "
                             "set Checkpoint Sweeps = 0 to continue from levels only, or remove Steps."));
}

void checkAccuracy(const RunSettings& settings, const AccuracyComponents& components, Diagnostics& diagnostics)
{
  const OutputOptions& output = settings.output;
  if (!settings.accuracy) {
    if (output.allLevels)
      diagnostics.add(output.place.mistake("All Levels", "All Levels writes the meshes on the way to a target, and the "
                                                         "deck has no list Accuracy."));
    return;
  }
  if (output.allLevels && !output.exodus)
    diagnostics.add(
        output.place.mistake("All Levels", "All Levels writes Exodus files, and Exodus is false; remove one."));
  const Params list = settings.deck.sub("Accuracy");
  if (list.has("Target") == list.has("Absolute Target"))
    diagnostics.add(list.mistake("", list.has("Target") ? "names both Target and Absolute Target; remove one of them."
                                                        : "names no target; give Target = 0.01, say, for 1 %."));
  if (list.isGiven("Iteration Share") && !balancesSweeps(list, components))
    diagnostics.add(
        list.mistake("Iteration Share", "Iteration Share is for Stopping/Type = Balanced; remove one of them."));
  if (!settings.errors) // completeAccuracyDeck() was not called
    diagnostics.add(list.mistake("", "compares a bound with its target; add the list Error Estimation."));
  else if (!settings.errors->wants(Estimator::Global))
    diagnostics.add(settings.errors->place.mistake(
        "Estimators", "a list Accuracy compares the bound with its target; add \"Global\"."));
}

} // namespace ndframe
