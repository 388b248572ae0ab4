#include "contact_at_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ndframe/fem/lagrange.hpp"

namespace ndframe
{
namespace
{

using Triple = std::array<double, 3>;

double dot3(const Triple& a, const Triple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple difference(const double* a, const double* b, int dim)
{
  Triple d{};
  for (int k = 0; k < dim; ++k)
    d[std::size_t(k)] = a[k] - b[k];
  return d;
}

/// The point of a segment or triangle that is near another one: its barycentric coordinates and its distance.
struct NearFacet
{
  std::array<double, 3> lambda{};
  double distance = std::numeric_limits<double>::infinity();
};

/// The foot of the perpendicular, moved into the facet along its coordinates: exact for points on it, which are looked
/// for.
NearFacet nearestIn(const std::array<const double*, 3>& x, const std::vector<double>& point, int dim)
{
  const Triple a = difference(x[1], x[0], dim), d = difference(point.data(), x[0], dim);
  NearFacet near;
  if (dim == 2) {
    near.lambda[1] = dot3(a, d) / dot3(a, a);
  } else {
    const Triple b = difference(x[2], x[0], dim);
    const double aa = dot3(a, a), ab = dot3(a, b), bb = dot3(b, b), determinant = aa * bb - ab * ab;
    near.lambda[1] = (bb * dot3(a, d) - ab * dot3(b, d)) / determinant;
    near.lambda[2] = (aa * dot3(b, d) - ab * dot3(a, d)) / determinant;
  }
  near.lambda[0] = 1.0 - near.lambda[1] - near.lambda[2];
  double sum = 0.0;
  for (double& lambda : near.lambda)
    sum += lambda = std::max(0.0, lambda);
  for (double& lambda : near.lambda)
    lambda /= sum;
  double squared = 0.0;
  for (int k = 0; k < dim; ++k) {
    double foot = 0.0;
    for (std::size_t v = 0; v < std::size_t(dim); ++v)
      foot += near.lambda[v] * x[v][k];
    squared += std::pow(foot - point[std::size_t(k)], 2);
  }
  near.distance = std::sqrt(squared);
  return near;
}

std::vector<double> basisAt(const InterfaceMesh& interface, const std::array<double, 3>& lambda)
{
  return withDimAndOrder(interface.dim, interface.order, [&](auto d, auto p) {
    using Basis = Lagrange<d() - 1, p()>;
    std::vector<double> values(std::size_t(Basis::nodes), 0.0);
    Basis::values(lambda.data(), values.data());
    return values;
  });
}

/// The facet of an interface nearest to a point of one of its bodies, on the body's side (the nearer one where it
/// touches itself); -1 if none is within the tolerance.
int nearestFacet(const InterfaceMesh& interface, int body, const std::vector<double>& point, double tolerance,
                 NearFacet& nearest)
{
  int best = -1;
  for (const ContactRole role : bothRoles)
    for (int f = 0; f < interface.numFacets() && interface.side(role).body == body; ++f) {
      std::array<const double*, 3> x{};
      for (std::size_t v = 0; v < std::size_t(interface.dim); ++v)
        x[v] = interface.pointOf(role, interface.nodesOf(f)[v]);
      const NearFacet near = nearestIn(x, point, interface.dim);
      if (near.distance > tolerance || near.distance >= nearest.distance)
        continue;
      nearest = near;
      best = f;
    }
  return best;
}

} // namespace

double ContactPlace::value(const std::vector<ContactNode>& contact, double ContactNode::*values) const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    sum += weights[i] * contact[nodes[i]].*values;
  return sum;
}

std::vector<ContactPlace> contactPlaces(const Model& model, int body, const std::vector<double>& point,
                                        double tolerance)
{
  std::vector<ContactPlace> places;
  std::size_t firstNode = 0;
  for (const InterfaceMesh& interface : model.interfaces) {
    NearFacet nearest;
    const int facet = nearestFacet(interface, body, point, tolerance, nearest);
    if (facet >= 0) {
      ContactPlace place;
      place.weights = basisAt(interface, nearest.lambda);
      for (std::size_t a = 0; a < place.weights.size(); ++a)
        place.nodes.push_back(firstNode + std::size_t(interface.facets[std::size_t(facet) * place.weights.size() + a]));
      places.push_back(std::move(place));
    }
    firstNode += std::size_t(interface.numNodes());
  }
  return places;
}

} // namespace ndframe
