#include "coarse_tractions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/admissibility/facet_functions.hpp"
#include "ndframe/algebra/sparse_cholesky.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "ndframe/mesh/boundary.hpp"

namespace ndframe
{
namespace
{

/// With fewer pieces of every facet nothing is to be gained: sides that are about as fine as each other.
constexpr int worthwhile = 3;
/// A coarse facet may be covered in a small part: what is not seen there stays small.
constexpr double regularisation = 1e-9;

/// How far the centre of a facet is from an edge of the uncut mesh, by the edge's length.
double distanceFrom(const Mesh& base, const std::array<int, 2>& ends, const std::array<double, 3>& centre)
{
  const double *a = base.point(ends[0]), *b = base.point(ends[1]);
  const double along[] = {b[0] - a[0], b[1] - a[1]}, to[] = {centre[0] - a[0], centre[1] - a[1]};
  const double squared = along[0] * along[0] + along[1] * along[1];
  const double t = std::clamp((along[0] * to[0] + along[1] * to[1]) / squared, 0.0, 1.0);
  return std::hypot(to[0] - t * along[0], to[1] - t * along[1]) / std::sqrt(squared);
}

/// The facet of the uncut mesh that a facet is a part of: its vertices. An edge of the parent, unless bisection has
/// swapped edges between halves of two cells: then one of the boundary.
std::array<int, 2> uncutEnds(const BodyModel& body, Facet facet)
{
  constexpr double isOn = 1e-4; // sides are straight between the vertices of the uncut mesh
  const Mesh& base = body.uncut();
  const auto centre = facetCentre(body.mesh, facet);
  std::array<int, 2> best{};
  double least = HUGE_VAL;
  const auto consider = [&](int first, int second) {
    const std::array<int, 2> ends{std::min(first, second), std::max(first, second)};
    const double distance = distanceFrom(base, ends, centre);
    if (distance < least) {
      least = distance;
      best = ends;
    }
  };
  const int* vertices = base.cell(body.parents[std::size_t(facet.cell)]);
  for (std::size_t k = 0; k < 3; ++k)
    consider(vertices[k], vertices[(k + 1) % 3]);
  if (least < isOn)
    return best;
  for (const Facet boundary : boundaryFacets(base)) {
    int ends[3];
    facetVertices(base, boundary, ends);
    consider(ends[0], ends[1]);
  }
  return best;
}

/// In the plane polynomials on the uncut facets of one side of every interface that was cut there.
class CoarseTraces
{
public:
  CoarseTraces(const CertifiedScene& scene, std::size_t side) : scene_(scene), side_(side)
  {
    for (std::size_t f = 0; f < scene.patches.size(); ++f)
      if (const BodyModel& body = bodyOf(f); !body.parents.empty())
        add(f, body);
  }

  bool isWorthwhile() const
  {
    return std::any_of(numPieces_.begin(), numPieces_.end(),
                       [](const auto& entry) { return entry.second >= worthwhile; });
  }

  /// The nodal values of the nearest; where nothing was cut they stay.
  Vector nearest(const Vector& nodal) const
  {
    const std::size_t nodes = std::size_t(scene_.order) + 1;
    const DenseMatrix mass = nodalMass();
    SymmetricEntries matrix;
    matrix.size = int(unknowns_.size());
    Vector right(unknowns_.size(), 0.0);
    for (const Piece& piece : pieces_) {
      const ContactPatch& patch = scene_.patches[piece.patch];
      const DenseMatrix weighted = multiply(mass, piece.values);
      for (std::size_t j = 0; j < nodes; ++j) {
        for (std::size_t i = 0; i < nodes; ++i)
          right[piece.unknowns[j]] += patch.measure * weighted(int(i), int(j)) * nodal[std::size_t(patch.nodes[i])];
        for (std::size_t i = 0; i < nodes; ++i)
          if (piece.unknowns[i] <= piece.unknowns[j]) {
            double entry = 0.0;
            for (std::size_t k = 0; k < nodes; ++k)
              entry += piece.values(int(k), int(i)) * weighted(int(k), int(j));
            matrix.add(int(piece.unknowns[i]), int(piece.unknowns[j]),
                       patch.measure * (i == j ? (1.0 + regularisation) * entry : entry));
          }
      }
    }
    const Vector coarse = SparseCholesky(matrix).solve(right);
    Vector result = nodal;
    for (const Piece& piece : pieces_)
      for (std::size_t i = 0; i < nodes; ++i) {
        double value = 0.0;
        for (std::size_t j = 0; j < nodes; ++j)
          value += piece.values(int(i), int(j)) * coarse[piece.unknowns[j]];
        result[std::size_t(scene_.patches[piece.patch].nodes[i])] = value;
      }
    return result;
  }

private:
  struct Piece
  {
    std::size_t patch;
    std::array<std::size_t, 3> unknowns; ///< of the uncut facet: its vertices, its middle
    DenseMatrix values;                  ///< of their functions at the facet's nodes
  };

  const BodyModel& bodyOf(std::size_t f) const
  {
    return *scene_.bodies[std::size_t(scene_.patches[f].sides[side_].body)];
  }

  void add(std::size_t f, const BodyModel& body)
  {
    const PatchSide& side = scene_.patches[f].sides[side_];
    const auto ends = uncutEnds(body, side.facet);
    const double *a = body.base.point(ends[0]), *b = body.base.point(ends[1]);
    const auto nodes = contactNodes(body, side);
    ++numPieces_[{&body, ends[0], ends[1]}];
    Piece piece{f, {unknown(body, ends[0], -1), unknown(body, ends[1], -1), 0}, {scene_.order + 1, scene_.order + 1}};
    if (scene_.order == 2)
      piece.unknowns[2] = unknown(body, ends[0], ends[1]);
    const double squared = std::pow(b[0] - a[0], 2) + std::pow(b[1] - a[1], 2);
    for (int i = 0; i <= scene_.order; ++i) {
      const auto x = body.nodes.point(nodes[std::size_t(i)]);
      const double t = ((x[0] - a[0]) * (b[0] - a[0]) + (x[1] - a[1]) * (b[1] - a[1])) / squared;
      const std::array<double, 2> lambda{1.0 - t, t};
      std::array<double, 3> N{};
      facetFunctions(2, scene_.order, lambda.data(), N.data());
      for (int j = 0; j <= scene_.order; ++j)
        piece.values(i, j) = N[std::size_t(j)];
    }
    pieces_.push_back(std::move(piece));
  }

  /// The number of a vertex, or of the middle of two; its own for every interface.
  std::size_t unknown(const BodyModel& body, int first, int second)
  {
    return unknowns_.insert({{&body, first, second}, unknowns_.size()}).first->second;
  }

  DenseMatrix nodalMass() const
  {
    const QuadratureRule rule = simplexRule(1, 2 * scene_.order);
    DenseMatrix mass(scene_.order + 1, scene_.order + 1);
    std::array<double, 3> N{};
    for (int g = 0; g < rule.size(); ++g) {
      facetFunctions(2, scene_.order, rule.point(g), N.data());
      for (int i = 0; i <= scene_.order; ++i)
        for (int j = 0; j <= scene_.order; ++j)
          mass(i, j) += rule.weights[std::size_t(g)] * N[std::size_t(i)] * N[std::size_t(j)];
    }
    return mass;
  }

  const CertifiedScene& scene_;
  std::size_t side_;
  std::map<std::tuple<const BodyModel*, int, int>, std::size_t> unknowns_;
  std::map<std::tuple<const BodyModel*, int, int>, int> numPieces_; ///< per uncut facet
  std::vector<Piece> pieces_;
};

} // namespace

std::vector<Vector> tractionsOfSides(const CertifiedScene& scene, const Vector& nodal)
{
  std::vector<Vector> tractions{nodal};
  if (scene.patches.empty() || scene.patches.front().dim == 3) // there the recovery chooses the traction
    return tractions;
  for (std::size_t side = 0; side < 2; ++side)
    if (const CoarseTraces traces(scene, side); traces.isWorthwhile())
      tractions.push_back(traces.nearest(nodal));
  return tractions;
}

} // namespace ndframe
