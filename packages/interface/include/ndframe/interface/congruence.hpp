#pragma once

#include <memory>
#include <vector>

#include "ndframe/algebra/sparse_row.hpp"
#include "ndframe/algebra/symmetric_operator.hpp"

namespace ndframe
{

/// One operator inside a larger system: its values are P x, row by row.
struct CongruencePart
{
  std::shared_ptr<const SymmetricOperator> S; ///< on its own values; never null
  std::vector<SparseRow> P;                   ///< one row per value; columns: unknowns of the larger system
};

/// sum_b P_b^T S_b P_b on `size` unknowns: stored when every part is stored, else applied. One part whose P is the unit
/// matrix is handed back as it is.
///
/// motions: so many of the last unknowns move many values at once; they are preconditioned by themselves. Where the
/// values of all parts together determine the other unknowns one after the other, S_b^-1 of the parts gives the
/// preconditioner P^-1 diag(S_b^-1) P^-T, and on sets that no value leaves the inverse itself.
std::shared_ptr<const SymmetricOperator> congruence(std::vector<CongruencePart> parts, int size, int motions = 0);

} // namespace ndframe
