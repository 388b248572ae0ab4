#pragma once

#include "certificate_steps.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/certification/error_summary.hpp"
#include "ndframe/estimation/energy_bracket.hpp"

namespace ndframe
{

class ElementDistances;

/// A recovered stress sigma^ = K eps(u~) + c with the fields it was made from.
struct RecoveredField
{
  IntermediateField field;
  SceneStress stress;
};

/// The displacement that a stress is compared with, and what the comparison has to add.
struct AdmissibleScene
{
  GapBound gap;
  AdmissibleDisplacement displacement;
  std::vector<CellValues> oscillation; ///< loads and t^ n that polynomials do not carry, squared, per body and cell
  double prescribed = 0.0;             ///< prescribed displacements that polynomials do not carry
  std::string caveat;                  ///< why these are not proven; empty when they are
};

/// u^ and the gap.
AdmissibleScene admitScene(const CertifiedScene& scene, const RecoveryScene& recovery, ErrorMode mode);

/// The data's oscillation and what the stress, if there is one, leaves over of t^ n where n turns along a facet (this
/// bounded like `bound`); not in Paper mode.
void addOscillation(const CertifiedScene& scene, const RecoveryScene& recovery, const RecoveredField& recovered,
                    ErrorMode mode, OscillationBound bound, AdmissibleScene& admissible);

/// Bounds the data's oscillation sharper where it is more than a small share of a measure; false where it is not.
bool sharpenOscillation(const CertifiedScene& scene, RecoveryScene& recovery, const ErrorMeasure& measure);

/// SceneField::opening, and in space SceneField::beside: |u~ - u^|^2 + 2 int t^ (w^ - w~), t^ as projected, as far as
/// u~ is in finite element equilibrium.
void setOpening(const CertifiedScene& scene, const IntermediateField& field, const AdmissibleScene& admissible,
                SceneField& input);

/// (39): distance of the stress from K eps(u^), contact term, what is added. distances: of this stress.
ErrorMeasure measureStress(const CertifiedScene& scene, const RecoveredField& recovered,
                           const AdmissibleScene& admissible, ElementDistances& distances);

/// (50): distance of K eps(u~) from K eps(u_h), contact term with the projected traction at the nodes.
ErrorMeasure measureAlgorithm(const CertifiedScene& scene, const IntermediateField& field);

/// |sigma^ - sigma~|.
double correctionNorm(const CertifiedScene& scene, const RecoveredField& recovered);

/// settleBalance for the bodies and fields that need it. Ledger count "settled stresses".
void settle(const CertifiedScene& scene, const RecoveryScene& recovery, const std::vector<RecoveredField*>& recovered,
            Ledger& ledger);

/// Largest defect that checkEquilibrium finds in a stress, relative to the largest stress of the scene.
double equilibriumDefect(const CertifiedScene& scene, const RecoveryScene& recovery, const RecoveredField& recovered);

/// Every condition of the bound (docs/theory.md, section 2). equilibrium: what Check Equilibrium found in its own
/// stress, 0 if not asked; pointCaveat: of point_caveat.hpp.
Guarantee judge(const CertifiedScene& scene, const RecoveredField& recovered, const AdmissibleScene& admissible,
                ErrorMode mode, double equilibrium, const std::string& pointCaveat);

/// What the certificate says of the exact energy, where its conditions hold; none where loads do work on what
/// prescribed displacements are not met by.
std::optional<EnergyBracket> energyOf(const CertifiedScene& scene, const RecoveredField& recovered,
                                      const AdmissibleScene& admissible, const ErrorMeasure& measure);

/// Moves u^ to where the bound with this stress is smallest (tightenDisplacement); the measure with it. Strict mode,
/// scenes with interfaces.
ErrorMeasure tighten(const CertifiedScene& scene, const RecoveredField& recovered, AdmissibleScene& admissible,
                     ElementDistances& distances);

/// Strict: the sharpest bound; Paper: the sum (39).
double boundOf(const ErrorMeasure& measure, ErrorMode mode);

/// absolute: what the parts amount to.
ErrorMeasureSummary summarizeMeasure(const ErrorMeasure& measure, double absolute, double norm);

/// Contributions of the cells, per body, not squared.
std::vector<CellValues> cellContributions(const ErrorMeasure& measure);

} // namespace ndframe
