#include "ndframe/estimation/residual.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/admissibility/smallest_stiffness.hpp"
#include "ndframe/assembly/cell_field.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/equilibrium/facet_twins.hpp"

namespace ndframe
{
namespace
{

/// The residuals of one body as moments, like the data: orthonormal bases make their norms sums of squares.
struct Residuals
{
  Vector facets; ///< per cell, sorted facet, mode, component: int (sigma_h n) L_k, then the jump
  Vector cells;  ///< per cell, load mode, component: int (b + div sigma_h) m_k
};

/// Where the moments of a facet begin.
std::size_t facetOffset(const Mesh& mesh, int cell, int sorted, int facetData)
{
  return (std::size_t(cell) * std::size_t(mesh.dim + 1) + std::size_t(sorted)) * std::size_t(facetData);
}

std::size_t facetOffset(const Mesh& mesh, Facet facet, int facetData)
{
  return facetOffset(mesh, facet.cell, sortedFacet(mesh, facet), facetData);
}

/// Constant: sigma_h is linear at most, so its divergence follows from its values at the vertices.
template <int dim, int order>
void addDivergence(const CellField<dim, order>& field, double factor, double* div)
{
  constexpr int strains = CellField<dim, order>::strains;
  double strain[strains], sigma[strains], part[dim];
  for (int v = 0; v <= dim; ++v) {
    double lambda[dim + 1] = {};
    lambda[v] = 1.0;
    field.evaluate(lambda, strain, sigma);
    divergenceForce<dim>(field.gradients + v * dim, sigma, part);
    for (int k = 0; k < dim; ++k)
      div[k] += factor * part[k];
  }
}

/// Adds the moments of sigma_h n on one facet of a cell.
template <int dim, int order>
void addTraction(const Mesh& mesh, const CellField<dim, order>& field, int cell, int sorted, const MomentBasis& basis,
                 const QuadratureRule& rule, double* moments)
{
  const SortedCell vertices = sortedCell(mesh, cell);
  constexpr int strains = CellField<dim, order>::strains;
  double normal[dim], strain[strains], sigma[strains], traction[dim];
  const double measure = facetNormal(mesh, {cell, vertices.local[std::size_t(sorted)]}, normal);
  Vector L(std::size_t(basis.size()));
  for (int g = 0; g < rule.size(); ++g) {
    double lambda[dim + 1] = {};
    for (int v = 0; v < dim; ++v)
      lambda[vertices.local[std::size_t(v < sorted ? v : v + 1)]] = rule.point(g)[v];
    field.evaluate(lambda, strain, sigma);
    divergenceForce<dim>(normal, sigma, traction);
    basis.values(rule.point(g), L.data());
    for (int k = 0; k < basis.size(); ++k)
      for (int i = 0; i < dim; ++i)
        moments[k * dim + i] += measure * rule.weights[std::size_t(g)] * L[std::size_t(k)] * traction[i];
  }
}

/// sigma_h n on all facets and div sigma_h in all cells.
template <int dim, int order>
Residuals stressMoments(const BodyModel& body, const Vector& displacement, int degree)
{
  const MomentBasis facet = facetBasis(dim, degree), load = loadBasis(dim, degree);
  const QuadratureRule rule = simplexRule(dim - 1, order - 1 + degree);
  const int facetData = facet.size() * dim, loadData = load.size() * dim, numCells = body.mesh.numCells();
  Residuals residuals{Vector(std::size_t(numCells) * std::size_t(dim + 1) * std::size_t(facetData), 0.0),
                      Vector(std::size_t(numCells) * std::size_t(loadData), 0.0)};
  for (int cell = 0; cell < numCells; ++cell) {
    const CellField<dim, order> field(body, displacement, cell);
    for (int i = 0; i <= dim; ++i)
      addTraction(body.mesh, field, cell, i, facet, rule,
                  residuals.facets.data() + facetOffset(body.mesh, cell, i, facetData));
    addDivergence(field, cellMeasure(body.mesh, cell),
                  residuals.cells.data() + std::size_t(cell) * std::size_t(loadData));
  }
  return residuals;
}

/// Adds factor times the sum of the shares of `vertices` vertices.
void addShares(const double* shares, int vertices, std::size_t size, double factor, double* moments)
{
  for (int v = 0; v < vertices; ++v)
    for (std::size_t i = 0; i < size; ++i)
      moments[i] += factor * *shares++;
}

/// sigma_h n - p on the boundary, b + div sigma_h inside.
void takeLoads(const Mesh& mesh, const StaticData& data, const Vector* contact, Residuals& residuals)
{
  const int modes = facetBasis(data.dim, data.degree).size(), facetData = modes * data.dim;
  const auto size = std::size_t(facetData), shares = size * std::size_t(data.dim);
  for (std::size_t f = 0; f < data.contact.size() && contact != nullptr; ++f)
    addShares(contact->data() + f * shares, data.dim, size, -1.0,
              residuals.facets.data() + facetOffset(mesh, data.contact[f], facetData));
  for (std::size_t f = 0; f < data.boundary.size(); ++f) {
    double* moments = residuals.facets.data() + facetOffset(mesh, data.boundary[f].facet, facetData);
    addShares(data.facetShares.data() + f * shares, data.dim, size, -1.0, moments);
    data.boundary[f].removeSupported(data.dim, std::size_t(modes), moments); // a reaction acts there
  }
  if (data.cellShares.empty())
    return;
  const auto loadData = std::size_t(loadBasis(data.dim, data.degree).size()) * std::size_t(data.dim);
  for (std::size_t c = 0; c < std::size_t(mesh.numCells()); ++c)
    addShares(data.cellShares.data() + c * loadData * std::size_t(data.dim + 1), data.dim + 1, loadData, 1.0,
              residuals.cells.data() + c * loadData);
}

/// The longest of the edges between `count` vertices.
double longestEdge(const Mesh& mesh, const int* vertices, int count)
{
  double longest = 0.0;
  for (int b = 1; b < count; ++b)
    for (int a = 0; a < b; ++a) {
      double squared = 0.0;
      for (int k = 0; k < mesh.dim; ++k)
        squared += std::pow(mesh.point(vertices[a])[k] - mesh.point(vertices[b])[k], 2);
      longest = std::max(longest, squared);
    }
  return std::sqrt(longest);
}

double squaredNorm(const double* moments, std::size_t size, double measure)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < size; ++i)
    sum += moments[i] * moments[i];
  return sum / measure;
}

/// Adds h_f |J_f|^2 to the cells of every facet, half to each of two.
void addJumps(const Mesh& mesh, const Vector& tractions, int facetData, Vector& squared)
{
  const auto cells = sortedCells(mesh);
  const auto twins = facetTwins(cells, mesh.dim);
  const int facets = mesh.dim + 1;
  const auto size = std::size_t(facetData);
  double normal[3];
  int vertices[3];
  Vector jump(size);
  for (int half = 0; half < int(twins.size()); ++half) {
    const int twin = twins[std::size_t(half)];
    if (twin > half)
      continue;
    std::fill(jump.begin(), jump.end(), 0.0);
    for (const int side : {half, twin})
      if (side >= 0)
        addShares(tractions.data() + std::size_t(side) * size, 1, size, 1.0, jump.data());
    const Facet facet{half / facets, cells[std::size_t(half / facets)].local[std::size_t(half % facets)]};
    facetVertices(mesh, facet, vertices);
    const double value =
        longestEdge(mesh, vertices, mesh.dim) * squaredNorm(jump.data(), size, facetNormal(mesh, facet, normal));
    for (const int side : {half, twin})
      if (side >= 0)
        squared[std::size_t(side / facets)] += twin < 0 ? value : 0.5 * value;
  }
}

} // namespace

CellValues residualIndicator(const BodyModel& body, const StaticData& data, const FieldInput& field)
{
  const Mesh& mesh = body.mesh;
  NDFRAME_ASSERT(data.dim == mesh.dim && data.order == body.nodes.order, "the data are this body's");
  Residuals residuals = withDimAndOrder(data.dim, data.order, [&](auto d, auto p) {
    return stressMoments<d(), p()>(body, *field.displacement, data.degree);
  });
  takeLoads(mesh, data, field.contact, residuals);
  Vector squared(std::size_t(mesh.numCells()));
  const std::size_t loadData = residuals.cells.size() / squared.size();
  for (std::size_t c = 0; c < squared.size(); ++c) {
    const double h = longestEdge(mesh, mesh.cell(int(c)), mesh.dim + 1);
    squared[c] = h * h * squaredNorm(residuals.cells.data() + c * loadData, loadData, cellMeasure(mesh, int(c)));
  }
  addJumps(mesh, residuals.facets, facetBasis(data.dim, data.degree).size() * data.dim, squared);
  const Vector stiffness = smallestStiffness(body.laws);
  for (std::size_t c = 0; c < squared.size(); ++c)
    squared[c] /= stiffness[std::size_t(body.laws.number(int(c)))];
  return ofCells(std::move(squared));
}

} // namespace ndframe
