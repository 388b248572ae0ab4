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
  std::array<double, 3> normal{};
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
  for (std::size_t v = 0; v <= std::size_t(place.dim); ++v)
    place.points[v] = mesh.point(simplex.vertices[v]);
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

/// The samples of q from those of the functions that it is made of.
void toDensity(const Load& load, int dim, std::size_t functions, const double* normal, Samples& samples)
{
  std::vector<double> q(std::size_t(samples.rule.size()) * std::size_t(dim));
  for (std::size_t g = 0; g < std::size_t(samples.rule.size()); ++g)
    load.density(dim, samples.values.data() + g * functions, normal, q.data() + g * std::size_t(dim));
  samples.values = std::move(q);
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
        load[std::size_t(nodes[a]) * std::size_t(dim) + std::size_t(k)] += weight * N[a] * q[k];
  }
}

} // namespace

namespace
{

void visitConstant(const Load& load, const std::vector<SampledFunction>& functions, const Mesh& mesh,
                   const std::function<void(const LoadedSimplex&)>& visit)
{
  const double origin[3] = {};
  std::vector<double> values, q(static_cast<std::size_t>(mesh.dim));
  for (const auto& function : functions)
    values.push_back(valueAt(function, mesh.dim, origin));
  visitSimplices(load, mesh, [&](LoadedSimplex& simplex, const Place& place) {
    load.density(mesh.dim, values.data(), place.outward(), q.data());
    simplex.samples = sampleConstant(place.dim, q);
    visit(simplex);
  });
}

} // namespace

void visitLoad(const Load& load, const Mesh& mesh, const std::function<void(const LoadedSimplex&)>& visit)
{
  const auto functions = load.functions(mesh.dim);
  if (areConstant(functions))
    return visitConstant(load, functions, mesh, visit);
  DataSampler sampler(functions, mesh.dim);
  const double scale = sampler.scaleOn([&](const DataSampler::Visit& measure) {
    visitSimplices(load, mesh, [&](const LoadedSimplex&, const Place& place) { measure(place.dim, place.points); });
  });
  visitSimplices(load, mesh, [&](LoadedSimplex& simplex, const Place& place) {
    simplex.samples = sampler.sample(place.dim, place.points, scale);
    toDensity(load, mesh.dim, functions.size(), place.outward(), simplex.samples);
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
