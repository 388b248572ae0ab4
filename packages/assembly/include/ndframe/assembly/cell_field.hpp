#pragma once

#include <array>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/mechanics/kernels.hpp"

namespace ndframe
{

/// A displacement in one cell, as kernels want it: coordinates of the vertices, displacements of the nodes.
template <int dim, int order>
struct CellField
{
  static constexpr int nodes = Lagrange<dim, order>::nodes, /**< of a cell */ strains = dim == 2 ? 3 : 6; ///< Voigt

  const Elasticity& law;                                                  ///< of the cell, in the body
  double points[(dim + 1) * dim], /**< of the vertices */ u[nodes * dim]; ///< node by node, global axes
  double gradients[(dim + 1) * dim];                                      ///< of the barycentric coordinates
  double measure;                                                         ///< signed, as the vertices are given

  /// displacement: numNodes * dim, global axes. body must outlive the field.
  CellField(const BodyModel& body, const Vector& displacement, int cell) : law(body.laws(cell))
  {
    cellPoints(body.mesh, cell, points);
    measure = barycentricGradients<dim>(points, gradients);
    for (int a = 0; a < nodes; ++a)
      std::copy_n(displacement.data() + std::size_t(body.nodes.cell(cell)[a]) * dim, dim, u + a * dim);
  }

  /// Voigt strain and stress K eps(u) at barycentric coordinates lambda.
  void evaluate(const double* lambda, double* strain, double* stress) const
  {
    stressAt<dim, order>(gradients, law, lambda, u, strain, stress);
  }

  /// The stress as (xx, yy, zz, xy, yz, xz).
  std::array<double, 6> fullStress(const double* lambda) const
  {
    double strain[strains], stress[strains];
    evaluate(lambda, strain, stress);
    if constexpr (dim == 3)
      return {stress[0], stress[1], stress[2], stress[3], stress[4], stress[5]};
    double outOfPlane = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      outOfPlane += law.outOfPlane[i] * strain[i];
    return {stress[0], stress[1], outOfPlane, stress[2], 0.0, 0.0};
  }
};

} // namespace ndframe
