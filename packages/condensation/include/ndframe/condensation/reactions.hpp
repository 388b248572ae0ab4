#pragma once

#include <string>
#include <vector>

#include "ndframe/condensation/solution.hpp"
#include "ndframe/scene/moment.hpp"

namespace ndframe
{

/// What one support does to its body. In the plane forces are per unit thickness.
struct SupportSummary
{
  /// Of its list in the deck, and in words.
  std::string name, description; ///< "ground", "clamp at bottom"
  std::vector<double> force;     ///< resultant
  std::vector<double> moment;    ///< about the centre of its side: about z in the plane, about x, y, z in space
  std::vector<double> centre;    ///< of its side, or the mean of the nodes that it holds; dim coordinates
};

/// What the supports of a body do to it in one state: nodal forces in global axes (numNodes * dim), zero where nothing
/// is prescribed. With loads and contact forces they balance every body, moments too, to the round-off of K u.
/// fields: of the body and that state.
NodalField supportForces(const Model& model, const CondensedModel& condensed, const InterfaceState& state, int body,
                         const BodyFields& fields);

/// The contact forces on the nodes of a body, global axes: C Lambda along n_c on the Dirichlet body, against it on the
/// Neumann body (of the traction that each was solved with).
NodalField contactForces(const Model& model, const CondensedModel& condensed, const InterfaceState& state, int body);

/// Resultant and moment of every support of a body. Where several supports hold a node each gets the part of the force
/// along its own directions; directions that two of them hold are shared equally. forces: of supportForces. Collective
/// where the body is shared out.
std::vector<SupportSummary> supportReactions(const BodyModel& body, const Vector& forces, const Comm& comm);

} // namespace ndframe
