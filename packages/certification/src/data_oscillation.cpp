// What loads and the traction t^ n leave over, as the measures take it.

#include <cmath>

#include "certificate_measures.hpp"
#include "ndframe/admissibility/contact_oscillation.hpp"
#include "ndframe/admissibility/make_static_data.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/assembly/fields.hpp"

namespace ndframe
{
namespace
{

/// What the stress leaves over of t^ n.
void addContact(const CertifiedScene& scene, const RecoveredField& recovered, OscillationBound bound,
                AdmissibleScene& admissible)
{
  const auto contact = contactOscillation(scene.bodies, scene.patches, recovered.stress.tractions[0], bound);
  for (std::size_t b = 0; b < contact.size(); ++b)
    for (std::size_t cell = 0; cell < contact[b].size(); ++cell) {
      double& square = admissible.oscillation[b][cell];
      square = std::pow(std::sqrt(square) + std::sqrt(contact[b][cell]), 2);
    }
}

} // namespace

void addOscillation(const CertifiedScene& scene, const RecoveryScene& recovery, const RecoveredField& recovered,
                    ErrorMode mode, OscillationBound bound, AdmissibleScene& admissible)
{
  admissible.oscillation.clear();
  for (const StaticData& data : recovery.data)
    admissible.oscillation.push_back(ofCells(data.oscillation));
  if (mode != ErrorMode::Paper && !recovered.stress.corrections.empty())
    addContact(scene, recovered, bound, admissible);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    admissible.oscillation[b] = ofCountedCells(*scene.bodies[b], std::move(admissible.oscillation[b]));
}

bool sharpenOscillation(const CertifiedScene& scene, RecoveryScene& recovery, const ErrorMeasure& measure)
{
  constexpr double share = 0.005; // of the bound, at most, that constants may cost
  if (measure.oscillation <= share * measure.elements)
    return false;
  runLargestFirst(scene.model.numDofs(), scene.condensed.threads,
                  [&](int b) { sharpenOscillation(*scene.bodies[std::size_t(b)], recovery.data[std::size_t(b)]); });
  return true;
}

} // namespace ndframe
