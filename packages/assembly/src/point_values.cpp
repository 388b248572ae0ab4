#include "ndframe/assembly/point_values.hpp"

#include <algorithm>
#include <limits>

#include "ndframe/algebra/shared_values.hpp"
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

/// Per point, whether this rank's cells count: they hold it, or none does and theirs is the first that it is least
/// outside of.
std::vector<char> answersFor(const std::vector<std::vector<PointInCell>>& places, const Comm& comm)
{
  Vector nearest;
  for (const auto& cells : places)
    nearest.push_back(cells.empty() ? -std::numeric_limits<double>::max() : -std::max(0.0, cells.front().outside));
  const Vector own = nearest;
  takeLargest(nearest, comm);
  Vector first;
  for (std::size_t i = 0; i < places.size(); ++i)
    first.push_back(!places[i].empty() && own[i] == nearest[i] ? -double(comm.rank()) : -double(comm.size()));
  takeLargest(first, comm);
  std::vector<char> answers;
  for (std::size_t i = 0; i < places.size(); ++i)
    answers.push_back(
        char(!places[i].empty() && own[i] == nearest[i] && (nearest[i] == 0.0 || first[i] == -double(comm.rank()))));
  return answers;
}

/// Means over all ranks, weighted with the measures of the cells that each has.
void takeMeans(std::vector<PointValues>& values, const Vector& weights, const Comm& comm)
{
  Vector sums;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sums.push_back(weights[i]);
    for (const double value : values[i].displacement)
      sums.push_back(weights[i] * value);
    for (const double value : values[i].stress)
      sums.push_back(weights[i] * value);
  }
  comm.sum(sums);
  auto next = sums.begin();
  for (PointValues& value : values) {
    const double weight = *next > 0.0 ? *next : 1.0;
    ++next;
    for (double& component : value.displacement)
      component = *next++ / weight;
    for (double& component : value.stress)
      component = *next++ / weight;
  }
}

/// Everything becomes the sum over all ranks.
void addOfRanks(const std::vector<Triple*>& parts, double& measure, const Comm& comm)
{
  Vector sums{measure};
  for (const Triple* const part : parts)
    sums.insert(sums.end(), part->begin(), part->end());
  comm.sum(sums);
  measure = sums.front();
  auto next = sums.begin() + 1;
  for (Triple* const part : parts)
    for (double& value : *part)
      value = *next++;
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

std::vector<PointValues> valuesAtPoints(const BodyModel& body, const Vector& displacement, const Vector& strained,
                                        const std::vector<std::vector<double>>& points, double tolerance,
                                        const Comm& comm)
{
  const auto places = cellsOfPoints(body.mesh, points, tolerance, body.share ? body.share->numOwnCells() : -1);
  const std::vector<char> answers = body.share ? answersFor(places, comm) : std::vector<char>(places.size(), 1);
  std::vector<PointValues> values(points.size());
  Vector weights(points.size(), 0.0);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (answers[i] != 0) {
      values[i] = valuesAt(body, displacement, strained, places[i]);
      for (const PointInCell& place : places[i])
        weights[i] += cellMeasure(body.mesh, place.cell);
    }
  if (body.share)
    takeMeans(values, weights, comm);
  return values;
}

SideIntegrals integrateSide(const BodyModel& body, const Side& side, const Vector& displacement, const Vector& strained,
                            const Comm& comm)
{
  const int dim = body.mesh.dim;
  const QuadratureRule rule = simplexRule(dim - 1, body.nodes.order + 1); // of the moment, and of the displacement
  SideIntegrals sum;
  Triple moment{}; // about the origin
  for (const Facet facet : side.facets) {
    if (body.share && facet.cell >= body.share->numOwnCells())
      continue;
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
  if (body.share)
    addOfRanks({&sum.centre, &sum.displacement, &sum.force, &moment}, sum.measure, comm);
  for (std::size_t k = 0; k < 3; ++k) {
    sum.centre[k] /= sum.measure;
    sum.displacement[k] /= sum.measure;
  }
  sum.moment = moment;
  add(sum.moment, -1.0, cross(sum.centre, sum.force));
  return sum;
}

} // namespace ndframe
