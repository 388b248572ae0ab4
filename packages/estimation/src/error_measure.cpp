#include "ndframe/estimation/error_measure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ndframe
{
namespace
{

double root(double square)
{
  return std::sqrt(std::max(square, 0.0));
}

double sum(const Vector& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

} // namespace

double ErrorMeasure::absolute() const
{
  return root(elements * elements + contact) + oscillation + projection;
}

double ErrorMeasure::meanStress() const
{
  return root(0.25 * elements * elements + 0.5 * contact) + oscillation;
}

double totalOf(const std::vector<Vector>& squared)
{
  double total = 0.0;
  for (const Vector& body : squared)
    total += sum(body);
  return root(total);
}

ErrorMeasure assembleMeasure(std::vector<Vector> distances, const std::vector<ContactFacet>& facets,
                             const Vector& contact)
{
  ErrorMeasure measure;
  measure.elements = totalOf(distances);
  measure.contact = sum(contact);
  measure.cells = std::move(distances);
  for (std::size_t f = 0; f < contact.size(); ++f) {
    const ContactFacet& facet = facets[f];
    measure.cells[std::size_t(facet.dirichletBody)][std::size_t(facet.dirichlet.cell)] += 0.5 * contact[f];
    measure.cells[std::size_t(facet.neumannBody)][std::size_t(facet.neumann.cell)] += 0.5 * contact[f];
  }
  return measure;
}

Vector contributions(const Vector& squared)
{
  Vector values;
  values.reserve(squared.size());
  for (const double square : squared)
    values.push_back(root(square));
  return values;
}

} // namespace ndframe
