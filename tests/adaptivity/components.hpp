#pragma once

#include "ndframe/adaptivity/marking.hpp"
#include "ndframe/adaptivity/refinement.hpp"

namespace ndframe::test
{

/// With the parameters that a deck gets that only names it.
std::unique_ptr<Marking> makeMarking(const std::string& type);

/// The mesh, to be bisected.
std::unique_ptr<RefinedMeshes> bisected(const Mesh& mesh);

} // namespace ndframe::test
