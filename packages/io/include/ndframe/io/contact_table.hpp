#pragma once

#include <string>
#include <vector>

namespace ndframe
{

/// One interface node in NAME.contact.csv.
struct ContactNode
{
  std::string interface;
  std::vector<double> point;      ///< dim coordinates
  double uDirichlet = 0.0;        ///< u1_N
  double uNeumann = 0.0;          ///< u2_N
  double gap = 0.0;               ///< g - (u1_N - u2_N): opening that is left
  double tractionDirichlet = 0.0; ///< Lambda_dir
  double tractionNeumann = 0.0;   ///< Lambda_neu
  double nodalForce = 0.0;        ///< (C Lambda_dir)_i
  bool closed = false;
};

/// The table as CSV text: a header line with the column names, then one line per node sorted as given,
/// 17 significant digits, `closed` as 0 or 1. 2-D files have no z column.
std::string contactCsv(const std::vector<ContactNode>& nodes, int dim);

} // namespace ndframe
