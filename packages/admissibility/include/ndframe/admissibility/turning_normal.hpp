#pragma once

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// Tables for patches along which n_c turns, n = sum_e n_e lambda_e; one for each vertex e, all means over the patch.
/// dim: of space.
using EndTables = std::vector<DenseMatrix>;

/// lambda_e N_i L_k of the nodal functions: nodes x modes.
EndTables turningMoments(int dim, int order, int degree);

/// lambda_e L_k L_j: the moments of lambda_e t up to degree `fine` by those of t up to `degree`.
EndTables turningModes(int dim, int degree, int fine);

/// Moments of t n by those of t, mode by mode, `dim` components; forces.
Vector turned(const EndTables& modes, const ContactPatch& patch, const Vector& moments);

/// Adds a change of a patch's t (its moments) to what the share of one vertex carries of t n.
void addTurned(const EndTables& modes, const std::vector<ContactPatch>& patches, std::size_t patch, int vertex,
               const Vector& change, ContactTraction& traction);

/// ContactTraction::vectors of a traction given at the interface nodes; empty where nothing turns. Order 1: the force
/// int lambda_a t n acts at a, order 2: the projection of lambda_a t n.
Vector turnedShares(const std::vector<ContactPatch>& patches, const Vector& nodal, int order, int degree);

} // namespace ndframe
