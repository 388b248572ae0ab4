#include "ndframe/admissibility/contact_oscillation.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/admissibility/turning_normal.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/simd/cell_distances.hpp"
#include "oscillation.hpp"

namespace ndframe
{
namespace
{

/// Of stresses.
int richestDegree(int dim)
{
  return dim == 2 ? 3 : 2;
}

constexpr double roundOff = 1e-13;

/// `dim` components, mode by mode, as columns.
DenseMatrix byModes(const Vector& components, int dim)
{
  DenseMatrix columns(int(components.size()) / dim, dim);
  for (int k = 0; k < columns.rows(); ++k)
    for (int i = 0; i < dim; ++i)
      columns(k, i) = components[std::size_t(dim) * std::size_t(k) + std::size_t(i)];
  return columns;
}

/// One body's part.
class BodyOscillation
{
public:
  explicit BodyOscillation(const BodyModel& body)
      : body_(body), dim_(body.mesh.dim), richest_(numFacetModes(dim_, richestDegree(dim_))),
        beyond_(std::size_t(body.mesh.numCells()), 0.0)
  {}

  /// rest: moments along the patch in the body's own modes, `dim` components. Linear modes, the first `dim`, are
  /// carried: what is there is round-off. size: of t n.
  void add(const ContactPatch& patch, std::size_t side, const DenseMatrix& rest, double size)
  {
    double below = 0.0, above = 0.0;
    for (int i = 0; i < dim_; ++i)
      for (int k = dim_; k < rest.rows(); ++k)
        (k < richest_ ? below : above) += rest(k, i) * rest(k, i);
    if (std::sqrt(below) > roundOff * size)
      lift(patch.sides[side].facet, sideSign(side), rest);
    if (above > 0.0) {
      const Facet facet = patch.sides[side].facet;
      double normal[3];
      const double measure = side == 0 || !patch.isDrawnApart ? patch.measure : facetNormal(body_.mesh, facet, normal);
      beyond_[std::size_t(facet.cell)] += shareBeyondPolynomials(dim_, richestDegree(dim_)) *
                                          facetOscillationConstant(body_.mesh, facet) * std::sqrt(above / measure);
    }
  }

  Vector squares() const
  {
    if (body_.isRigid)
      return beyond_;
    Vector result = lifted_.tractions.empty() ? Vector(beyond_.size(), 0.0) : cellDistances(body_, lifted_, nullptr);
    const Vector stiffness = smallestStiffness(body_.laws);
    for (std::size_t cell = 0; cell < result.size(); ++cell)
      result[cell] = std::pow(
          std::sqrt(result[cell]) + beyond_[cell] / std::sqrt(stiffness[std::size_t(body_.laws.number(int(cell)))]), 2);
    return result;
  }

private:
  void lift(Facet facet, double sign, const DenseMatrix& rest)
  {
    if (lifted_.tractions.empty())
      lifted_ = zeroCorrection(body_.mesh, richestDegree(dim_));
    const auto dim = std::size_t(dim_);
    const std::size_t place = std::size_t(facet.cell) * (dim + 1) + std::size_t(sortedFacet(body_.mesh, facet));
    double* traction = lifted_.tractions.data() + place * dim * std::size_t(richest_);
    for (int k = dim_; k < std::min(rest.rows(), richest_); ++k)
      for (int i = 0; i < dim_; ++i)
        traction[dim_ * k + i] += sign * rest(k, i);
  }

  const BodyModel& body_;
  int dim_, richest_;       ///< of space; modes that a stress carries
  StressCorrection lifted_; ///< carries the rest; empty as long as there is none
  Vector beyond_;           ///< per cell, of higher degree
};

} // namespace

std::vector<CellValues> contactOscillation(const std::vector<const BodyModel*>& bodies,
                                           const std::vector<ContactPatch>& patches, const ContactTraction& traction)
{
  if (traction.vectors.empty())
    return {};
  std::vector<BodyOscillation> parts;
  for (const BodyModel* body : bodies)
    parts.emplace_back(*body);
  const int dim = traction.dim, fine = std::max(traction.degree + 1, richestDegree(dim));
  const EndTables modes = turningModes(dim, traction.degree, fine);
  OrderedModes inOrder(dim, fine);
  const std::size_t carried = traction.numModes() * std::size_t(dim);
  for (std::size_t f = 0; f < patches.size(); ++f) {
    const ContactPatch& patch = patches[f];
    if (!patch.turns)
      continue;
    Vector rest = turned(modes, patch, traction.moments(int(f)));
    const double size = norm(rest);
    for (std::size_t i = 0; i < std::size_t(dim) * carried; ++i)
      rest[i % carried] -= traction.vectors[f * std::size_t(dim) * carried + i];
    if (norm(rest) <= roundOff * size)
      continue;
    for (std::size_t side = 0; side < 2; ++side)
      if (const auto body = std::size_t(patch.sides[side].body); !bodies[body]->isRigid)
        parts[body].add(patch, side, multiply(inOrder(patch.sides[side]), byModes(rest, dim)), size);
  }
  std::vector<CellValues> squares;
  for (const BodyOscillation& part : parts)
    squares.push_back(ofCells(part.squares()));
  return squares;
}

} // namespace ndframe
