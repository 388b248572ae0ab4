#pragma once

#include "ndframe/algebra/dense.hpp"
#include "ndframe/flow/spring.hpp"

namespace ndframe
{

/// Force and moment over a length, about a point.
using Wrench = ForceMoment;

/// (F, M / fromLength) about one point as (F, M' / toLength) about another.
Wrench movedWrench(const Wrench& wrench, const Direction& from, double fromLength, const Direction& to,
                   double toLength);
/// The same of every column.
DenseMatrix movedWrenches(const DenseMatrix& wrenches, const Direction& from, double fromLength, const Direction& to,
                          double toLength);

} // namespace ndframe
