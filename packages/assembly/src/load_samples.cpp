#include "ndframe/assembly/load_samples.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/fem/lagrange.hpp"

namespace ndframe
{
namespace
{

/// A simplex that a load acts on, as geometry.
struct Place
{
  int dim = 0; ///< of the simplex
  std::array<const double*, 4> points{};
  std::array<double, 3> normal{}, centroid{};
  bool isCell = false;

  const double* outward() const { return isCell ? nullptr : normal.data(); }
};

Place locate(const Mesh& mesh, LoadedSimplex& simplex)
{
  Place place;
  place.isCell = simplex.isCell;
  place.dim = simplex.isCell ? mesh.dim : mesh.dim - 1;
  if (simplex.isCell) {
    std::copy_n(mesh.cell(simplex.facet.cell), mesh.dim + 1, simplex.vertices.begin());
    simplex.measure = cellMeasure(mesh, simplex.facet.cell);
  } else {
    facetVertices(mesh, simplex.facet, simplex.vertices.data());
    simplex.measure = facetNormal(mesh, simplex.facet, place.normal.data());
  }
  for (std::size_t v = 0; v <= std::size_t(place.dim); ++v) {
    place.points[v] = mesh.point(simplex.vertices[v]);
    for (std::size_t k = 0; k < std::size_t(mesh.dim); ++k)
      place.centroid[k] += place.points[v][k] / (place.dim + 1);
  }
  return place;
}

template <class Visit>
void visitSimplices(const Load& load, const Mesh& mesh, const Visit& visit)
{
  LoadedSimplex simplex;
  if (const auto* facets = load.facets(mesh)) {
    for (const Facet facet : *facets) {
      simplex.facet = facet;
      visit(simplex, locate(mesh, simplex));
    }
    return;
  }
  simplex.isCell = true;
  for (int cell = 0; cell < mesh.numCells(); ++cell) {
    simplex.facet = {cell, 0};
    visit(simplex, locate(mesh, simplex));
  }
}

/// The load's size: its largest component at the centroids.
double sizeOf(const Load& load, const Mesh& mesh)
{
  double largest = 0.0, q[3];
  visitSimplices(load, mesh, [&](const LoadedSimplex&, const Place& place) {
    load.density(mesh.dim, place.centroid.data(), place.outward(), q);
    for (int k = 0; k < mesh.dim; ++k)
      largest = std::max(largest, std::abs(q[k]));
  });
  return largest;
}

/// Adds int q . v for the Lagrange functions on one simplex.
template <int simplexDim, int order>
void scatter(const LoadedSimplex& simplex, const int* nodes, int dim, Vector& load)
{
  constexpr int count = Lagrange<simplexDim, order>::nodes;
  const QuadratureRule& rule = simplex.samples.rule;
  double N[count];
  for (int g = 0; g < rule.size(); ++g) {
    Lagrange<simplexDim, order>::values(rule.point(g), N);
    const double weight = simplex.measure * rule.weights[std::size_t(g)];
    const double* q = simplex.samples.values.data() + g * dim;
    for (int a = 0; a < count; ++a)
      for (int k = 0; k < dim; ++k)
        load[std::size_t(nodes[a] * dim + k)] += weight * N[a] * q[k];
  }
}

} // namespace

void visitLoad(const Load& load, const Mesh& mesh, const std::function<void(const LoadedSimplex&)>& visit)
{
  const int dim = mesh.dim;
  const bool isConstant = load.isConstant();
  const double size = isConstant ? 0.0 : sizeOf(load, mesh);
  std::vector<double> value(static_cast<std::size_t>(dim));
  visitSimplices(load, mesh, [&](LoadedSimplex& simplex, const Place& place) {
    if (isConstant) {
      load.density(dim, place.centroid.data(), place.outward(), value.data());
      simplex.samples = sampleConstant(place.dim, value);
    } else
      simplex.samples = sampleAdaptively(place.dim, place.points.data(), dim, dim, size,
                                         [&](const double* x, double* q) { load.density(dim, x, place.outward(), q); });
    visit(simplex);
  });
}

void Load::addTo(Vector& load, const Mesh& mesh, const NodeMap& nodes) const
{
  withDimAndOrder(mesh.dim, nodes.order, [&](auto d, auto p) {
    visitLoad(*this, mesh, [&](const LoadedSimplex& simplex) {
      if (simplex.isCell)
        return scatter<d(), p()>(simplex, nodes.cell(simplex.facet.cell), d(), load);
      int local[6];
      facetNodes(nodes, simplex.facet, local);
      scatter<d() - 1, p()>(simplex, local, d(), load);
    });
  });
}

} // namespace ndframe
