#include "ndframe/assembly/load_samples.hpp"

#include <algorithm>

#include "load_places.hpp"
#include "load_projection.hpp"

namespace ndframe
{

void visitLoad(const Load& load, const Mesh& mesh, const std::function<void(const LoadedSimplex&)>& visit)
{
  const LoadPlaces places(load, mesh);
  if (places.isConstant())
    return places.visit(places.all(), nullptr, 0.0, visit);
  if (const LoadProjection* kept = load.projection(); kept != nullptr && kept->isOf(mesh)) {
    std::size_t number = 0;
    return places.visit([&](LoadedSimplex& simplex) {
      kept->fill(number++, simplex);
      visit(simplex);
    });
  }
  DataSampler& sampler = load.sampler(mesh.dim);
  const double scale = places.scaleOf(sampler);
  places.visit(places.all(), &sampler, scale, visit);
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

} // namespace ndframe
