#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ndframe/condensation/condensed_model.hpp"
#include "ndframe/coupling/coupling.hpp"

namespace ndframe
{

/// `Dirichlet Body` = `Automatic`: who is Dirichlet body is not the deck's business but found out.

/// Turns interfaces of a model that was just built so that every body has one role, the first interface of each
/// connected part as the deck says, or the other way round where a body must be Dirichlet body (refuseObstacles).
/// Bodies that touch in a ring of odd length have no such roles: a mistake if the coupling needs them, else nothing is
/// turned.
void giveOneRole(Model& model, const SceneSettings& scene, bool needsRoles, Diagnostics& diagnostics);

/// Refuses Neumann bodies at nodes where supports hold the other body: their problem has no contact conditions.
void refuseObstacles(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics);

/// Refuses what sweeps cannot solve: nodes of a body that several interfaces share, which has one displacement there
/// for more tractions than roles can tell apart, and contact in means, which are of many nodes. InputError.
void refuseSharedNodes(const Model& model, const InterfaceSystem& system, const ListPlace& coupling);

/// Roles that were chosen for bodies that touch, directly or through others (Dirichlet Body = Automatic).
struct RoleSummary
{
  std::vector<std::string> dirichletBodies, /**< names, sorted, of this connected part */ neumannBodies; ///< the others
  bool exchanged = false;                     ///< against the deck
  double contraction = 0.0;                   ///< of the traction's error in a sweep with `theta`
  double theta = 0.0;                         ///< relaxation factor: the deck's, or the best
  double bestTheta = 0.0;                     ///< with which the contraction is smallest
  std::optional<double> contractionExchanged; ///< with the other roles; none where supports leave no choice
};

/// The roles that were chosen.
struct ChosenRoles
{
  RoleSpectrum spectrum;          ///< the eigenvalues for them
  std::vector<RoleSummary> parts; ///< per connected part
};

/// Exchanges the roles of the bodies in each connected part of the condensed scene where the iteration then contracts
/// clearly better with the theta that it uses. before: roles of an earlier mesh, like which the scene is oriented; may
/// be empty. No factorisation: the stiffness on the interface stays, what is counted along n_c changes its sign.
ChosenRoles chooseRoles(Model& model, CondensedModel& condensed, const std::vector<ConnectedBodies>& parts,
                        std::optional<double> givenTheta, const std::vector<RoleSummary>& before);

/// Undoes what chooseRoles exchanged: the scene is again as it was condensed.
void giveBackRoles(Model& model, CondensedModel& condensed);

/// Turns the interfaces of a model that was just built as those of another model of the same deck.
void orientLike(Model& model, const std::vector<InterfaceMesh>& others);

} // namespace ndframe
