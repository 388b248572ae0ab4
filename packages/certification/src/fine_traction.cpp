#include "fine_traction.hpp"

#include <algorithm>

#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{
namespace
{

/// A patch by its vertices in the Dirichlet body.
class Flat
{
public:
  Flat(const Model& model, const ContactPatch& patch) : dim_(std::size_t(patch.dim))
  {
    const BodyModel& body = model.bodies[std::size_t(patch.sides[0].body)];
    const FacetNodes nodes = contactNodes(body, patch.sides[0]);
    for (std::size_t a = 0; a < dim_; ++a)
      std::copy_n(body.mesh.point(nodes[a]), patch.dim, corners_[a].begin());
  }

  const Direction& corner(std::size_t a) const { return corners_[a]; }

  /// Barycentric coordinates of a point of its line or plane: least squares.
  std::array<double, 3> locate(const Direction& x) const
  {
    const Direction e = minus(corners_[1], corners_[0]), f = minus(corners_[2], corners_[0]), d = minus(x, corners_[0]);
    if (dim_ == 2) {
      const double t = dotProduct(d, e) / dotProduct(e, e);
      return {1.0 - t, t, 0.0};
    }
    const double ee = dotProduct(e, e), ef = dotProduct(e, f), ff = dotProduct(f, f), de = dotProduct(d, e),
                 df = dotProduct(d, f), det = ee * ff - ef * ef;
    const double s = (ff * de - ef * df) / det, t = (ee * df - ef * de) / det;
    return {1.0 - s - t, s, t};
  }

private:
  static Direction minus(const Direction& a, const Direction& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

  std::size_t dim_;
  std::array<Direction, 3> corners_{};
};

/// 1/|f| sum_k T_k L_k at a point of the patch.
double tractionAt(const MomentBasis& basis, const Vector& moments, double measure, const double* lambda)
{
  Vector L(moments.size());
  basis.values(lambda, L.data());
  return dot(moments, L) / measure;
}

} // namespace

ContactTraction onFinePatches(const Model& coarseModel, const std::vector<ContactPatch>& coarse,
                              const ContactTraction& traction, const Model& fineModel,
                              const std::vector<ContactPatch>& fine)
{
  const MomentBasis basis = facetBasis(traction.dim, traction.degree);
  const QuadratureRule rule = simplexRule(traction.dim - 1, 2 * traction.degree);
  const std::size_t modes = traction.numModes(), pieces = coarse.empty() ? 1 : fine.size() / coarse.size(),
                    dim = std::size_t(traction.dim);
  ContactTraction result{traction.degree, Vector(fine.size() * dim * modes, 0.0), {}, traction.dim};
  Vector L(modes);
  for (std::size_t f = 0; f < fine.size(); ++f) {
    const ContactPatch& parent = coarse[f / pieces];
    const Flat whole(coarseModel, parent), piece(fineModel, fine[f]);
    const Vector moments = traction.moments(int(f / pieces));
    std::array<std::array<double, 3>, 3> corners{};
    for (std::size_t a = 0; a < dim; ++a)
      corners[a] = whole.locate(piece.corner(a));
    for (int g = 0; g < rule.size(); ++g) {
      const double* lambda = rule.point(g);
      std::array<double, 3> place{};
      for (std::size_t a = 0; a < dim; ++a)
        for (std::size_t i = 0; i < dim; ++i)
          place[i] += lambda[a] * corners[a][i];
      const double t = tractionAt(basis, moments, parent.measure, place.data());
      basis.values(lambda, L.data());
      for (std::size_t k = 0; k < modes; ++k)
        result.shares[result.first(f, 0) + k] += fine[f].measure * rule.weights[std::size_t(g)] * t * L[k];
    }
  }
  return result;
}

} // namespace ndframe
