#pragma once

#include <vector>

#include "ndframe/recovery/stress_recovery.hpp"
#include "star_system.hpp"
#include "traction_step.hpp"

namespace ndframe
{

/// A vertex of an interface and the patches (one or two) that meet there.
struct InterfaceVertex
{
  std::vector<PatchEnd> ends;
};

/// All vertices, chain by chain as they lie along n_c turned by 90 degrees. A closed interface begins anywhere.
std::vector<InterfaceVertex> interfaceVertices(const RecoveryScene& scene);

/// Whether a body faces itself so closely that the two stars of the vertex have cells in common, and are not one.
bool starsMeet(const RecoveryScene& scene, const std::vector<const StarBody*>& bodies, const InterfaceVertex& vertex);

/// The stars of one interface vertex in the Dirichlet and in the Neumann body (one star where a slit ends), the normal
/// traction on the vertex's patches free. Scene, bodies and vertex must outlive it.
class InterfaceStar
{
public:
  /// One body's part. Released along n_c; where n_c turns along the patch, along both axes.
  struct Side
  {
    int body;
    StarSystem system;
    DenseMatrix released; ///< the released tractions, in the body's own modes, by a change of t_N
  };

  InterfaceStar(const RecoveryScene& scene, const std::vector<const StarBody*>& bodies, const InterfaceVertex& vertex);

  /// Two, or one where the other body is rigid or a slit ends.
  const std::vector<Side>& sides() const { return sides_; }
  /// The step that lowers  |x|^2 + 2 int dt (u~1_N - u~2_N - g),  x: the stresses on the stars, one field each.
  TractionStep step(const std::vector<StarFields>& x, const Vector& opening) const;

private:
  const RecoveryScene& scene_;
  const InterfaceVertex& vertex_;
  std::vector<Side> sides_;
};

} // namespace ndframe
