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

double sumOf(const Vector& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// (D_E + osc_E)^2.
std::vector<CellValues> widenedSquares(std::vector<CellValues> distances, const std::vector<CellValues>& oscillation)
{
  for (std::size_t b = 0; b < oscillation.size(); ++b)
    for (std::size_t cell = 0; cell < distances[b].size(); ++cell)
      if (oscillation[b][cell] > 0.0)
        distances[b][cell] = std::pow(root(distances[b][cell]) + root(oscillation[b][cell]), 2);
  return distances;
}

} // namespace

double ErrorMeasure::sum() const
{
  return root(elements * elements + contact) + projection + oscillation + prescribed;
}

double ErrorMeasure::radius() const
{
  const double B = 0.5 * widened + root(0.25 * widened * widened + 0.5 * contact);
  return root(0.25 * elements * elements + 0.5 * contact + oscillation * B);
}

double ErrorMeasure::meanStress() const
{
  return radius() + prescribed;
}

double ErrorMeasure::bound() const
{
  return std::max(aside, 0.5 * elements) + radius() + prescribed;
}

double totalOf(const std::vector<CellValues>& squared, const Comm& parts)
{
  Vector total{0.0};
  for (const Vector& body : squared)
    total[0] += sumOf(body);
  parts.sum(total);
  return root(total[0]);
}

ErrorMeasure assembleMeasure(std::vector<CellValues> distances, const std::vector<ContactPatch>& patches,
                             const Vector& contact, const std::vector<CellValues>& oscillation, const Comm& parts)
{
  ErrorMeasure measure;
  measure.elements = totalOf(distances, parts);
  measure.aside = 0.5 * measure.elements;
  measure.oscillation = totalOf(oscillation, parts);
  measure.cells = widenedSquares(std::move(distances), oscillation);
  measure.widened = totalOf(measure.cells, parts);
  measure.contact = sumOf(contact);
  for (std::size_t f = 0; f < contact.size(); ++f)
    for (const PatchSide& side : patches[f].sides)
      measure.cells[std::size_t(side.body)][std::size_t(side.facet.cell)] += 0.5 * contact[f];
  return measure;
}

CellValues contributions(const Vector& squared)
{
  Vector values;
  values.reserve(squared.size());
  for (const double square : squared)
    values.push_back(root(square));
  return ofCells(std::move(values));
}

} // namespace ndframe
