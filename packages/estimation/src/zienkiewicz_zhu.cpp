#include "ndframe/estimation/zienkiewicz_zhu.hpp"

#include <algorithm>

#include "ndframe/assembly/cell_field.hpp"
#include "patch_polynomials.hpp"

namespace ndframe
{
namespace
{

/// Where the displacements' strain is taken as nearly right: at the centroid (order 1), at dim + 1 points (order 2).
QuadratureRule samplePoints(int dim, int order)
{
  if (order == 2)
    return simplexRule(dim, 2);
  return {dim, std::vector<double>(std::size_t(dim + 1), 1.0 / (dim + 1)), {1.0}};
}

/// The point with barycentric coordinates lambda and the strain of u_h there.
template <int dim, int order>
void strainAt(const CellField<dim, order>& field, const double* lambda, double* x, double* strain)
{
  double stress[CellField<dim, order>::strains];
  std::fill(x, x + dim, 0.0);
  for (int v = 0; v <= dim; ++v)
    for (int k = 0; k < dim; ++k)
      x[k] += lambda[v] * field.points[v * dim + k];
  field.evaluate(lambda, strain, stress);
}

/// difference : K difference.
double energyDensity(const Elasticity& law, const double* strain)
{
  double density = 0.0;
  for (int i = 0; i < law.strains(); ++i)
    for (int j = 0; j < law.strains(); ++j)
      density += strain[i] * law(i, j) * strain[j];
  return density;
}

/// Within a region sigma* = K eps*: strains are recovered and no compliance is needed. Limit: strains are smoothed
/// across regions of different materials, too, where they jump.
template <int dim, int order>
Vector squaredDifferences(const BodyModel& body, const Vector& displacement)
{
  constexpr int strains = CellField<dim, order>::strains;
  const QuadratureRule samples = samplePoints(dim, order), rule = simplexRule(dim, 2 * (order + 1));
  PatchSamples values{samples.size(), strains, {}, {}};
  double x[dim], strain[strains], recovered[strains];
  for (int c = 0; c < body.mesh.numCells(); ++c) {
    const CellField<dim, order> field(body, displacement, c);
    for (int s = 0; s < samples.size(); ++s) {
      strainAt(field, samples.point(s), x, strain);
      values.points.insert(values.points.end(), x, x + dim);
      values.values.insert(values.values.end(), strain, strain + strains);
    }
  }
  const PatchPolynomials smooth(body.mesh, order, values);
  Vector squared(std::size_t(body.mesh.numCells()), 0.0);
  for (int c = 0; c < body.mesh.numCells(); ++c) {
    const CellField<dim, order> field(body, displacement, c);
    for (int q = 0; q < rule.size(); ++q) {
      strainAt(field, rule.point(q), x, strain);
      smooth.blend(body.mesh.cell(c), rule.point(q), x, recovered);
      for (int i = 0; i < strains; ++i)
        recovered[i] -= strain[i];
      squared[std::size_t(c)] +=
          cellMeasure(body.mesh, c) * rule.weights[std::size_t(q)] * energyDensity(field.law, recovered);
    }
  }
  return squared;
}

} // namespace

CellValues zienkiewiczZhu(const BodyModel& body, const Vector& displacement)
{
  return ofCells(withDimAndOrder(body.mesh.dim, body.nodes.order,
                                 [&](auto d, auto p) { return squaredDifferences<d(), p()>(body, displacement); }));
}

} // namespace ndframe
