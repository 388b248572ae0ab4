#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ndframe/certification/error_options.hpp"
#include "ndframe/run/accuracy_options.hpp"
#include "ndframe/run/output_options.hpp"
#include "ndframe/run/run_summary.hpp"
#include "ndframe/scene/scene_settings.hpp"

namespace ndframe
{

/// A number of a summary by its path; empty where there is none.
using NumberOf = std::optional<double> (*)(const RunSummary& summary, const std::string& path);

/// A number that the run must reproduce.
struct Expectation
{
  ListPlace place;      ///< for mistakes that show later
  std::string name;     ///< of the entry in Expect
  std::string quantity; ///< path in the summary
  /// In the unit of the quantity.
  double value = 0.0, tolerance = 0.0; ///< largest absolute difference
};

/// What the deck says of the scene that decides which stages run.
struct SceneOutline
{
  /// Bodies that are not rigid.
  std::size_t bodies = 0, interfaces = 0; ///< in the list Interfaces
  bool findsInterfaces = false;           ///< those of a list Automatic are not known yet, and count as one
  bool needsGmsh = false;                 ///< a mesh is a script that the library has to mesh
};

/// What a deck says about a run, read once.
struct RunSettings
{
  Params deck = Params(nullptr);         ///< for its text, and for the driver, which makes other decks of it
  std::string title;                     ///< of the deck
  bool strictInput = false;              ///< warnings are mistakes
  SceneOutline outline;                  ///< of the deck
  SceneSettings scene;                   ///< what the model is built from
  std::vector<Diagnostic> unnamedFacing; ///< warnings of Interfaces/Automatic: facets that it could not take
  /// Coupling/Type and Linear Solver/Type.
  std::string coupling, linearSolver;      ///< names of the components
  std::optional<double> solverTolerance;   ///< of a linear solver that has one
  Params couplingList = Params(nullptr);   ///< for the builder
  double strainLimit = 0.0;                ///< larger strains give a warning
  bool namesTolerance = false;             ///< the deck has an entry that would stop the sweeps
  std::optional<ErrorOptions> errors;      ///< none without the list Error Estimation
  std::optional<AccuracyOptions> accuracy; ///< none without the list Accuracy
  OutputOptions output;                    ///< the list Output
  std::vector<Expectation> expectations;   ///< the list Expect, in its order
  NumberOf numberOf = nullptr;             ///< how paths of expectations are read: of those who write the summary
};

} // namespace ndframe
