#include "ndframe/condensation/roles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "odd_ring.hpp"

namespace ndframe
{
namespace
{

/// Other roles must need less than this part of the sweeps: estimates that agree leave the deck's roles.
constexpr double clearly = 0.9;

/// Makes the Neumann body of an interface the Dirichlet body: what is seen along n_c is seen from the other side.
void exchange(InterfaceMesh& interface)
{
  interface.dirichletSide = 1 - interface.dirichletSide;
  const auto turn = [](Direction& normal) {
    for (double& component : normal)
      component = -component;
  };
  for (auto* normals : {&interface.normals, &interface.facetNormals})
    std::for_each(normals->begin(), normals->end(), turn);
  for (auto& ends : interface.endNormals)
    std::for_each(ends.begin(), ends.end(), turn);
}

/// The same for a body that is already condensed: S stays.
void exchange(BodyTrace& trace)
{
  for (ContactRole& role : trace.roles)
    role = facing(role);
  NDFRAME_ASSERT(trace.dependents.empty(), "roles are for bodies without them");
  trace.g.negate();
  for (int i = 0; i < trace.freeMotions.rows() * trace.freeMotions.cols(); ++i)
    trace.freeMotions.data()[i] *= -1.0;
  trace.map.exchange();
}

void exchange(Model& model, CondensedModel& condensed, const std::vector<int>& bodies)
{
  const auto isOne = [&](int body) { return std::binary_search(bodies.begin(), bodies.end(), body); };
  for (auto& interface : model.interfaces)
    if (isOne(interface.dirichlet().body))
      exchange(interface);
  for (auto& trace : condensed.interface.bodies)
    if (isOne(trace.body))
      exchange(trace);
}

/// Where a body is free and supports hold the other one: the interface and its node.
struct Obstacle
{
  const InterfaceMesh* interface;
  int node, held;
};

std::optional<Obstacle> obstacleOf(const Model& model, int body)
{
  for (const auto& interface : model.interfaces)
    if (interface.dirichlet().body == body || interface.neumann().body == body)
      for (int i = 0; i < interface.numNodes(); ++i) {
        const auto sides = model.sidesAt(interface, i);
        const auto& [own, other] =
            sides[0].body == body ? std::pair(sides[0], sides[1]) : std::pair(sides[1], sides[0]);
        if (own.isFree && !other.isFree)
          return Obstacle{&interface, i, other.body};
      }
  return std::nullopt;
}

/// One role a body, none as long as it is not known.
class RoleMap
{
public:
  explicit RoleMap(const Model& model) : interfaces_(model.interfaces), role_(model.bodies.size())
  {
    for (const auto& interface : interfaces_) {
      if (role(interface.dirichlet().body) || role(interface.neumann().body))
        continue;
      const Roles before = role_;
      role(interface.dirichlet().body) = ContactRole::Dirichlet;
      spread();
      turnForObstacles(model, before);
    }
  }
  bool isDirichlet(int body) const { return role_[std::size_t(body)] == ContactRole::Dirichlet; }

private:
  using Roles = std::vector<std::optional<ContactRole>>;

  /// Exchanges the roles that are new since `before` if one of the new Neumann bodies meets an obstacle.
  void turnForObstacles(const Model& model, const Roles& before)
  {
    bool turns = false;
    for (std::size_t b = 0; b < role_.size(); ++b)
      turns = turns || (!before[b] && role_[b] == ContactRole::Neumann && obstacleOf(model, int(b)));
    for (std::size_t b = 0; turns && b < role_.size(); ++b)
      if (!before[b] && role_[b])
        role_[b] = facing(*role_[b]);
  }

  std::optional<ContactRole>& role(int body) { return role_[std::size_t(body)]; }

  /// Gives the neighbours of bodies with a role the other one.
  void spread()
  {
    for (bool changes = true; changes;) {
      changes = false;
      for (const auto& interface : interfaces_)
        for (const auto& [known, other] : {std::pair(interface.dirichlet().body, interface.neumann().body),
                                           std::pair(interface.neumann().body, interface.dirichlet().body)})
          if (role(known) && !role(other)) {
            role(other) = facing(*role(known));
            changes = true;
          }
    }
  }

  const std::vector<InterfaceMesh>& interfaces_;
  Roles role_; ///< per body; none for those that touch nothing
};

/// What decides between two roles: the factor of the error in a sweep.
double factorOf(const RoleSpectrum& spectrum, std::optional<double> givenTheta)
{
  return givenTheta ? spectrum.contraction(*givenTheta) : spectrum.contraction();
}

/// Factors of 1 and more never end; below it sweeps go by their logarithms.
bool isClearlyBetter(double factor, double other)
{
  return other < 1.0 && factor < 1.0 ? std::log(factor) > clearly * std::log(other) : other < clearly * factor;
}

RoleSummary summarize(const Model& model, const std::vector<int>& bodies)
{
  RoleSummary summary;
  for (const auto& interface : model.interfaces)
    if (std::binary_search(bodies.begin(), bodies.end(), interface.dirichlet().body)) {
      summary.dirichletBodies.push_back(model.bodies[std::size_t(interface.dirichlet().body)].name);
      summary.neumannBodies.push_back(model.bodies[std::size_t(interface.neumann().body)].name);
    }
  for (auto* names : {&summary.dirichletBodies, &summary.neumannBodies}) {
    std::sort(names->begin(), names->end());
    names->erase(std::unique(names->begin(), names->end()), names->end());
  }
  return summary;
}

} // namespace

void giveOneRole(Model& model, const SceneSettings& scene, bool needsRoles, Diagnostics& diagnostics)
{
  const RoleMap roles(model);
  if (const std::string ring = oddRing(model); !ring.empty()) {
    if (needsRoles)
      diagnostics.add(scene.interfacesPlace.mistake("", ring));
    return;
  }
  for (auto& interface : model.interfaces)
    if (!roles.isDirichlet(interface.dirichlet().body)) {
      exchange(interface);
      model.recipe.interfaces += "; exchanged: " + interface.name;
    }
}

void refuseObstacles(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics)
{
  for (const auto& interface : model.interfaces)
    if (const auto obstacle = obstacleOf(model, interface.neumann().body)) {
      const BodyModel &body = model.bodies[std::size_t(interface.neumann().body)],
                      &held = model.bodies[std::size_t(obstacle->held)];
      diagnostics.add(
          scene.interface(obstacle->interface->name)
              .place.mistake(
                  "", fmt::format("supports hold \"{}\" at {}, and \"{}\" may touch it there: Neumann-Dirichlet "
                                  "solves such a body only as Dirichlet body. Exchange the roles, or use "
                                  "Coupling/Type = Monolithic.",
                                  held.name, pointText(obstacle->interface->point(obstacle->node), body.mesh.dim),
                                  body.name)));
      return;
    }
}

void refuseSharedNodes(const Model& model, const InterfaceSystem& system, const ListPlace& coupling)
{
  const auto refuse = [&](const std::string& reason) { throw InputError(coupling.mistake("Type", reason)); };
  if (system.mortar)
    refuse("Neumann-Dirichlet does not ask for contact in means, as Pairing/Type = Mortar wants; use Monolithic, FETI "
           "or Neumann-Neumann.");
  for (const BodyTrace& body : system.bodies)
    if (!body.dependents.empty())
      refuse("several interfaces of \"" + model.bodies[std::size_t(body.body)].name +
             "\" meet at a node, which Neumann-Dirichlet cannot solve; use Monolithic or FETI.");
}

ChosenRoles chooseRoles(Model& model, CondensedModel& condensed, const std::vector<ConnectedBodies>& parts,
                        std::optional<double> givenTheta, const std::vector<RoleSummary>& before)
{
  std::vector<int>& all = condensed.exchanged;
  std::vector<ConnectedBodies> chosen = parts;
  std::vector<RoleSummary> summaries;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const RoleSpectrum given = parts[k].spectrum, other = given.exchanged();
    const double factor = factorOf(given, givenTheta), otherFactor = factorOf(other, givenTheta);
    const bool mayExchange = std::none_of(parts[k].bodies.begin(), parts[k].bodies.end(),
                                          [&](int body) { return obstacleOf(model, body).has_value(); });
    const bool exchanged = given.isKnown() && mayExchange && isClearlyBetter(factor, otherFactor);
    if (exchanged) {
      chosen[k].spectrum = other;
      exchange(model, condensed, parts[k].bodies);
      all.insert(all.end(), parts[k].bodies.begin(), parts[k].bodies.end());
    }
    RoleSummary summary = summarize(model, parts[k].bodies);
    summary.exchanged = exchanged != (!before.empty() && before[k].exchanged);
    summary.contraction = exchanged ? otherFactor : factor;
    if (mayExchange)
      summary.contractionExchanged = exchanged ? factor : otherFactor;
    summary.bestTheta = chosen[k].spectrum.bestTheta();
    summary.theta = givenTheta.value_or(summary.bestTheta);
    summaries.push_back(std::move(summary));
  }
  std::sort(all.begin(), all.end());
  return {joinedSpectrum(chosen), std::move(summaries)};
}

void giveBackRoles(Model& model, CondensedModel& condensed)
{
  exchange(model, condensed, std::exchange(condensed.exchanged, {}));
}

void orientLike(Model& model, const std::vector<InterfaceMesh>& others)
{
  for (std::size_t i = 0; i < model.interfaces.size(); ++i)
    if (model.interfaces[i].dirichlet().body != others[i].dirichlet().body)
      exchange(model.interfaces[i]);
}

} // namespace ndframe
