#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ndframe/algebra/symmetric_operator.hpp"

namespace ndframe
{

/// One body's operator inside a larger system: its k-th value is the sum of the system's entries inputs[k] (-1:
/// unused).
struct OperatorPart
{
  std::shared_ptr<const SymmetricOperator> S;
  std::vector<std::array<int, 2>> inputs;
};

/// sum_b P_b^T S_b P_b on `size` unknowns: stored when every part is stored, else applied. One part that covers the
/// unknowns in their order is handed back as it is.
std::shared_ptr<const SymmetricOperator> composeOperators(std::vector<OperatorPart> parts, int size);

} // namespace ndframe
