#include "prescribed_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace ndframe
{

PrescribedDisplacement::PrescribedDisplacement(const BodyModel& body, std::vector<const Support*> supports)
    : body_(body), supports_(std::move(supports))
{
  for (const Support* support : supports_)
    functions_.insert(functions_.end(), support->functions().begin(), support->functions().end());
}

void PrescribedDisplacement::displacement(const double* values, double* u) const
{
  const int dim = body_.mesh.dim;
  ConstraintSet combined(dim, 1.0); // the reduction to orthonormal directions that nodes get
  for (const Support* support : supports_)
    for (const Direction& direction : support->directions(body_.mesh))
      combined.add({0, direction, support->functions().empty() ? 0.0 : *values++});
  const ConstraintSet::Node& node = combined.nodes().at(0);
  std::fill_n(u, dim, 0.0);
  for (std::size_t j = 0; j < std::size_t(node.count); ++j)
    for (int i = 0; i < dim; ++i)
      u[i] += node.value[j] * node.direction[j][std::size_t(i)];
}

double PrescribedDisplacement::gain() const
{
  double sum = 0.0, u[3];
  for (std::size_t f = 0; f < functions_.size(); ++f) {
    std::vector<double> unit(functions_.size(), 0.0);
    unit[f] = 1.0;
    displacement(unit.data(), u);
    for (int i = 0; i < body_.mesh.dim; ++i)
      sum += std::abs(u[i]);
  }
  return sum;
}

Vector PrescribedDisplacement::atNodes(Facet facet) const
{
  const int dim = body_.mesh.dim;
  int nodes[6];
  facetNodes(body_.nodes, facet, nodes);
  Vector values(std::size_t(body_.nodes.nodesPerFacet) * std::size_t(dim)), ofFunctions;
  for (int a = 0; a < body_.nodes.nodesPerFacet; ++a) {
    ofFunctions.clear();
    for (const auto& function : functions_)
      ofFunctions.push_back(valueAt(function, dim, body_.nodes.point(nodes[a]).data()));
    displacement(ofFunctions.data(), values.data() + std::ptrdiff_t(a) * dim);
  }
  return values;
}

std::vector<HeldFacets> varyingFacets(const BodyModel& body)
{
  const int perCell = body.mesh.dim + 1;
  std::map<int, std::vector<std::size_t>> supports; // their numbers, by facet
  for (std::size_t s = 0; s < body.supports.size(); ++s)
    for (const Facet facet : body.supports[s]->facets(body.mesh))
      supports[facet.cell * perCell + facet.local].push_back(s);
  std::map<std::vector<std::size_t>, HeldFacets> held;
  for (const auto& [number, onFacet] : supports)
    held[onFacet].facets.push_back({number / perCell, number % perCell});
  std::vector<HeldFacets> varying;
  for (auto& [numbers, facets] : held) {
    for (const std::size_t s : numbers)
      facets.supports.push_back(body.supports[s].get());
    if (!std::all_of(facets.supports.begin(), facets.supports.end(), [](const Support* s) { return s->isConstant(); }))
      varying.push_back(std::move(facets));
  }
  return varying;
}

} // namespace ndframe
