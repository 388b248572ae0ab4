#include "ndframe/equilibrium/star_wrench.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/assembly/constraint_set.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

Direction cross(const Direction& a, const Direction& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Direction scaled(const Direction& a, double factor)
{
  return {factor * a[0], factor * a[1], factor * a[2]};
}

Direction sum(const Direction& a, const Direction& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Direction armOf(const Vector& arms, int mode, int dim)
{
  Direction arm{};
  std::copy_n(arms.data() + std::ptrdiff_t(mode) * dim, dim, arm.begin());
  return arm;
}

/// The linear tractions T_1, .., T_{dim-1} of a facet:  sum_k r_k x T_k = M.
class LinearTractions
{
public:
  LinearTractions(int dim, const Vector& arms) : dim_(dim), r1_(armOf(arms, 1, dim))
  {
    along_ = scaled(r1_, 1.0 / std::sqrt(dotProduct(r1_, r1_)));
    if (dim == 2) {
      across_ = cross({0.0, 0.0, 1.0}, along_);
      return;
    }
    r2_ = armOf(arms, 2, dim);
    across_ = sum(r2_, scaled(along_, -dotProduct(r2_, along_)));
    across_ = scaled(across_, 1.0 / std::sqrt(dotProduct(across_, across_)));
    normal_ = cross(along_, across_);
  }

  /// The smallest tractions with moment M, written to T (mode by mode, from mode 1).
  ///
  /// In the frame (e1, e2, n), r_k = sum_j B_jk e_j, the moment is sum_j e_j x T'_j with T'_j = sum_k B_jk T_k.
  void withMoment(const Direction& M, double* T) const
  {
    if (dim_ == 2) {
      std::copy_n(scaled(across_, M[2] / dotProduct(r1_, along_)).begin(), 2, T);
      return;
    }
    const double twist = 0.5 * dotProduct(M, normal_);
    const Direction first = sum(scaled(normal_, -dotProduct(M, across_)), scaled(across_, twist));
    const Direction second = sum(scaled(normal_, dotProduct(M, along_)), scaled(along_, -twist));
    const Direction T2 = scaled(second, 1.0 / dotProduct(r2_, across_));
    const Direction T1 = scaled(sum(first, scaled(T2, -dotProduct(r2_, along_))), 1.0 / dotProduct(r1_, along_));
    std::copy_n(T1.begin(), 3, T);
    std::copy_n(T2.begin(), 3, T + 3);
  }

  /// Those without a moment: (r_1, 0), (0, r_2), (r_2, r_1), of unit norm; one in 2-D. Returns (T_1, T_2) one by one.
  std::vector<std::pair<Direction, Direction>> withoutMoment() const
  {
    constexpr Direction zero{};
    if (dim_ == 2)
      return {{along_, zero}};
    const Direction other = scaled(r2_, 1.0 / std::sqrt(dotProduct(r2_, r2_)));
    const double size = std::sqrt(dotProduct(r1_, r1_) + dotProduct(r2_, r2_));
    return {{along_, zero}, {zero, other}, {scaled(r2_, 1.0 / size), scaled(r1_, 1.0 / size)}};
  }

private:
  int dim_;
  Direction r1_, r2_{}, along_{}, across_{}, normal_{};
};

} // namespace

DenseMatrix wrenchMap(int dim, const Vector& arms, int modes, double size)
{
  DenseMatrix map(wrenchSize(dim), modes * dim);
  for (int i = 0; i < dim; ++i)
    map(i, i) = 1.0;
  for (int k = 0; k < modes; ++k)
    for (int i = 0; i < dim; ++i) {
      Direction unit{};
      unit[std::size_t(i)] = 1.0 / size;
      const Direction moment = cross(armOf(arms, k, dim), unit);
      for (int m = dim; m < wrenchSize(dim); ++m)
        map(m, k * dim + i) = dim == 2 ? moment[2] : moment[std::size_t(m - dim)];
    }
  return map;
}

void addWrench(int dim, const Vector& arms, const double* T, double sign, double size, Vector& wrench)
{
  const auto components = std::size_t(dim);
  for (std::size_t at = 0; at < arms.size(); at += components) {
    Direction force{}, arm{};
    for (std::size_t i = 0; i < components; ++i) {
      force[i] = sign * T[at + i];
      arm[i] = arms[at + i] / size;
    }
    for (std::size_t i = 0; i < components && at == 0; ++i) // the first function is one, the others have no mean
      wrench[i] += force[i];
    const Direction moment = cross(arm, force);
    for (std::size_t m = components; m < wrench.size(); ++m)
      wrench[m] += dim == 2 ? moment[2] : moment[m - components];
  }
}

Vector wrenchAbout(int dim, Vector wrench, const Vector& from, const Vector& to, double size)
{
  Direction arm{}, force{};
  for (std::size_t i = 0; i < std::size_t(dim); ++i) {
    arm[i] = (from[i] - to[i]) / size;
    force[i] = wrench[i];
  }
  const Direction moment = cross(arm, force);
  for (int m = dim; m < wrenchSize(dim); ++m)
    wrench[std::size_t(m)] += dim == 2 ? moment[2] : moment[std::size_t(m - dim)];
  return wrench;
}

Vector meanCoordinates(const MomentBasis& basis)
{
  const int corners = basis.dim() + 1;
  const QuadratureRule rule = simplexRule(basis.dim(), 4);
  Vector means(std::size_t(basis.size()) * std::size_t(corners), 0.0), values(std::size_t(basis.size()), 0.0);
  Vector lambda(std::size_t(corners), 0.0);
  // Over the sub-cells of the split simplex: the basis may jump between them.
  for (int sub = 0; sub < corners; ++sub)
    for (int p = 0; p < rule.size(); ++p) {
      const double* local = rule.point(p);
      for (int v = 0; v < corners; ++v)
        lambda[std::size_t(v)] = (v == sub ? 0.0 : local[v]) + local[sub] / corners;
      basis.values(lambda.data(), values.data());
      const double weight = rule.weights[std::size_t(p)] / corners;
      for (int k = 0; k < basis.size(); ++k)
        for (int v = 0; v < corners; ++v)
          means[std::size_t(k) * std::size_t(corners) + std::size_t(v)] +=
              weight * values[std::size_t(k)] * lambda[std::size_t(v)];
    }
  return means;
}

std::vector<const double*> corners(const Mesh& mesh, const SortedCell& cell, int facet)
{
  std::vector<const double*> points;
  points.reserve(std::size_t(mesh.dim) + 1);
  for (int v = 0; v <= mesh.dim; ++v)
    if (v != facet)
      points.push_back(mesh.point(cell.vertices[std::size_t(v)]));
  return points;
}

Vector momentArms(const Vector& means, const std::vector<const double*>& vertices, const double* a, int dim)
{
  const std::size_t corners = vertices.size(), modes = means.size() / corners;
  Vector arms(modes * std::size_t(dim), 0.0);
  for (std::size_t k = 0; k < modes; ++k)
    for (std::size_t v = 0; v < corners; ++v)
      for (int i = 0; i < dim; ++i)
        arms[k * std::size_t(dim) + std::size_t(i)] += means[k * corners + v] * (vertices[v][i] - a[i]);
  return arms;
}

FacetSplit splitFacet(int dim, const Vector& arms, int modes, double size)
{
  const int data = modes * dim, wrench = wrenchSize(dim);
  const LinearTractions linear(dim, arms);
  FacetSplit split{wrenchMap(dim, arms, modes, size), DenseMatrix(data, wrench), DenseMatrix(data, data - wrench)};
  for (int i = 0; i < wrench; ++i) {
    Direction moment{}, force{};
    if (i < dim) {
      force[std::size_t(i)] = split.carrier(i, i) = 1.0;
      moment = cross(force, armOf(arms, 0, dim)); // takes away the moment of the force at the centre
    } else
      moment[dim == 2 ? 2 : std::size_t(i - dim)] = size;
    linear.withMoment(moment, split.carrier.col(i) + dim);
  }
  int column = 0;
  for (const auto& [first, second] : linear.withoutMoment()) {
    std::copy_n(first.begin(), dim, split.modes.col(column) + dim);
    if (dim == 3)
      std::copy_n(second.begin(), dim, split.modes.col(column) + std::ptrdiff_t(2) * dim);
    ++column;
  }
  for (int row = dim * dim; row < data; ++row)
    split.modes(row, column++) = 1.0;
  return split;
}

} // namespace ndframe
