#pragma once

#include <string>
#include <vector>

#include "contact_scene.hpp"
#include "ndframe/admissibility/admissible_displacement.hpp"
#include "ndframe/admissibility/admissible_traction.hpp"
#include "ndframe/certification/error_options.hpp"
#include "ndframe/condensation/solution.hpp"
#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

/// A solved scene as the certificate looks at it. Everything it points to must outlive it.
struct CertifiedScene
{
  const Model& model;
  const CondensedModel& condensed;
  const CouplingResult& coupling;
  const std::vector<BodyFields>& fields; ///< per body; the last state is the certified one
  std::vector<const BodyModel*> bodies;
  std::vector<NodalField> solved;    ///< u_h per body, global axes
  std::vector<ContactPatch> patches; ///< of all interfaces
  int order = 0;                     ///< of the displacements
  int degree = 0;                    ///< of the stresses and tractions
  double norm = 0.0;                 ///< sqrt(sum a(u_h, u_h))
  Comm comm = Comm::single();
  /// The ranks that have parts of the bodies (BodyShare); a single one where each has all of them.
  Comm parts = Comm::single();

  int dim() const { return bodies.front()->mesh.dim; }
};

/// Stresses K eps(u~) of all bodies in finite element equilibrium with the loads and with tractions on the interfaces.
struct IntermediateField
{
  SideTractions tractions;
  std::vector<NodalField> displacement; ///< u~ per body, global axes
};

/// What a bound rests on and this run could not show; the first reason is kept.
class Guarantee
{
public:
  void require(bool holds, const std::string& otherwise);
  /// Sentences, each with ". " at its end; the last full stop is dropped.
  void accept(const std::string& caveat);
  bool holds() const { return reason_.empty(); }
  const std::string& reason() const { return reason_; }

private:
  std::string reason_;
};

CertifiedScene makeScene(const Model& model, const CondensedModel& condensed, const CouplingResult& coupling,
                         const std::vector<BodyFields>& fields, int degree, const Comm& comm);

/// What the recovery has to know of the scene: data of the bodies, facets.
RecoveryScene makeRecoveryScene(const CertifiedScene& scene);

/// A field for the recovery; it points to the displacements of `field`.
SceneField makeSceneField(const IntermediateField& field);

/// The interface tractions of a stress as one body feels them (FieldInput::contact); empty without contact.
Vector sharesOf(const CertifiedScene& scene, const SceneStress& stress, int body);

/// 1/|f| int psi_i dS of a patch's nodal functions: lambda_a, or lambda_a (2 lambda_a - 1) and 4 lambda_a lambda_b.
double shareOf(int dim, int order, std::size_t node);

/// Steps 1 and 2 of section 5.3 for a traction at the interface nodes, and its values there. Throws NotConverged when
/// no traction that presses everywhere holds a floating body.
/// cost: as in projectTraction.
Vector admitNodal(const CertifiedScene& scene, const Vector& nodal, TractionSign sign, const Vector& cost);
ContactTraction admitTraction(const CertifiedScene& scene, const Vector& nodal, TractionSign sign,
                              const Vector& cost = {});

/// What tractions cost where the sides are apart in the solution, beside their distance from the computed ones: the
/// bound's square is about  sum_f h_f / E |t^ - t|^2 + 4 int t^ ([u_h] - g),  so a unit nodal value costs
/// 2 E / h int psi_i w, w = [u_h] - g where that is negative.
Vector openingCost(const CertifiedScene& scene, const Vector& traction);

/// Whether something besides the bound asks for the fields u~.
bool measuresFields(const ErrorOptions& options);

/// Whether cells differ little in size. Else what near fields lack was seen to cost 13 % of a bound (punch-3d adapted
/// to 1 %), for reasons not yet understood.
bool areOfOneSize(const CertifiedScene& scene);

/// Solves (40) for several pairs of tractions at once: at most one back-solve a body and field. areNear: no solve of
/// bodies that are solved whole (FieldNeed).
void solveFields(const CertifiedScene& scene, std::vector<IntermediateField*> fields, bool areNear = false);

/// The gap on all facets, for admissible displacements and contact terms; in Paper mode the interpolated one.
GapBound contactGap(const CertifiedScene& scene, ErrorMode mode);

std::vector<const ConstraintSet*> constraintsOf(const Model& model);

/// u^: u_h in Paper mode and without contact.
AdmissibleDisplacement admitDisplacements(const CertifiedScene& scene, const GapBound& gap, ErrorMode mode);

/// Per facet and mode int (u1_N - u2_N - g) L_k dS.
Vector openings(const CertifiedScene& scene, const std::vector<NodalField>& displacement, const GapBound& gap);

/// The gap at the interface nodes, numbered as in the contact matrix.
Vector nodalGap(const Model& model);

/// Largest component at any node of any body.
double largestDisplacement(const CertifiedScene& scene, const std::vector<NodalField>& fields);

/// Largest of the signConditions() of t_N over all facets, relative to the mean tractions: above round-off it pulls.
double largestTension(const CertifiedScene& scene, const ContactTraction& traction);

/// Largest Bernstein coefficient of the jump minus g_h over all facets, relative to the displacements.
double largestPenetration(const CertifiedScene& scene, const std::vector<NodalField>& displacement,
                          const GapBound& gap);

} // namespace ndframe
