#pragma once

#include "ndframe/algebra/rank_problem.hpp"
#include "ndframe/condensation/condensed_model.hpp"

namespace ndframe
{

/// What a solver needs to know of a body that no rank has as a whole; points to the system's matrix.
RankProblem shareProblem(const Model& model, int body, const BodySystem& system);

} // namespace ndframe
