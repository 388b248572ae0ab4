#include "ndframe/scene/rigid_check.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "mean_motions.hpp"
#include "ndframe/interface/body_trace.hpp"

namespace ndframe
{
namespace
{

constexpr double sameNormal = 1e-12;
constexpr double noEntry = 1e-12;    ///< of motions of 1
constexpr double atRest = 1e-6;      ///< a body that moves by less, the largest motion being 1
constexpr double turnsLast = 10.0;   ///< how much rather a translation is told than a rotation
constexpr std::size_t mostNamed = 8; ///< bodies in one sentence

/// First motion of every body, and the number of all.
std::vector<int> firstMotions(const Model& model)
{
  std::vector<int> first{0};
  for (const DenseMatrix& free : model.freeMotions)
    first.push_back(first.back() + free.cols());
  return first;
}

bool sameDirection(const Direction& a, const Direction& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return std::abs(x - y) <= sameNormal; });
}

/// Coordinate along a side in the plane.
double station(const InterfaceMesh& interface, int node)
{
  const Direction& n = interface.normals[std::size_t(node)];
  return n[0] * interface.point(node)[1] - n[1] * interface.point(node)[0];
}

/// The nodes that carry contact; in the plane only the outermost of those with one normal.
std::vector<int> decisiveNodes(const Model& model, const InterfaceMesh& interface)
{
  std::vector<int> nodes;
  for (int i = 0; i < interface.numNodes(); ++i)
    if (model.carriesContact(interface, i))
      nodes.push_back(i);
  if (interface.dim == 3)
    return nodes;
  std::vector<std::array<int, 2>> ends;
  for (const int node : nodes) {
    const auto known = std::find_if(ends.begin(), ends.end(), [&](const auto& pair) {
      return sameDirection(interface.normals[std::size_t(pair[0])], interface.normals[std::size_t(node)]);
    });
    if (known == ends.end())
      ends.push_back({node, node});
    else if (station(interface, node) < station(interface, (*known)[0]))
      (*known)[0] = node;
    else if (station(interface, node) > station(interface, (*known)[1]))
      (*known)[1] = node;
  }
  nodes.clear();
  for (const auto& [first, last] : ends) {
    nodes.push_back(first);
    if (last != first)
      nodes.push_back(last);
  }
  return nodes;
}

void addInterface(RigidNetwork& network, const Model& model, const InterfaceMesh& interface,
                  const std::vector<int>& firstMotion)
{
  const auto freeMotions = [&](ContactRole role) -> const DenseMatrix& {
    return model.freeMotions[std::size_t(interface.side(role).body)];
  };
  if (interface.touchesItself() ||
      freeMotions(ContactRole::Dirichlet).cols() + freeMotions(ContactRole::Neumann).cols() == 0)
    return;
  const std::vector<int> nodes = decisiveNodes(model, interface);
  std::vector<Direction> normals;
  for (const int node : nodes)
    normals.push_back(interface.normals[std::size_t(node)]);
  const std::size_t first = network.approach.size();
  network.approach.resize(first + nodes.size());
  for (const ContactRole role : bothRoles) {
    const auto b = std::size_t(interface.side(role).body);
    std::vector<const double*> points;
    for (const int node : nodes)
      points.push_back(interface.pointOf(role, node));
    const DenseMatrix traces = motionTraces(model.rigid[b], freeMotions(role), points, normals);
    for (int i = 0; i < traces.rows(); ++i)
      for (int j = 0; j < traces.cols(); ++j)
        if (std::abs(traces(i, j)) > noEntry)
          network.approach[first + std::size_t(i)].emplace_back(firstMotion[b] + j, signOf(role) * traces(i, j));
  }
}

/// The work of a body's loads on its free motions, and how they are told.
void addMotions(RigidNetwork& network, const Model& model, std::size_t b)
{
  const BodyModel& body = model.bodies[b];
  for (int j = 0; j < model.freeMotions[b].cols(); ++j) {
    const Vector motion = model.freeMotions[b].column(j);
    double work = 0.0, magnitude = 0.0;
    model.loads[b].each([&](IndexMap::Global node, const double* values) {
      const Direction u = displacementOf(model.rigid[b], motion, body.nodes.point(int(node)).data());
      Direction force{};
      std::copy_n(values, body.nodes.dim, force.begin());
      work += dotProduct(force, u);
      magnitude += std::sqrt(dotProduct(force, force) * dotProduct(u, u));
    });
    const ForcesInside inside = model.inside[b].value_or(ForcesInside());
    for (std::size_t mode = 0; mode < inside.work.size(); ++mode) {
      work += motion[mode] * inside.work[mode];
      magnitude += std::abs(motion[mode]) * inside.magnitude[mode];
    }
    network.work.push_back(work);
    network.magnitude.push_back(magnitude);
    const double turning = std::accumulate(motion.begin() + body.nodes.dim, motion.end(), 0.0,
                                           [](double sum, double value) { return sum + std::abs(value); });
    network.reluctance.push_back(1.0 + turnsLast * turning);
  }
}

} // namespace

RigidNetwork rigidNetwork(const Model& model)
{
  RigidNetwork network;
  const std::vector<int> firstMotion = firstMotions(model);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    addMotions(network, model, b);
  for (const auto& interface : model.interfaces)
    addInterface(network, model, interface, firstMotion);
  return network;
}

std::string motionText(const Model& model, const Vector& motion)
{
  const std::vector<int> first = firstMotions(model);
  std::vector<std::string> moving;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Vector own(motion.begin() + first[b], motion.begin() + first[b + 1]);
    if (largestEntry(own) > atRest)
      moving.push_back(fmt::format("{} {}", model.bodies[b].name,
                                   describeMotion(model.rigid[b], multiply(model.freeMotions[b], own))));
  }
  if (moving.size() > mostNamed) {
    const std::size_t others = moving.size() - mostNamed;
    moving.resize(mostNamed);
    moving.push_back(fmt::format("and {} more", others));
  }
  return fmt::format("{}", fmt::join(moving, ", "));
}

void refusePulledOff(const Model& model)
{
  if (model.told && !model.told->pulledOff.empty())
    throw NotConverged(model.told->pulledOff);
  if (model.told)
    return;
  const Vector motion = pulledOff(rigidNetwork(model));
  if (!motion.empty())
    throw NotConverged("the load does not press the bodies together: it pulls off " + motionText(model, motion));
}

void findLooseBodies(const Model& model, const SceneSettings& scene, Diagnostics& found)
{
  const Vector motion = loose(rigidNetwork(model));
  if (!motion.empty())
    found.add(scene.interfacesPlace.mistake(
        "", fmt::format("the displacement is not unique: {}. Nothing but contact holds that, and no "
                        "load presses it; strains, forces and the bound do not depend on it.",
                        motionText(model, motion))));
}

} // namespace ndframe
