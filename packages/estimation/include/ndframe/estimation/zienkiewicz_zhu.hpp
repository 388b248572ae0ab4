#pragma once

#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// Zienkiewicz and Zhu (1992), superconvergent patch recovery: squared contributions of the cells to
///
///   eta^2 = int (sigma* - sigma_h) : C^-1 (sigma* - sigma_h),   sigma* = sum over vertices a of phi_a p_a,
///
/// p_a the polynomials of the displacements' degree nearest (least squares) to sigma_h at sample points of the cells
/// around vertex a (the centroids; for order 2 dim + 1 points in each cell), where sigma_h is more right than
/// elsewhere. Cells further out are added where those are too few.
///
/// An energy. NOT a bound, it may lie below the error: it sees neither loads nor contact, only how rough the stress is.
/// displacement: u_h, numNodes * dim, global axes.
CellValues zienkiewiczZhu(const BodyModel& body, const Vector& displacement);

} // namespace ndframe
