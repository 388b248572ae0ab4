#pragma once

#include "certificate_measures.hpp"

namespace ndframe
{

/// cellDistances of a body, at some cells of a solid, of which there is one value each: threads share them, and ranks,
/// where they have pieces of the body. v: null for zero. `cells`: null for all. Collective.
CellValues elementDistances(const CertifiedScene& scene, std::size_t body, const SceneStress& stress, const Vector* v,
                            const std::vector<int>* cells = nullptr);

/// cellDistances of all bodies for admissible displacements that come one after the other. Cells of solids, and
/// plane bodies, where the displacement stays as it was are not measured again.
class ElementDistances
{
public:
  /// Both must outlive it.
  ElementDistances(const CertifiedScene& scene, const RecoveredField& recovered);

  /// Per body, zero on rigid ones; u^ per body, global axes. Collective.
  const std::vector<CellValues>& to(const std::vector<NodalField>& displacement);

private:
  std::vector<int> changed(std::size_t body, const Vector& v) const;

  const CertifiedScene& scene_;
  const RecoveredField& recovered_;
  std::vector<NodalField> last_; ///< u~ - u^ of the last call
  std::vector<CellValues> distances_;
};

} // namespace ndframe
