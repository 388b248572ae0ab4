#include "ndframe/equilibrium/star_body.hpp"

#include <algorithm>

#include "ndframe/equilibrium/self_touching.hpp"
#include "ndframe/equilibrium/star_wrench.hpp"

namespace ndframe
{
namespace
{

int facetNumber(const Mesh& mesh, Facet facet)
{
  return facet.cell * (mesh.dim + 1) + sortedFacet(mesh, facet);
}

} // namespace

StarBody::StarBody(const BodyModel& model, const StaticData& data)
    : model_(model), data_(data), reference_(referenceStress(data.dim, data.degree)), around_(model.mesh),
      facetMeans_(meanCoordinates(facetBasis(data.dim, data.degree))),
      cellMeans_(meanCoordinates(loadBasis(data.dim, data.degree)))
{
  for (std::size_t i = 0; i < data.boundary.size(); ++i)
    boundary_.emplace_back(facetNumber(model.mesh, data.boundary[i].facet), int(i));
  for (std::size_t i = 0; i < data.contact.size(); ++i)
    contact_.emplace_back(facetNumber(model.mesh, data.contact[i]), int(i));
  std::sort(boundary_.begin(), boundary_.end());
  std::sort(contact_.begin(), contact_.end());
}

int StarBody::lookUp(const Index& index, int cell, int facet) const
{
  const int number = cell * (data_.dim + 1) + facet;
  const auto found = std::lower_bound(index.begin(), index.end(), std::pair(number, -1));
  return found != index.end() && found->first == number ? found->second : -1;
}

DenseMatrix StarBody::cellEnergy(const StarCell& cell) const
{
  return cellEnergyMatrix(reference_, cellMap(model_.mesh, cell.sorted), model_.laws(cell.cell));
}

Star StarBody::star(int vertex) const
{
  Star star = makeStar(model_.mesh, around_, vertex);
  if (spanningTree(star).order.size() != star.cells.size())
    throw SelfTouching(model_, vertex);
  return star;
}

} // namespace ndframe
