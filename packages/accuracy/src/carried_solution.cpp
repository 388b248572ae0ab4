#include "carried_solution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "ndframe/algebra/exchanged_values.hpp"
#include "ndframe/algebra/ghosts.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/mesh/cells_of_points.hpp"
#include "places.hpp"

namespace ndframe
{
namespace
{

/// A point near a cell by its barycentric coordinates there.
template <int dim>
PointInCell placeIn(const NodeMap& nodes, int cell, const double* x)
{
  double points[(dim + 1) * dim], gradients[(dim + 1) * dim];
  for (int v = 0; v <= dim; ++v)
    std::copy_n(nodes.point(nodes.cell(cell)[v]).data(), dim, points + v * dim);
  barycentricGradients<dim>(points, gradients);
  PointInCell place{cell, {1.0}};
  for (int v = 0; v <= dim; ++v)
    for (int k = 0; k < dim; ++k)
      place.lambda[std::size_t(v)] += gradients[v * dim + k] * (x[k] - points[k]);
  return place;
}

/// In the one of some cells that it is least outside of.
template <int dim>
PointInCell nearestPlace(const NodeMap& nodes, const std::vector<int>& cells, const double* x)
{
  PointInCell nearest;
  double inside = -HUGE_VAL;
  for (const int cell : cells) {
    const PointInCell place = placeIn<dim>(nodes, cell, x);
    const double least = *std::min_element(place.lambda.begin(), place.lambda.begin() + dim + 1);
    if (least > inside) {
      inside = least;
      nearest = place;
    }
  }
  return nearest;
}

template <int dim, int order>
void addValues(const NodeMap& nodes, const PointInCell& place, const Vector& values, double* sum)
{
  double N[Lagrange<dim, order>::nodes];
  Lagrange<dim, order>::values(place.lambda.data(), N);
  for (int a = 0; a < Lagrange<dim, order>::nodes; ++a)
    for (int k = 0; k < dim; ++k)
      sum[k] += N[a] * values[std::size_t(nodes.cell(place.cell)[a]) * dim + std::size_t(k)];
}

using Global = BodyShare::Global;

/// A rank's cells by ascending numbers in the whole body, own ones only or all.
std::vector<int> inOrder(const BodyShare& share, std::size_t count)
{
  const std::vector<Global>& numbers = share.cells().numbers;
  std::vector<int> cells(count);
  std::iota(cells.begin(), cells.end(), 0);
  std::sort(cells.begin(), cells.end(),
            [&](int a, int b) { return numbers[std::size_t(a)] < numbers[std::size_t(b)]; });
  return cells;
}

std::vector<Global> numbersOf(const std::vector<int>& cells, const BodyShare& share)
{
  std::vector<Global> numbers;
  for (const int cell : cells)
    numbers.push_back(share.cells().numbers[std::size_t(cell)]);
  return numbers;
}

/// The nodes of a body whose values this rank finds, each with an uncut cell of the whole body that it belongs to: the
/// first one, whatever the shares are.
struct Wanted
{
  std::vector<int> nodes;
  std::vector<Global> cells;
};

Wanted wantedOf(const BodyModel& body)
{
  NDFRAME_ASSERT(!body.share || body.parents.empty(), "cells of shares are whole");
  Wanted wanted;
  std::vector<char> isKnown(std::size_t(body.nodes.numNodes()), 0);
  const auto add = [&](int cell, Global uncut) {
    for (int a = 0; a < body.nodes.nodesPerCell; ++a) {
      const int node = body.nodes.cell(cell)[a];
      if (std::exchange(isKnown[std::size_t(node)], char(1)) || (body.share && !body.share->owns(node)))
        continue;
      wanted.nodes.push_back(node);
      wanted.cells.push_back(uncut);
    }
  };
  if (body.share)
    for (const int cell : inOrder(*body.share, body.share->cells().numbers.size()))
      add(cell, body.share->cells().numbers[std::size_t(cell)]);
  else
    for (int cell = 0; cell < body.mesh.numCells(); ++cell)
      add(cell, body.parents.empty() ? cell : body.parents[std::size_t(cell)]);
  return wanted;
}

} // namespace

CarriedSolution::CarriedSolution(const Run& run)
{
  if (run.solved.fields.size() != run.model.bodies.size())
    return;
  for (const int number : run.model.elasticBodies()) {
    const auto b = std::size_t(number);
    add(run.model.bodies[b], run.condensed.systems[b].dofs.frames.toGlobal(run.solved.fields[b].u.back()).whole());
  }
}

void CarriedSolution::add(const BodyModel& body, Vector values)
{
  Body carried{body.nodes, {}, std::move(values), body.share};
  carried.parts.resize(body.parents.empty() ? 0 : std::size_t(body.base.numCells()));
  for (std::size_t cell = 0; cell < body.parents.size(); ++cell)
    carried.parts[std::size_t(body.parents[cell])].push_back(int(cell));
  bodies_.push_back(std::move(carried));
}

Vector CarriedSolution::Body::at(const std::vector<int>& cells, const Vector& points) const
{
  const auto dim = std::size_t(nodes.dim);
  Vector result(points.size(), 0.0);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::vector<int> itself{cells[i]}, &candidates = parts.empty() ? itself : parts[std::size_t(cells[i])];
    withDimAndOrder(nodes.dim, nodes.order, [&](auto d, auto p) {
      const PointInCell place = nearestPlace<d()>(nodes, candidates, points.data() + i * dim);
      addValues<d(), p()>(nodes, place, values, result.data() + i * dim);
    });
  }
  return result;
}

Vector CarriedSolution::Body::at(const std::vector<Global>& cells, const Vector& points, const Comm& comm) const
{
  if (!share)
    return at({cells.begin(), cells.end()}, points);
  const std::vector<int> own = inOrder(*share, std::size_t(share->numOwnCells()));
  const IndexMap map(share->numCells(), numbersOf(own, *share));
  const std::vector<int> owners = ownersOf(cells, map, comm);
  const auto dim = std::size_t(nodes.dim);
  std::vector<Vector> asked(std::size_t(comm.size()));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Vector& message = asked[std::size_t(owners[i])];
    const double* const point = points.data() + i * dim;
    message.push_back(double(cells[i]));
    message.insert(message.end(), point, point + dim);
  }
  std::vector<Vector> answers;
  for (const Vector& questions : exchangedValues(asked, comm)) {
    std::vector<int> here;
    Vector places;
    for (std::size_t next = 0; next < questions.size(); next += dim + 1) {
      const double* const question = questions.data() + next;
      here.push_back(own[std::size_t(map.local(Global(question[0])))]);
      places.insert(places.end(), question + 1, question + 1 + dim);
    }
    answers.push_back(at(here, places));
  }
  answers = exchangedValues(answers, comm);
  Vector result;
  std::vector<const double*> next;
  for (const Vector& answer : answers)
    next.push_back(answer.data());
  for (const int owner : owners) {
    const double*& value = next[std::size_t(owner)];
    result.insert(result.end(), value, value + dim);
    value += dim;
  }
  return result;
}

Vector CarriedSolution::Body::at(const BodyModel& body, const std::vector<int>& ancestors, const Comm& comm) const
{
  Wanted wanted = wantedOf(body);
  for (Global& cell : wanted.cells)
    cell = ancestors[std::size_t(cell)];
  const auto dim = std::size_t(body.nodes.dim);
  Vector points;
  for (const int node : wanted.nodes) {
    const auto point = body.nodes.point(node);
    points.insert(points.end(), point.begin(), point.begin() + std::ptrdiff_t(dim));
  }
  const Vector found = at(wanted.cells, points, comm);
  Vector result(std::size_t(body.numDofs()), 0.0);
  for (std::size_t i = 0; i < wanted.nodes.size(); ++i)
    std::copy_n(found.data() + i * dim, dim, result.data() + std::size_t(wanted.nodes[i]) * dim);
  if (body.share)
    body.share->fetch(result, int(dim));
  return result;
}

std::vector<NodalField> CarriedSolution::onto(const Run& run, const std::vector<std::vector<int>>& ancestors,
                                              const Comm& comm) const
{
  const auto& traces = run.condensed.interface.bodies;
  const bool areWhole =
      std::all_of(traces.begin(), traces.end(), [](const BodyTrace& trace) { return trace.isSolvedWhole(); });
  std::vector<NodalField> fields;
  if (bodies_.empty() || !areWhole)
    return fields;
  const std::vector<int> places = placesOf(run.model);
  for (const BodyTrace& trace : traces) {
    const auto b = std::size_t(trace.body);
    if (places[b] < 0)
      return {};
    const auto place = std::size_t(places[b]);
    const DofLayout& dofs = run.condensed.systems[b].dofs;
    Vector u = dofs.frames.toLocal(bodies_[place].at(run.model.bodies[b], ancestors[place], comm)).whole();
    dofs.addPrescribed(u, -1.0);
    fields.push_back(atNodes(std::move(u), run.model.bodies[b].nodes.dim));
  }
  return fields;
}

} // namespace ndframe
