#include "load_places.hpp"

#include <algorithm>

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
void visitSimplices(const LoadPlaces& places, const Mesh& mesh, LoadPlaces::Range range, const Visit& visit)
{
  LoadedSimplex simplex;
  simplex.isCell = places.areCells();
  for (int number = range.first; number < range.last; ++number) {
    simplex.facet = places.at(number);
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

} // namespace

LoadPlaces::LoadPlaces(const Load& load, const Mesh& mesh)
    : load_(load), mesh_(mesh), functions_(load.functions(mesh.dim)), facets_(load.facets(mesh))
{
  const auto groups = load.groups();
  if (facets_ == nullptr && !groups.empty()) {
    const auto kinds = mesh.groups.kindsIn(groups);
    for (int cell = 0; cell < mesh.numCells(); ++cell)
      if (kinds[std::size_t(mesh.groups.kind[std::size_t(cell)])])
        cells_.push_back(cell);
    size_ = int(cells_.size());
  } else {
    size_ = facets_ != nullptr ? int(facets_->size()) : mesh.numCells();
  }
}

Facet LoadPlaces::at(int number) const
{
  if (facets_ != nullptr)
    return (*facets_)[std::size_t(number)];
  return {cells_.empty() ? number : cells_[std::size_t(number)], 0};
}

double LoadPlaces::scaleOf(DataSampler& sampler) const
{
  return sampler.scaleOn([&](const DataSampler::Visit& measure) {
    visitSimplices(*this, mesh_, all(),
                   [&](const LoadedSimplex&, const Place& place) { measure(place.dim, place.points); });
  });
}

void LoadPlaces::visitConstant(Range range, const std::function<void(const LoadedSimplex&)>& visit) const
{
  const double origin[3] = {};
  std::vector<double> values, q(static_cast<std::size_t>(mesh_.dim));
  for (const auto& function : functions_)
    values.push_back(valueAt(function, mesh_.dim, origin));
  visitSimplices(*this, mesh_, range, [&](LoadedSimplex& simplex, const Place& place) {
    load_.density(mesh_.dim, values.data(), place.outward(), q.data());
    sampleConstant(place.dim, q, simplex.samples);
    visit(simplex);
  });
}

void LoadPlaces::visit(Range range, DataSampler* sampler, double scale,
                       const std::function<void(const LoadedSimplex&)>& visit) const
{
  if (sampler == nullptr)
    return visitConstant(range, visit);
  Densities densities(load_, mesh_.dim, functions_.size());
  visitSimplices(*this, mesh_, range, [&](LoadedSimplex& simplex, const Place& place) {
    sampler->sample(place.dim, place.points, scale, simplex.samples);
    densities.apply(place.outward(), simplex.samples);
    visit(simplex);
  });
}

void LoadPlaces::visit(const std::function<void(LoadedSimplex&)>& visit) const
{
  visitSimplices(*this, mesh_, all(), [&](LoadedSimplex& simplex, const Place&) { visit(simplex); });
}

} // namespace ndframe
