#include "ndframe/assembly/point_values.hpp"

#include <algorithm>

#include "ndframe/assembly/cell_field.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

using Triple = std::array<double, 3>;

Triple cross(const Triple& a, const Triple& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void add(Triple& sum, double factor, const Triple& values)
{
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] += factor * values[k];
}

Triple traction(const std::array<double, 6>& s, const double* n, int dim)
{
  const double z = dim == 3 ? n[2] : 0.0;
  Triple t{s[0] * n[0] + s[3] * n[1] + s[5] * z, s[3] * n[0] + s[1] * n[1] + s[4] * z,
           s[5] * n[0] + s[4] * n[1] + s[2] * z};
  if (dim == 2)
    t[2] = 0.0;
  return t;
}

template <int dim, int order>
PointValues valuesIn(const BodyModel& body, const Vector& displacement, const Vector& strained,
                     const PointInCell& place)
{
  constexpr int nodes = Lagrange<dim, order>::nodes;
  double N[nodes];
  Lagrange<dim, order>::values(place.lambda.data(), N);
  const CellField<dim, order> moved(body, displacement, place.cell), cell(body, strained, place.cell);
  PointValues values;
  for (int a = 0; a < nodes; ++a)
    for (int k = 0; k < dim; ++k)
      values.displacement[std::size_t(k)] += N[a] * moved.u[a * dim + k];
  values.stress = cell.fullStress(place.lambda.data());
  return values;
}

/// Barycentric coordinates in the cell of a point of its facet.
PointInCell onFacet(Facet facet, int dim, const double* lambda)
{
  PointInCell place;
  place.cell = facet.cell;
  for (int v = 0; v <= dim; ++v)
    if (v != facet.local)
      place.lambda[std::size_t(v)] = *lambda++;
  return place;
}

Triple tripleOf(const std::vector<double>& point)
{
  Triple all{};
  std::copy(point.begin(), point.end(), all.begin());
  return all;
}

} // namespace

Triple SideIntegrals::momentAbout(const Triple& point) const
{
  Triple arm{}, about = moment;
  for (std::size_t k = 0; k < arm.size(); ++k)
    arm[k] = centre[k] - point[k];
  add(about, 1.0, cross(arm, force));
  return about;
}

PointValues valuesAt(const BodyModel& body, const Vector& displacement, const Vector& strained,
                     const std::vector<PointInCell>& places)
{
  PointValues mean;
  double total = 0.0;
  for (const PointInCell& place : places)
    total += cellMeasure(body.mesh, place.cell);
  for (const PointInCell& place : places) {
    const PointValues values = withDimAndOrder(body.mesh.dim, body.nodes.order, [&](auto d, auto p) {
      return valuesIn<d(), p()>(body, displacement, strained, place);
    });
    const double weight = cellMeasure(body.mesh, place.cell) / total;
    add(mean.displacement, weight, values.displacement);
    for (std::size_t i = 0; i < mean.stress.size(); ++i)
      mean.stress[i] += weight * values.stress[i];
  }
  return mean;
}

SideIntegrals integrateSide(const BodyModel& body, const Side& side, const Vector& displacement, const Vector& strained)
{
  const int dim = body.mesh.dim;
  const QuadratureRule rule = simplexRule(dim - 1, body.nodes.order + 1); // of the moment, and of the displacement
  SideIntegrals sum;
  Triple moment{}; // about the origin
  for (const Facet facet : side.facets) {
    double normal[3] = {};
    const double measure = facetNormal(body.mesh, facet, normal);
    for (int q = 0; q < rule.size(); ++q) {
      const PointInCell place = onFacet(facet, dim, rule.point(q));
      const double weight = measure * rule.weights[std::size_t(q)];
      const PointValues values = valuesAt(body, displacement, strained, {place});
      const Triple x = tripleOf(pointAt(body.mesh, place)), t = traction(values.stress, normal, dim);
      sum.measure += weight;
      add(sum.centre, weight, x);
      add(sum.displacement, weight, values.displacement);
      add(sum.force, weight, t);
      add(moment, weight, cross(x, t));
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    sum.centre[k] /= sum.measure;
    sum.displacement[k] /= sum.measure;
  }
  sum.moment = moment;
  add(sum.moment, -1.0, cross(sum.centre, sum.force));
  return sum;
}

} // namespace ndframe
