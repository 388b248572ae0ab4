#include "prescribed_tractions.hpp"

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

PrescribedTractions::PrescribedTractions(const BodyModel& body, const StaticData& data, const FieldInput& field)
    : mesh_(body.mesh), basis_(facetBasis(data.dim, data.degree))
{
  const std::size_t shares = std::size_t(data.dim) * std::size_t(data.dim) * std::size_t(basis_.size());
  NDFRAME_ASSERT(data.facetShares.size() == data.boundary.size() * shares, "one share per vertex of a loaded facet");
  for (std::size_t i = 0; i < data.boundary.size(); ++i) {
    const BoundaryFacet& boundary = data.boundary[i];
    add(boundary.facet, data.facetShares.data() + i * shares);
    facets_[{boundary.facet.cell, boundary.facet.local}].support = &boundary;
  }
  if (field.contact == nullptr)
    return;
  NDFRAME_ASSERT(field.contact->size() == data.contact.size() * shares, "one share per vertex of a contact facet");
  for (std::size_t i = 0; i < data.contact.size(); ++i)
    add(data.contact[i], field.contact->data() + i * shares);
}

void PrescribedTractions::add(Facet facet, const double* shares)
{
  const std::size_t size = std::size_t(mesh_.dim) * std::size_t(basis_.size());
  Vector& moments = facets_[{facet.cell, facet.local}].moments;
  moments.resize(size, 0.0);
  for (int vertex = 0; vertex < mesh_.dim; ++vertex)
    for (double& moment : moments)
      moment += *shares++;
}

const PrescribedTractions::OnFacet* PrescribedTractions::find(Facet facet) const
{
  const auto found = facets_.find({facet.cell, facet.local});
  return found == facets_.end() ? nullptr : &found->second;
}

Direction PrescribedTractions::value(Facet facet, const double* point) const
{
  Direction traction{}, normal{};
  const OnFacet* here = find(facet);
  if (here == nullptr)
    return traction;
  const double measure = facetNormal(mesh_, facet, normal.data());
  std::vector<double> m(std::size_t(basis_.size()), 0.0);
  basis_.values(point, m.data());
  for (std::size_t k = 0; k < m.size(); ++k)
    for (std::size_t i = 0; i < std::size_t(mesh_.dim); ++i)
      traction[i] += here->moments[k * std::size_t(mesh_.dim) + i] * m[k] / measure;
  return traction;
}

const Vector* PrescribedTractions::moments(Facet facet) const
{
  const OnFacet* here = find(facet);
  return here == nullptr ? nullptr : &here->moments;
}

bool PrescribedTractions::isSupported(Facet facet) const
{
  const OnFacet* here = find(facet);
  return here != nullptr && here->support != nullptr && here->support->supported > 0;
}

Direction PrescribedTractions::freePart(Facet facet, Direction traction) const
{
  const OnFacet* here = find(facet);
  if (here != nullptr && here->support != nullptr)
    here->support->removeSupported(mesh_.dim, 1, traction.data());
  return traction;
}

} // namespace ndframe
