#pragma once

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// Tables for edges, the patches of the plane, along which n_c turns, n = sum_e n_e lambda_e; one for each end e, all
/// means over an edge.
using EndTables = std::array<DenseMatrix, 2>;

/// lambda_e N_i L_k of the nodal functions: (order + 1) x (degree + 1).
EndTables turningEdgeMoments(int order, int degree);

/// lambda_e L_k L_j: the moments k <= `fine` of lambda_e t by the moments j <= `degree` of t.
EndTables turningModes(int degree, int fine);

/// Moments of t n by those of t, mode by mode, two components: (fine + 1) * 2 values; forces.
Vector turned(const EndTables& modes, const ContactPatch& patch, const Vector& moments);

/// Adds a change of a patch's t (its moments) to what the share of one vertex carries of t n.
void addTurned(const EndTables& modes, const std::vector<ContactPatch>& patches, std::size_t patch, int vertex,
               const Vector& change, ContactTraction& traction);

/// ContactTraction::vectors of a traction given at the interface nodes; empty where nothing turns. Order 1: the force
/// int lambda_a t n acts at a, order 2: the projection of lambda_a t n.
Vector turnedShares(const std::vector<ContactPatch>& patches, const Vector& nodal, int order, int degree);

} // namespace ndframe
