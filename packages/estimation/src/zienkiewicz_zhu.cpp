#include "ndframe/estimation/zienkiewicz_zhu.hpp"

#include <algorithm>

#include "ndframe/mechanics/kernels.hpp"
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

/// The strain of u_h cell by cell.
template <int dim, int order>
class StrainField
{
public:
  static constexpr int nodes = Lagrange<dim, order>::nodes, strains = dim == 2 ? 3 : 6;

  StrainField(const BodyModel& body, const Vector& displacement) : body_(body), displacement_(displacement) {}

  /// The point with barycentric coordinates lambda of a cell and the strain there.
  void operator()(int cell, const double* lambda, double* x, double* strain) const
  {
    double points[(dim + 1) * dim], u[nodes * dim], stress[strains];
    std::fill(x, x + dim, 0.0);
    for (int v = 0; v <= dim; ++v) {
      std::copy_n(body_.mesh.point(body_.mesh.cell(cell)[v]), dim, points + v * dim);
      for (int k = 0; k < dim; ++k)
        x[k] += lambda[v] * points[v * dim + k];
    }
    for (int a = 0; a < nodes; ++a)
      std::copy_n(displacement_.data() + std::size_t(body_.nodes.cell(cell)[a] * dim), dim, u + a * dim);
    stressAt<dim, order>(points, body_.law, lambda, u, strain, stress);
  }

private:
  const BodyModel& body_;
  const Vector& displacement_;
};

/// difference : K difference.
double energyDensity(const Elasticity& law, const double* strain)
{
  double density = 0.0;
  for (int i = 0; i < law.strains(); ++i)
    for (int j = 0; j < law.strains(); ++j)
      density += strain[i] * law(i, j) * strain[j];
  return density;
}

/// One law for the whole body, so sigma* = K eps*: strains are recovered and no compliance is needed.
template <int dim, int order>
Vector squaredDifferences(const BodyModel& body, const Vector& displacement)
{
  const StrainField<dim, order> field(body, displacement);
  constexpr int strains = StrainField<dim, order>::strains;
  const QuadratureRule samples = samplePoints(dim, order), rule = simplexRule(dim, 2 * (order + 1));
  PatchSamples values{samples.size(), strains, {}, {}};
  double x[dim], strain[strains], recovered[strains];
  for (int c = 0; c < body.mesh.numCells(); ++c)
    for (int s = 0; s < samples.size(); ++s) {
      field(c, samples.point(s), x, strain);
      values.points.insert(values.points.end(), x, x + dim);
      values.values.insert(values.values.end(), strain, strain + strains);
    }
  const PatchPolynomials smooth(body.mesh, order, values);
  Vector squared(std::size_t(body.mesh.numCells()), 0.0);
  for (int c = 0; c < body.mesh.numCells(); ++c)
    for (int q = 0; q < rule.size(); ++q) {
      field(c, rule.point(q), x, strain);
      smooth.blend(body.mesh.cell(c), rule.point(q), x, recovered);
      for (int i = 0; i < strains; ++i)
        recovered[i] -= strain[i];
      squared[std::size_t(c)] +=
          cellMeasure(body.mesh, c) * rule.weights[std::size_t(q)] * energyDensity(body.law, recovered);
    }
  return squared;
}

} // namespace

Vector zienkiewiczZhu(const BodyModel& body, const Vector& displacement)
{
  return withDimAndOrder(body.mesh.dim, body.nodes.order,
                         [&](auto d, auto p) { return squaredDifferences<d(), p()>(body, displacement); });
}

} // namespace ndframe
