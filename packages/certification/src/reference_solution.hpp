#pragma once

#include <memory>

#include "ndframe/certification/certificate_components.hpp"
#include "ndframe/certification/error_summary.hpp"
#include "ndframe/condensation/condensed_model.hpp"
#include "ndframe/estimation/error_measure.hpp"

namespace ndframe
{

/// The same scene on meshes with every edge halved several times, solved without iteration between the bodies
/// (Monolithic) whatever the deck's coupling is; Automatic linear solver unless the deck asks for one that iterates.
///
/// The coarse fields are fields of the fine meshes too, so differences are exact up to round-off. All is global axes;
/// norms are energy norms over all bodies. Throws what a run throws: NotConverged, InputError (memory).
class ReferenceSolution
{
public:
  /// model: the coarse scene. Collective, as all functions are.
  ReferenceSolution(const SceneSettings& settings, const CertificateComponents& components, const Model& model,
                    int refinements, const Comm& comm);

  /// Whether a reference made of this coarse scene would be the same.
  bool suits(const Model& coarse, int refinements) const;

  int refinements() const { return refinements_; }
  std::int64_t dofs() const;                                                    ///< dim * nodes of all bodies
  const Model& model() const { return model_; }                                 ///< the fine scene
  const std::vector<NodalField>& displacement() const { return displacement_; } ///< u_ref per body, on the fine meshes

  /// |u| of a displacement on the coarse meshes, per body.
  double norm(const std::vector<NodalField>& displacement) const;

  /// |u_ref - u|.
  double distance(const std::vector<NodalField>& displacement) const;

  /// |sigma_ref - sigma^| for a stress in equilibrium with the loads and with the traction t^ on the coarse facets,
  /// whose distance from the stress of an admissible displacement u^ is D: with v = u_ref - u^,
  ///
  ///   |sigma_ref - sigma^|^2 = D^2 - 2 (f_ref . v + int t^ [v_N] dS - (P u^)^T K_ref v) + v^T K_ref v.
  ///
  /// Limits: exact where the loads are those that sigma^ balances (no oscillation) and v vanishes on the supports
  /// (prescribed displacements that polynomials of the coarse mesh carry).
  double stressDistance(const Model& coarse, const std::vector<NodalField>& admissible,
                        const std::vector<ContactPatch>& patches, const ContactTraction& traction, double D) const;

private:
  std::vector<NodalField> onFineMesh(const std::vector<NodalField>& displacement) const;
  Vector applyStiffness(std::size_t body, const Vector& displacement) const;
  double fineNorm(const std::vector<NodalField>& displacement) const;

  Comm comm_;
  int refinements_;
  SceneRecipe recipe_;                        ///< of the coarse scene
  std::vector<std::vector<NodeMap>> coarser_; ///< per body, from the coarse mesh to the last but one
  Model model_;                               ///< the fine scene
  std::vector<BodySystem> systems_;
  std::vector<NodalField> displacement_; ///< u_ref per body
};

/// How deep the reference goes.
struct ReferenceDepth
{
  int refinements = 3;          ///< halvings of every edge
  std::int64_t maximumDofs = 0; ///< it goes less deep where it would have more; 0: by the dimension
};

/// What a certificate says, to be judged: u^ per body, the admissible traction of sigma^, the measure (39).
struct CertifiedStress
{
  const std::vector<NodalField>& admissible;
  const std::vector<ContactPatch>& patches;
  const ContactTraction& traction;
  const ErrorMeasure& measure;
  double bound;
};

/// Makes `reference` (of another run, or null) the one of this scene and model; keeps it where it suits ("references
/// reused" in the ledger). Null without a single refinement below the limit.
void updateReference(std::shared_ptr<const ReferenceSolution>& reference, const SceneSettings& settings,
                     const CertificateComponents& components, const Model& model, const ReferenceDepth& depth,
                     const Comm& comm, Ledger& ledger);

/// The true errors of u_h (`displacement`, per body) and, with a certificate, of its stresses and the ratio of bound
/// and error. Without a reference the numbers are NaN, and the note says why.
ReferenceSummary compareWithReference(const ReferenceSolution* reference, const Model& model,
                                      const std::vector<NodalField>& displacement, const CertifiedStress* certified,
                                      const ReferenceDepth& depth);

} // namespace ndframe
