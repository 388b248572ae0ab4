#pragma once

#include "admissibility/sample_problems.hpp"
#include "ndframe/admissibility/admissible_traction.hpp"
#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe::test
{

/// How the scene is made; lengths and stresses are multiplied by the units.
struct ContactKind
{
  int order = 2, degree = 2;
  bool floating = false; ///< the punch has no support at all; else a roller on its left side
  bool kinked = false;   ///< the interface bends in its middle
  bool turns = false;    ///< n_c turns along the facets
  double pull = 0.0;     ///< the traction that is projected is -1 + pull * x: for pull > 2 the contact ends
  double length = 1.0, stress = 1.0;
  bool renumbered = false; ///< points and cells of both bodies in another order
};

/// A punch (body 0, Dirichlet) that a pressure pushes on a clamped foundation (body 1, Neumann) of the same width, with
/// an admissible traction between them and the intermediate fields (40).
struct ContactScene
{
  std::vector<BodyModel> bodies;
  std::vector<double> x; ///< per interface node
  RecoveryScene recovery;
  BalanceConditions balance;
  std::vector<NodalField> displacement; ///< u~ per body
  SceneField field;                     ///< to be optimised; gap 0.1 x^2
};

ContactScene contactScene(const ContactKind& kind);

/// Per body the shares of a traction.
std::vector<Vector> sharesOf(const ContactScene& scene, const ContactTraction& traction);

/// |c|^2 + 2 int t (u~1_N - u~2_N - g), the part of the squared bound that the traction decides.
double objective(const ContactScene& scene, const ContactTraction& traction,
                 const std::vector<StressCorrection>& corrections);

} // namespace ndframe::test
