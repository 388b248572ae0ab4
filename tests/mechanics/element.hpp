#pragma once

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fem/sample_meshes.hpp"
#include "mechanics/sample_laws.hpp"
#include "ndframe/algebra/dense.hpp"
#include "ndframe/fem/node_map.hpp"
#include "ndframe/mechanics/kernels.hpp"

namespace ndframe::test
{

template <int dimension, int degree>
struct Element
{
  static constexpr int dim = dimension, order = degree, strains = dim == 2 ? 3 : 6;
  static constexpr int nodes = Lagrange<dim, order>::nodes, dofs = nodes * dim;

  static DenseMatrix stiffness(const std::vector<double>& vertices, const Elasticity& law)
  {
    double K[dofs * dofs];
    elementStiffness<dim, order>(vertices.data(), law, simplexRule(dim, 2 * (order - 1)), K);
    DenseMatrix matrix(dofs, dofs);
    for (int i = 0; i < dofs; ++i)
      for (int j = 0; j < dofs; ++j)
        matrix(i, j) = K[i * dofs + j];
    return matrix;
  }

  /// Nodal values of a displacement field.
  template <class Field>
  static Vector interpolate(const Mesh& cell, const Field& field)
  {
    const NodeMap nodeMap = makeNodeMap(cell, order);
    Vector u(dofs);
    for (int a = 0; a < nodes; ++a)
      field(nodeMap.point(nodeMap.cell(0)[a]).data(), u.data() + a * dim);
    return u;
  }
};

using Elements = testing::Types<Element<2, 1>, Element<2, 2>, Element<3, 1>, Element<3, 2>>;

/// u(x) = H x + quadratic terms: u_i = sum_k H_ik x_k + sum_kl Q_ikl x_k x_l with random coefficients.
class RandomField
{
public:
  RandomField(int dim, unsigned seed, bool quadratic) : dim_(dim)
  {
    Random random(seed);
    H_ = random.vector(std::size_t(dim * dim));
    Q_ = quadratic ? random.vector(std::size_t(dim * dim * dim)) : std::vector<double>(std::size_t(dim * dim * dim));
  }
  void operator()(const double* x, double* u) const
  {
    for (int i = 0; i < dim_; ++i) {
      u[i] = 0.0;
      for (int k = 0; k < dim_; ++k) {
        u[i] += H_[std::size_t(i * dim_ + k)] * x[k];
        for (int l = 0; l < dim_; ++l)
          u[i] += Q_[std::size_t((i * dim_ + k) * dim_ + l)] * x[k] * x[l];
      }
    }
  }
  /// Voigt strain at a point, by hand.
  std::vector<double> strain(const double* x) const
  {
    const auto slope = [&](int i, int k) {
      double sum = H_[std::size_t(i * dim_ + k)];
      for (int l = 0; l < dim_; ++l)
        sum += (Q_[std::size_t((i * dim_ + k) * dim_ + l)] + Q_[std::size_t((i * dim_ + l) * dim_ + k)]) * x[l];
      return sum;
    };
    const double xy = slope(0, 1) + slope(1, 0);
    if (dim_ == 2)
      return {slope(0, 0), slope(1, 1), xy};
    return {slope(0, 0), slope(1, 1), slope(2, 2), xy, slope(1, 2) + slope(2, 1), slope(0, 2) + slope(2, 0)};
  }

private:
  int dim_;
  std::vector<double> H_, Q_;
};

/// Turned by `angle` about z.
inline void turn(double angle, double* x)
{
  const double c = std::cos(angle), s = std::sin(angle);
  const double y[2] = {c * x[0] - s * x[1], s * x[0] + c * x[1]};
  x[0] = y[0], x[1] = y[1];
}

} // namespace ndframe::test
