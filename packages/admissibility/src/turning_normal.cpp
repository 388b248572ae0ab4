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
EndTables endMeans(int rows, int cols, int degree, const Values& values)
{
  EndTables tables{DenseMatrix(rows, cols), DenseMatrix(rows, cols)};
  const QuadratureRule rule = simplexRule(1, degree);
  Vector f(std::size_t(rows), 0.0), g(std::size_t(cols), 0.0);
  for (int q = 0; q < rule.size(); ++q) {
    values(rule.point(q), f.data(), g.data());
    for (std::size_t e = 0; e < 2; ++e)
      for (int k = 0; k < cols; ++k)
        for (int i = 0; i < rows; ++i)
          tables[e](i, k) += rule.weights[std::size_t(q)] * rule.point(q)[e] * f[std::size_t(i)] * g[std::size_t(k)];
  }
  return tables;
}

/// Means of lambda_e lambda_a N_i m_k, m_k the edge's modes or (order 1) those of a unit force at a.
EndTables shareTables(int order, int degree, int a)
{
  const MomentBasis basis = facetBasis(2, degree);
  return endMeans(order + 1, degree + 1, 2 + order + degree, [&](const double* lambda, double* N, double* m) {
    facetFunctions(2, order, lambda, N);
    basis.values(lambda, m);
    if (order == 1)
      basis.vertexForce(a, m);
    for (int k = 0; k <= degree; ++k)
      m[k] *= lambda[a];
  });
}

} // namespace

EndTables turningEdgeMoments(int order, int degree)
{
  const MomentBasis basis = facetBasis(2, degree);
  return endMeans(order + 1, degree + 1, 1 + order + degree, [&](const double* lambda, double* N, double* L) {
    facetFunctions(2, order, lambda, N);
    basis.values(lambda, L);
  });
}

EndTables turningModes(int degree, int fine)
{
  const MomentBasis basis = facetBasis(2, degree), richer = facetBasis(2, fine);
  return endMeans(fine + 1, degree + 1, 1 + degree + fine, [&](const double* lambda, double* rich, double* L) {
    richer.values(lambda, rich);
    basis.values(lambda, L);
  });
}

Vector turned(const EndTables& modes, const ContactPatch& patch, const Vector& moments)
{
  Vector result;
  const std::array<Vector, 2> along{multiply(modes[0], moments), multiply(modes[1], moments)};
  for (std::size_t k = 0; k < along[0].size(); ++k)
    for (std::size_t i = 0; i < 2; ++i)
      result.push_back(along[0][k] * patch.ends[0][i] + along[1][k] * patch.ends[1][i]);
  return result;
}

void addTurned(const EndTables& modes, const std::vector<ContactPatch>& patches, std::size_t patch, int vertex,
               const Vector& change, ContactTraction& traction)
{
  if (!patches[patch].turns)
    return;
  const Vector moments = turned(modes, patches[patch], change);
  double* share = traction.vectors.data() + 2 * traction.first(patch, std::size_t(vertex));
  for (std::size_t i = 0; i < moments.size(); ++i)
    share[i] += moments[i];
}

Vector turnedShares(const std::vector<ContactPatch>& patches, const Vector& nodal, int order, int degree)
{
  if (std::none_of(patches.begin(), patches.end(), [](const ContactPatch& patch) { return patch.turns; }))
    return {};
  const std::array<EndTables, 2> tables{shareTables(order, degree, 0), shareTables(order, degree, 1)};
  const auto modes = std::size_t(degree) + 1;
  Vector shares(patches.size() * 4 * modes, 0.0);
  for (std::size_t f = 0; f < patches.size(); ++f)
    for (std::size_t a = 0; patches[f].turns && a < 2; ++a)
      for (std::size_t e = 0; e < 2; ++e)
        for (int k = 0; k <= degree; ++k)
          for (int i = 0; i <= order; ++i)
            for (std::size_t d = 0; d < 2; ++d)
              shares[((f * 2 + a) * modes + std::size_t(k)) * 2 + d] +=
                  patches[f].measure * nodal[std::size_t(patches[f].nodes[std::size_t(i)])] * tables[a][e](i, k) *
                  patches[f].ends[e][d];
  return shares;
}

} // namespace ndframe
