#pragma once

#include <string>
#include <vector>

namespace ndframe
{

/// One interface node in NAME.contact.csv.
struct ContactNode
{
  std::string interface;          ///< name
  std::vector<double> point;      ///< dim coordinates
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

/// The table as CSV text: a header line with the column names, then one line per node sorted as given,
/// 17 significant digits, `closed` as 0 or 1. 2-D files have no z column, 3-D files no arc_length.
std::string contactCsv(const std::vector<ContactNode>& nodes, int dim);

} // namespace ndframe
