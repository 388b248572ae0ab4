#include "ndframe/accuracy/level_lesson.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/run/contact_ends.hpp"
#include "places.hpp"

namespace ndframe
{
namespace
{

/// Contributions of the cells of the uncut mesh.
Vector uncutContributions(const BodyModel& body, const CellValues& eta)
{
  if (body.parents.empty())
    return eta;
  Vector squares(std::size_t(body.base.numCells()), 0.0);
  for (std::size_t cell = 0; cell < eta.size(); ++cell)
    squares[std::size_t(body.parents[cell])] += eta[cell] * eta[cell];
  for (double& square : squares)
    square = std::sqrt(square);
  return squares;
}

/// Contributions of all cells of a body that ranks have shares of, from those of their own cells. Collective.
Vector gatheredContributions(const BodyShare& share, const CellValues& eta, const Comm& comm)
{
  Vector own;
  for (int cell = 0; cell < share.numOwnCells(); ++cell) {
    own.push_back(double(share.cells().numbers[std::size_t(cell)]));
    own.push_back(eta[std::size_t(cell)]);
  }
  const Vector gathered = gatheredFrom(own, comm);
  Vector all(std::size_t(share.numCells()), 0.0);
  for (std::size_t i = 0; i < gathered.size(); i += 2)
    all[std::size_t(gathered[i])] = gathered[i + 1];
  return all;
}

/// The vertices of the uncut mesh that stand for a vertex: itself, or those of the cell that it was cut into.
std::vector<int> uncutVertices(const BodyModel& body, int vertex)
{
  if (body.share)
    return {int(body.share->numbers()[std::size_t(vertex)])};
  if (vertex < body.uncut().numPoints())
    return {vertex};
  const auto found = std::find(body.mesh.cells.begin(), body.mesh.cells.end(), vertex);
  const int corners = body.base.dim + 1;
  const int* cell = body.base.cell(body.parents[std::size_t(found - body.mesh.cells.begin()) / std::size_t(corners)]);
  return {cell, cell + corners};
}

/// Body and vertex.
std::vector<std::array<int, 2>> endsOfContact(const Run& run)
{
  std::vector<std::array<int, 2>> ends;
  const std::vector<int> place = placesOf(run.model);
  const auto add = [&](int body, int node) {
    const BodyModel& model = run.model.bodies[std::size_t(body)];
    if (model.isRigid)
      return;
    for (const int vertex : uncutVertices(model, node))
      ends.push_back({place[std::size_t(body)], vertex});
  };
  std::vector<char> closed;
  for (const ContactNode& node : run.solved.contact)
    closed.push_back(node.closed);
  const char* ofInterface = closed.data();
  for (const InterfaceMesh& interface : run.model.interfaces) {
    for (const int node : endVertices(interface, ofInterface)) {
      add(interface.dirichlet().body, interface.dirichlet().nodes[std::size_t(node)]);
      add(interface.neumann().body, interface.neumann().nodes[std::size_t(node)]);
    }
    ofInterface += interface.numNodes();
  }
  return ends;
}

std::vector<EndOnSide> bracketsOf(const Run& run)
{
  std::vector<EndOnSide> brackets;
  const ContactNode* nodes = run.solved.contact.data();
  for (const InterfaceMesh& interface : run.model.interfaces) {
    const double length = std::accumulate(interface.measures.begin(), interface.measures.end(), 0.0);
    for (EndBracket& bracket : endBrackets(interface, nodes))
      brackets.push_back({std::move(bracket), length});
    nodes += interface.numNodes();
  }
  return brackets;
}

} // namespace

LevelLesson lessonOf(const Run& run, const LevelErrors& errors, const Comm& comm)
{
  LevelLesson lesson;
  lesson.errors = errors;
  for (const int b : run.model.elasticBodies()) {
    const BodyModel& body = run.model.bodies[std::size_t(b)];
    const CellValues& eta = run.certificate->etaGlobal[std::size_t(b)];
    lesson.contributions.push_back(body.share ? gatheredContributions(*body.share, eta, comm)
                                              : uncutContributions(body, eta));
  }
  lesson.ends = endsOfContact(run);
  lesson.brackets = bracketsOf(run);
  return lesson;
}

} // namespace ndframe
