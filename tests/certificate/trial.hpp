#pragma once

#include <string>
#include <vector>

#include "certificate/drawn_scene.hpp"
#include "ndframe/certification/error_summary.hpp"

namespace ndframe::test
{

/// What a scene's certificate said, and whether it was true.
struct Trial
{
  int index = 0;
  std::string kind;
  std::string refused; ///< why the scene has no certificate (a load that pulls the body off); empty: it has one
  int order = 0, sweeps = 0;
  bool converged = true;
  ErrorSummary errors;
  double seconds = 0.0;
  std::vector<std::string> violations;
  bool excused = false; ///< not guaranteed, for a reason that docs/theory.md names
};

/// Writes the scene's files to `folder` (made if missing), runs the deck, judges the certificate.
/// The files stay when it is wrong or `keep`.
Trial runTrial(const DrawnScene& scene, int index, const std::string& folder, bool keep);

/// |sigma_ref - sigma^| and so on against their bounds: one sentence for everything that is wrong.
/// roundOff: by which an error may exceed its bound where they are equal, relative.
std::vector<std::string> judge(const ErrorSummary& errors, double roundOff = 1e-9);

} // namespace ndframe::test
