#include "ndframe/admissibility/turning_normal.hpp"

#include <algorithm>

#include "ndframe/admissibility/facet_functions.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

/// Means of lambda_e f_i g_k: what `values` puts into f and g at a point.
template <class Values>
EndTables endMeans(int dim, int rows, int cols, int degree, const Values& values)
{
  EndTables tables(std::size_t(dim), DenseMatrix(rows, cols));
  const QuadratureRule rule = simplexRule(dim - 1, degree);
  Vector f(std::size_t(rows), 0.0), g(std::size_t(cols), 0.0);
  for (int q = 0; q < rule.size(); ++q) {
    values(rule.point(q), f.data(), g.data());
    for (std::size_t e = 0; e < tables.size(); ++e)
      for (int k = 0; k < cols; ++k)
        for (int i = 0; i < rows; ++i)
          tables[e](i, k) += rule.weights[std::size_t(q)] * rule.point(q)[e] * f[std::size_t(i)] * g[std::size_t(k)];
  }
  return tables;
}

/// Means of lambda_e lambda_a N_i m_k, m_k the patch's modes or (order 1) those of a unit force at a.
EndTables shareTables(int dim, int order, int degree, int a)
{
  const MomentBasis basis = facetBasis(dim, degree);
  return endMeans(dim, numFacetNodes(dim, order), basis.size(), 2 + order + degree,
                  [&](const double* lambda, double* N, double* m) {
                    facetFunctions(dim, order, lambda, N);
                    basis.values(lambda, m);
                    if (order == 1)
                      basis.vertexForce(a, m);
                    for (int k = 0; k < basis.size(); ++k)
                      m[k] *= lambda[a];
                  });
}

} // namespace

EndTables turningMoments(int dim, int order, int degree)
{
  const MomentBasis basis = facetBasis(dim, degree);
  return endMeans(dim, numFacetNodes(dim, order), basis.size(), 1 + order + degree,
                  [&](const double* lambda, double* N, double* L) {
                    facetFunctions(dim, order, lambda, N);
                    basis.values(lambda, L);
                  });
}

EndTables turningModes(int dim, int degree, int fine)
{
  const MomentBasis basis = facetBasis(dim, degree), richer = facetBasis(dim, fine);
  return endMeans(dim, richer.size(), basis.size(), 1 + degree + fine,
                  [&](const double* lambda, double* rich, double* L) {
                    richer.values(lambda, rich);
                    basis.values(lambda, L);
                  });
}

Vector turned(const EndTables& modes, const ContactPatch& patch, const Vector& moments)
{
  std::vector<Vector> along;
  for (const DenseMatrix& table : modes)
    along.push_back(multiply(table, moments));
  Vector result;
  for (std::size_t k = 0; k < along[0].size(); ++k)
    for (std::size_t i = 0; i < std::size_t(patch.dim); ++i) {
      result.push_back(0.0);
      for (std::size_t e = 0; e < along.size(); ++e)
        result.back() += along[e][k] * patch.ends[e][i];
    }
  return result;
}

void addTurned(const EndTables& modes, const std::vector<ContactPatch>& patches, std::size_t patch, int vertex,
               const Vector& change, ContactTraction& traction)
{
  if (!patches[patch].turns)
    return;
  const Vector moments = turned(modes, patches[patch], change);
  double* share = traction.vectors.data() + std::size_t(traction.dim) * traction.first(patch, std::size_t(vertex));
  for (std::size_t i = 0; i < moments.size(); ++i)
    share[i] += moments[i];
}

Vector turnedShares(const std::vector<ContactPatch>& patches, const Vector& nodal, int order, int degree)
{
  if (std::none_of(patches.begin(), patches.end(), [](const ContactPatch& patch) { return patch.turns; }))
    return {};
  const int dim = dimOf(patches), nodes = numFacetNodes(dim, order), modes = numFacetModes(dim, degree);
  const auto vertices = std::size_t(dim), size = std::size_t(modes) * vertices;
  std::vector<EndTables> tables;
  for (int a = 0; a < dim; ++a)
    tables.push_back(shareTables(dim, order, degree, a));
  Vector shares(patches.size() * vertices * size, 0.0), values(static_cast<std::size_t>(nodes));
  for (std::size_t f = 0; f < patches.size(); ++f) {
    if (!patches[f].turns)
      continue;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = patches[f].measure * nodal[std::size_t(patches[f].nodes[i])];
    for (std::size_t a = 0; a < vertices; ++a)
      for (std::size_t e = 0; e < vertices; ++e) {
        const Vector moments = multiplyTransposed(tables[a][e], DenseMatrix(values)).column(0);
        for (std::size_t k = 0; k < moments.size(); ++k)
          for (std::size_t d = 0; d < vertices; ++d)
            shares[(f * vertices + a) * size + k * vertices + d] += moments[k] * patches[f].ends[e][d];
      }
  }
  return shares;
}

} // namespace ndframe
