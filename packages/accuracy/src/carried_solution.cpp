#include "carried_solution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ndframe/fem/lagrange.hpp"
#include "ndframe/mesh/cells_of_points.hpp"
#include "places.hpp"

namespace ndframe
{
namespace
{

using Point = std::array<double, 3>;

/// A point near a cell by its barycentric coordinates there.
template <int dim>
PointInCell placeIn(const NodeMap& nodes, int cell, const Point& x)
{
  double points[(dim + 1) * dim], gradients[(dim + 1) * dim];
  for (int v = 0; v <= dim; ++v)
    std::copy_n(nodes.point(nodes.cell(cell)[v]).data(), dim, points + v * dim);
  barycentricGradients<dim>(points, gradients);
  PointInCell place{cell, {1.0}};
  for (int v = 0; v <= dim; ++v)
    for (int k = 0; k < dim; ++k)
      place.lambda[std::size_t(v)] += gradients[v * dim + k] * (x[std::size_t(k)] - points[k]);
  return place;
}

/// In the one of some cells that it is least outside of.
template <int dim>
PointInCell nearestPlace(const NodeMap& nodes, const std::vector<int>& cells, const Point& x)
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

} // namespace

CarriedSolution::CarriedSolution(const Run& run)
{
  if (run.solved.fields.size() != run.model.bodies.size())
    return;
  std::vector<Vector> values;
  for (const int number : run.model.elasticBodies()) {
    const auto b = std::size_t(number);
    values.emplace_back(run.condensed.systems[b].dofs.frames.toGlobal(run.solved.fields[b].u.back()).whole());
  }
  *this = CarriedSolution(run.model, std::move(values));
}

CarriedSolution::CarriedSolution(const Model& model, std::vector<Vector> values)
{
  std::size_t next = 0;
  for (const int b : model.elasticBodies()) {
    const BodyModel& body = model.bodies[std::size_t(b)];
    if (next == values.size() || int(values[next].size()) != body.numDofs())
      throw InputError("The displacements to go on from are those of other meshes.");
    Body carried{body.nodes, {}, std::move(values[next++])};
    carried.parts.resize(body.parents.empty() ? 0 : std::size_t(body.base.numCells()));
    for (std::size_t cell = 0; cell < body.parents.size(); ++cell)
      carried.parts[std::size_t(body.parents[cell])].push_back(int(cell));
    bodies_.push_back(std::move(carried));
  }
}

std::vector<Vector> CarriedSolution::values() const
{
  std::vector<Vector> values;
  for (const Body& body : bodies_)
    values.push_back(body.values);
  return values;
}

Vector CarriedSolution::Body::at(const BodyModel& body, const std::vector<int>& ancestors) const
{
  const auto dim = std::size_t(body.nodes.dim);
  Vector result(std::size_t(body.numDofs()), 0.0);
  std::vector<char> isKnown(std::size_t(body.nodes.numNodes()), 0);
  for (int cell = 0; cell < body.mesh.numCells(); ++cell) {
    const int ancestor = ancestors[std::size_t(body.parents.empty() ? cell : body.parents[std::size_t(cell)])];
    const std::vector<int> itself{ancestor}, &candidates = parts.empty() ? itself : parts[std::size_t(ancestor)];
    for (int a = 0; a < body.nodes.nodesPerCell; ++a) {
      const auto node = std::size_t(body.nodes.cell(cell)[a]);
      if (std::exchange(isKnown[node], char(1)))
        continue;
      withDimAndOrder(body.nodes.dim, body.nodes.order, [&](auto d, auto p) {
        const PointInCell place = nearestPlace<d()>(nodes, candidates, body.nodes.point(int(node)));
        addValues<d(), p()>(nodes, place, values, result.data() + node * dim);
      });
    }
  }
  return result;
}

std::vector<NodalField> CarriedSolution::onto(const Run& run, const std::vector<std::vector<int>>& ancestors) const
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
    Vector u = dofs.frames.toLocal(bodies_[place].at(run.model.bodies[b], ancestors[place])).whole();
    dofs.addPrescribed(u, -1.0);
    fields.push_back(atNodes(std::move(u), run.model.bodies[b].nodes.dim));
  }
  return fields;
}

} // namespace ndframe
