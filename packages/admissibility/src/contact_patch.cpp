#include "ndframe/admissibility/contact_patch.hpp"

#include <cmath>

#include "ndframe/equilibrium/moment_basis.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

Direction ContactPatch::normalAt(std::size_t node) const
{
  if (!turns)
    return normal;
  if (node < numVertices())
    return ends[node];
  const auto [a, b] = facetEdges(dim).ends[node - numVertices()];
  Direction middle{};
  for (std::size_t k = 0; k < 3; ++k)
    middle[k] = 0.5 * (ends[std::size_t(a)][k] + ends[std::size_t(b)][k]);
  return middle;
}

std::vector<BodyPatch> patchesOfBody(const std::vector<ContactPatch>& patches, int body)
{
  std::vector<BodyPatch> ofBody;
  for (std::size_t patch = 0; patch < patches.size(); ++patch)
    for (std::size_t side = 0; side < 2; ++side)
      if (patches[patch].sides[side].body == body)
        ofBody.push_back({patch, side});
  return ofBody;
}

int dimOf(const std::vector<ContactPatch>& patches)
{
  return patches.empty() ? 2 : patches.front().dim;
}

DenseMatrix modesInOrder(int dim, int degree, const std::array<int, 3>& places)
{
  constexpr double roundOff = 1e-13;
  const MomentBasis basis = facetBasis(dim, degree);
  const QuadratureRule rule = simplexRule(dim - 1, 2 * degree);
  DenseMatrix R(basis.size(), basis.size());
  Vector ours(std::size_t(basis.size())), other(ours.size());
  for (int q = 0; q < rule.size(); ++q) {
    std::array<double, 3> lambda{};
    for (std::size_t a = 0; a < std::size_t(dim); ++a)
      lambda[a] = rule.point(q)[places[a]];
    basis.values(rule.point(q), ours.data());
    basis.values(lambda.data(), other.data());
    for (int k = 0; k < R.rows(); ++k)
      for (int j = 0; j < R.cols(); ++j)
        R(k, j) += rule.weights[std::size_t(q)] * other[std::size_t(k)] * ours[std::size_t(j)];
  }
  for (int k = 0; k < R.rows(); ++k)
    for (int j = 0; j < R.cols(); ++j)
      if (std::abs(R(k, j) - std::round(R(k, j))) < roundOff)
        R(k, j) = std::round(R(k, j));
  return R;
}

const DenseMatrix& OrderedModes::operator()(const PatchSide& side)
{
  const auto found = found_.find(side.places);
  return found != found_.end() ? found->second
                               : found_.emplace(side.places, modesInOrder(dim_, degree_, side.places)).first->second;
}

} // namespace ndframe
