#include "ndframe/assembly/load_samples.hpp"

#include <algorithm>
#include <cmath>

#include "load_projection.hpp"
#include "ndframe/assembly/point_sums.hpp"
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
  const auto groups = load.groups();
  const auto kinds = mesh.groups.kindsIn(groups);
  for (int cell = 0; cell < mesh.numCells(); ++cell) {
    if (!groups.empty() && !kinds[std::size_t(mesh.groups.kind[std::size_t(cell)])])
      continue;
    simplex.facet = {cell, 0};
    visit(simplex, locate(mesh, simplex));
  }
}

/// Turns the values of functions into those of the density that is made of them.
class Densities
{
public:
  Densities(const Load& load, int dim, std::size_t functions)
      : load_(load), dim_(std::size_t(dim)), functions_(functions), ofUnits_(functions * dim_), unit_(functions)
  {}

  void apply(const double* normal, Samples& samples)
  {
    for (std::size_t f = 0; f < functions_; ++f) { // linear in the functions' values
      std::fill(unit_.begin(), unit_.end(), 0.0);
      unit_[f] = 1.0;
      load_.density(int(dim_), unit_.data(), normal, ofUnits_.data() + f * dim_);
    }
    const auto points = std::size_t(samples.rule.size());
    if (isIdentity())
      return;
    values_.assign(points * dim_, 0.0);
    for (std::size_t g = 0; g < points; ++g)
      for (std::size_t f = 0; f < functions_; ++f)
        for (std::size_t k = 0; k < dim_; ++k)
          values_[g * dim_ + k] += samples.values[g * functions_ + f] * ofUnits_[f * dim_ + k];
    samples.values.swap(values_);
  }

private:
  bool isIdentity() const
  {
    for (std::size_t i = 0; i < ofUnits_.size(); ++i)
      if (ofUnits_[i] != (i / dim_ == i % dim_ ? 1.0 : 0.0))
        return false;
    return functions_ == dim_;
  }

  const Load& load_;
  std::size_t dim_, functions_;
  std::vector<double> ofUnits_, unit_, values_;
};

/// Adds int q . v for the Lagrange functions on simplices. Their values times the rule's weights are kept for the next
/// simplex where samples of one piece name the rule.
template <int simplexDim, int order>
class Scatter
{
public:
  void add(const LoadedSimplex& simplex, const int* nodes, int dim, Vector& load)
  {
    const Samples& samples = simplex.samples;
    const QuadratureRule* rule = samples.pieces.size() == 1 ? samples.pieces.front().rule : nullptr;
    if (rule == nullptr || rule != rule_)
      tabulate(samples.rule);
    rule_ = rule;
    double forces[3 * count];
    sumOverPoints(table_.data(), samples.rule.size(), count, simplex.measure, samples.values.data(), std::size_t(dim),
                  forces);
    const double* force = forces;
    for (int a = 0; a < count; ++a)
      for (int k = 0; k < dim; ++k)
        load[std::size_t(nodes[a]) * std::size_t(dim) + std::size_t(k)] += *force++;
  }

private:
  static constexpr int count = Lagrange<simplexDim, order>::nodes;

  void tabulate(const QuadratureRule& rule)
  {
    const std::size_t row = paddedCount(count);
    table_.assign(std::size_t(rule.size()) * row, 0.0);
    double N[count];
    for (int g = 0; g < rule.size(); ++g) {
      Lagrange<simplexDim, order>::values(rule.point(g), N);
      for (std::size_t a = 0; a < std::size_t(count); ++a)
        table_[std::size_t(g) * row + a] = rule.weights[std::size_t(g)] * N[a];
    }
  }

  const QuadratureRule* rule_ = nullptr;
  std::vector<double> table_; ///< weight N_a, a row a point, padded
};

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
    sampleConstant(place.dim, q, simplex.samples);
    visit(simplex);
  });
}

void visitProjections(const Load& load, const LoadProjection& kept, const Mesh& mesh,
                      const std::function<void(const LoadedSimplex&)>& visit)
{
  std::size_t number = 0;
  visitSimplices(load, mesh, [&](LoadedSimplex& simplex, const Place&) {
    kept.fill(number++, simplex);
    visit(simplex);
  });
}

} // namespace

void visitLoad(const Load& load, const Mesh& mesh, const std::function<void(const LoadedSimplex&)>& visit)
{
  const auto functions = load.functions(mesh.dim);
  if (areConstant(functions))
    return visitConstant(load, functions, mesh, visit);
  if (const LoadProjection* kept = load.projection(); kept != nullptr && kept->isOf(mesh))
    return visitProjections(load, *kept, mesh, visit);
  DataSampler& sampler = load.sampler(mesh.dim);
  Densities densities(load, mesh.dim, functions.size());
  const double scale = sampler.scaleOn([&](const DataSampler::Visit& measure) {
    visitSimplices(load, mesh, [&](const LoadedSimplex&, const Place& place) { measure(place.dim, place.points); });
  });
  visitSimplices(load, mesh, [&](LoadedSimplex& simplex, const Place& place) {
    sampler.sample(place.dim, place.points, scale, simplex.samples);
    densities.apply(place.outward(), simplex.samples);
    visit(simplex);
  });
}

std::array<int, 4> ascendingPlaces(const LoadedSimplex& simplex)
{
  const int count = simplex.samples.rule.dim + 1;
  std::array<int, 4> places{};
  for (int v = 0; v < count; ++v)
    places[std::size_t(v)] = int(std::count_if(simplex.vertices.begin(), simplex.vertices.begin() + count,
                                               [&](int w) { return w < simplex.vertices[std::size_t(v)]; }));
  return places;
}

DataSampler& Load::sampler(int dim) const
{
  if (!sampler_)
    sampler_ = std::make_shared<DataSampler>(functions(dim), dim, DataSampler::Cuts::Curved);
  return *sampler_;
}

void Load::addTo(Vector& load, const Mesh& mesh, const NodeMap& nodes, Keep keep) const
{
  projection_.reset();
  std::shared_ptr<LoadProjection> next;
  if (keep == Keep::Projections && facets(mesh) == nullptr && !isConstant(mesh.dim))
    next = std::make_shared<LoadProjection>(mesh);
  withDimAndOrder(mesh.dim, nodes.order, [&](auto d, auto p) {
    Scatter<d(), p()> onCells;
    Scatter<d() - 1, p()> onFacets;
    visitLoad(*this, mesh, [&](const LoadedSimplex& simplex) {
      if (simplex.isCell) {
        if (next)
          next->add(simplex);
        return onCells.add(simplex, nodes.cell(simplex.facet.cell), d(), load);
      }
      int local[6];
      facetNodes(nodes, simplex.facet, local);
      onFacets.add(simplex, local, d(), load);
    });
  });
  if (next && next->isKept())
    projection_ = std::move(next);
}

} // namespace ndframe
