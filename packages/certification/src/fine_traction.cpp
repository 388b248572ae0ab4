#include "fine_traction.hpp"

#include <algorithm>

#include "ndframe/fem/quadrature.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{
namespace
{

/// An edge of the Dirichlet body, from its first to its second ascending vertex.
struct Line
{
  const double *start, *end;

  Line(const Model& model, const ContactFacet& facet)
  {
    const Mesh& mesh = model.bodies[std::size_t(facet.dirichletBody)].mesh;
    int vertices[2];
    facetVertices(mesh, facet.dirichlet, vertices);
    start = mesh.point(std::min(vertices[0], vertices[1]));
    end = mesh.point(std::max(vertices[0], vertices[1]));
  }

  /// Where a point of the line lies: 0 at the start, 1 at the end.
  double position(const double* x) const
  {
    double along = 0.0, squared = 0.0;
    for (int k = 0; k < 2; ++k) {
      along += (x[k] - start[k]) * (end[k] - start[k]);
      squared += (end[k] - start[k]) * (end[k] - start[k]);
    }
    return along / squared;
  }
};

/// 1/|f| sum_k T_k L_k at a position along the facet.
double tractionAt(const MomentBasis& basis, const Vector& moments, double measure, double position)
{
  const double lambda[2] = {1.0 - position, position};
  Vector L(moments.size());
  basis.values(lambda, L.data());
  return dot(moments, L) / measure;
}

} // namespace

ContactTraction onFineFacets(const Model& coarseModel, const std::vector<ContactFacet>& coarse,
                             const ContactTraction& traction, const Model& fineModel,
                             const std::vector<ContactFacet>& fine)
{
  const MomentBasis basis = facetBasis(2, traction.degree);
  const QuadratureRule rule = simplexRule(1, 2 * traction.degree);
  const std::size_t modes = std::size_t(basis.size()), pieces = coarse.empty() ? 1 : fine.size() / coarse.size();
  ContactTraction result{traction.degree, Vector(fine.size() * 2 * modes, 0.0)};
  Vector L(modes);
  for (std::size_t f = 0; f < fine.size(); ++f) {
    const ContactFacet& parent = coarse[f / pieces];
    const Line whole(coarseModel, parent), piece(fineModel, fine[f]);
    const Vector moments = traction.moments(int(f / pieces));
    const double first = whole.position(piece.start), last = whole.position(piece.end);
    for (int g = 0; g < rule.size(); ++g) {
      const double* lambda = rule.point(g);
      const double t = tractionAt(basis, moments, parent.measure, lambda[0] * first + lambda[1] * last);
      basis.values(lambda, L.data());
      for (std::size_t k = 0; k < modes; ++k)
        result.shares[f * 2 * modes + k] += fine[f].measure * rule.weights[std::size_t(g)] * t * L[k];
    }
  }
  return result;
}

} // namespace ndframe
