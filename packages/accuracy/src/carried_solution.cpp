#include "carried_solution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ndframe/fem/lagrange.hpp"
#include "places.hpp"

namespace ndframe
{
namespace
{

using Point = std::array<double, 3>;

double determinant(const Point& a, const Point& b, const Point& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Barycentric coordinates in a cell, those of a triangle as of a tetrahedron with a fourth vertex above the plane.
std::array<double, 4> coordinatesIn(const NodeMap& nodes, int cell, const Point& x)
{
  const Point origin = nodes.point(nodes.cell(cell)[0]);
  const auto from = [&](const Point& point) {
    return Point{point[0] - origin[0], point[1] - origin[1], point[2] - origin[2]};
  };
  std::array<Point, 3> edges{};
  edges[2] = {0.0, 0.0, 1.0};
  for (int v = 1; v <= nodes.dim; ++v)
    edges[std::size_t(v) - 1] = from(nodes.point(nodes.cell(cell)[v]));
  const double whole = determinant(edges[0], edges[1], edges[2]);
  std::array<double, 4> lambda{1.0, 0.0, 0.0, 0.0};
  for (std::size_t v = 0; v < std::size_t(nodes.dim); ++v) {
    std::array<Point, 3> replaced = edges;
    replaced[v] = from(x);
    lambda[v + 1] = determinant(replaced[0], replaced[1], replaced[2]) / whole;
    lambda[0] -= lambda[v + 1];
  }
  return lambda;
}

template <int dim, int order>
void addValues(const NodeMap& nodes, int cell, const std::array<double, 4>& lambda, const Vector& values, double* sum)
{
  double N[Lagrange<dim, order>::nodes];
  Lagrange<dim, order>::values(lambda.data(), N);
  for (int a = 0; a < Lagrange<dim, order>::nodes; ++a)
    for (int k = 0; k < dim; ++k)
      sum[k] += N[a] * values[std::size_t(nodes.cell(cell)[a]) * dim + std::size_t(k)];
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
    for (int a = 0; a < body.nodes.nodesPerCell; ++a) {
      const auto node = std::size_t(body.nodes.cell(cell)[a]);
      if (std::exchange(isKnown[node], char(1)))
        continue;
      const Point x = body.nodes.point(int(node));
      std::array<double, 4> lambda{};
      double inside = -HUGE_VAL;
      int best = ancestor;
      const auto look = [&](int part) {
        const auto here = coordinatesIn(nodes, part, x);
        const double least = *std::min_element(here.begin(), here.begin() + std::ptrdiff_t(dim) + 1);
        if (least > inside) {
          inside = least;
          lambda = here;
          best = part;
        }
      };
      if (parts.empty())
        look(ancestor);
      for (std::size_t p = 0; !parts.empty() && p < parts[std::size_t(ancestor)].size(); ++p)
        look(parts[std::size_t(ancestor)][p]);
      withDimAndOrder(body.nodes.dim, body.nodes.order, [&](auto d, auto p) {
        addValues<d(), p()>(nodes, best, lambda, values, result.data() + node * dim);
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
