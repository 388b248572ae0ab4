#pragma once

#include "certificate/drawn_scene.hpp"

namespace ndframe::test
{

/// A converged P2 scene as sharpness is asked for: the punch of section 6.1, the contact loss of 6.2, one body without
/// contact, or a random contact scene (kind: "punch", "contact-loss", "linear", "random"), all with meshes, materials,
/// loads and sizes drawn. Isotropic materials, nu from 0 to 0.45; stiffness ratios from 1/100 to 100.
///
/// 6 to `finest` cells a unit length. aspect: 1, or the cells' length over their height or the inverse. Neighbouring
/// cells of graded meshes differ by less than 1.2. The kind continues with the mesh's style.
DrawnScene drawIsotropicScene(const std::string& kind, double aspect, int finest, Draw& draw);

} // namespace ndframe::test
