#pragma once

#include "ndframe/algebra/dense.hpp"

namespace ndframe
{

/// The order + 1 nodal functions of an edge: its two ends, then (order 2) its middle.
void edgeFunctions(int order, const double* lambda, double* N);

/// Their moments 1/|f| int N_i L_k dS, nodes x modes, with the basis of tractions of this degree.
DenseMatrix edgeMoments(int order, int degree);

} // namespace ndframe
