#pragma once

#include <memory>

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/algebra/comm.hpp"
#include "ndframe/base/ledger.hpp"
#include "ndframe/base/registry.hpp"
#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// All bodies and interfaces as recovery sees them.
struct RecoveryScene
{
  std::vector<const BodyModel*> bodies; ///< not owned; rigid ones, too, which carry no stress
  std::vector<StaticData> data;         ///< per body; its contact facets are those of its patches (patchesOfBody)
  std::vector<ContactPatch> patches;    ///< of all interfaces; empty without contact
};

/// Stresses of all bodies in finite element equilibrium with the loads and with tractions on the interfaces.
struct SceneField
{
  std::vector<const Vector*> displacement; ///< u~ per body, global axes
  SideTractions tractions;                 ///< t_N as the two sides of the patches feel it
  /// The traction may be changed: it stays the same on both sides, polynomial of degree q that may jump, <= 0 in its
  /// Bernstein coefficients, in balance with the loads; it becomes the one that makes the bound small (docs/theory.md).
  /// Both tractions must be equal and admissible.
  bool optimise = false;
  /// With `optimise`: per patch and mode, int (u~1_N - u~2_N - g) L_k, the linear term of the bound.
  Vector opening;
  /// What the square of the bound has beside |c|^2 and, with `optimise`, 2 int t^ (u~1_N - u~2_N - g), about: it does
  /// not change with the stress and t^. For who measures how fast the bound falls; 0: nothing is known.
  double beside = 0.0;
  /// The square of a bound that is enough: steps go on where a few more will reach it; 0: there is none.
  double enough = 0.0;
};

struct ScenePieces;

/// sigma^ = K eps(u~) + c on all bodies, and the tractions it carries on the interfaces.
struct SceneStress
{
  std::vector<StressCorrection> corrections; ///< per body: of all cells, or of those of this rank's piece
  SideTractions tractions;                   ///< as given, or the optimised one twice
  /// Where cells are shared by the ranks: what the corrections of bodies with a piece belong to (scene_pieces.hpp).
  std::shared_ptr<const ScenePieces> pieces{};
};

/// How equilibrated stresses are found.
class StressRecovery
{
public:
  virtual ~StressRecovery() = default;

  /// All fields share geometry and factors. Collective; results are replicated but for SceneStress::pieces.
  /// Ledger counts: "stars" (star problems factored, whatever the number of fields), "star sweeps", "interface stars",
  /// "element problems", "recovery steps", "cell matrices"; on several ranks "cell matrices of the largest rank",
  /// "recovery messages" and "recovery bytes" of all ranks.
  virtual std::vector<SceneStress> recover(const RecoveryScene& scene, const std::vector<SceneField>& fields,
                                           const Comm& comm, Ledger& ledger) const = 0;

  /// Degree q of the stresses for displacements of order p.
  virtual int degree(int order) const = 0;

  /// Whether it can choose tractions (SceneField::optimise) in this dimension.
  virtual bool optimises(int dim) const = 0;

  /// Whether stresses are in equilibrium whatever u~ lacks of it, at little cost to the bound.
  virtual bool settles(int /*dim*/) const { return false; }

  /// Why it is not defined for bodies of this dimension and order, or cannot optimise tractions; empty when it can.
  virtual std::string refusal(int dim, int order, bool optimise) const = 0;

  /// The name of the component that does the work for bodies of this dimension; empty: this one itself.
  virtual std::string standsFor(int /*dim*/) const { return {}; }
};

/// "Automatic" (default; Degree, Sweeps), "Star" (Degree, Sweeps), "Global" (3-D; Degree, Least Gain, Steps),
/// "Element" (EET, 2-D; Degree). Degree 0 (default) means the order of the displacement; one more is allowed.
void registerRecoveries(Registry<StressRecovery>& registry);

} // namespace ndframe
