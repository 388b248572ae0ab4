#pragma once

#include <array>

namespace ndframe
{

/// One interface node of a solved scene, a row of NAME.contact.csv.
struct ContactNode
{
  int interface = 0;              ///< index in the model
  std::array<double, 3> point{};  ///< undeformed; z = 0 in the plane
  double arcLength = 0.0;         ///< along the side, from where it begins (2-D)
  double uDirichlet = 0.0;        ///< u1_N
  double uNeumann = 0.0;          ///< u2_N
  double gap = 0.0;               ///< g - (u1_N - u2_N): opening that is left
  double tractionDirichlet = 0.0; ///< Lambda_dir
  double tractionNeumann = 0.0;   ///< Lambda_neu
  double nodalForce = 0.0;        ///< int t psi_i of Lambda_dir; psi_i a Bernstein polynomial where contact is asked so
  double pressure = 0.0;          ///< contact pressure >= 0: zero where the node is open
  bool closed = false;            ///< status; false where the node has no unknown of its own
  double condition = 0.0;         ///< what is closed at 0: the gap, or its Bernstein coefficient; not written
};

} // namespace ndframe
