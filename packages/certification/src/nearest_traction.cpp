#include "nearest_traction.hpp"

#include <algorithm>
#include <cmath>

#include "interface_misfit.hpp"
#include "ndframe/admissibility/contact_nodes.hpp"

namespace ndframe
{
namespace
{

/// A projection that changes the traction by less, relative in L2, leaves nothing to gain.
constexpr double unchanged = 1e-4;
/// A step is taken for at least these parts of the squared distance, and of it and the squared misfit together.
constexpr double worthOfDistance = 0.015, worthOfAll = 0.001;
constexpr int mostSteps = 4;
/// Of the length that suits the smooth part of the first difference: rough parts want less.
constexpr double firstPart = 0.4;

/// Steps towards the least distance.
class TractionSearch
{
public:
  TractionSearch(const CertifiedScene& scene, const Admission& admission)
      : scene_(scene), admission_(admission), weights_(std::size_t(scene.condensed.interface.C->size()), 0.0)
  {
    for (const ContactPatch& patch : scene.patches)
      for (std::size_t i = 0; i < patch.numNodes(scene.order); ++i)
        weights_[std::size_t(patch.nodes[i])] += patch.measure * shareOf(patch.dim, scene.order, i);
  }

  /// A traction and what follows from it.
  struct Place
  {
    Vector traction, motion; ///< at the nodes: t, [u~ - u_h] . n_c
    IntermediateField field;
    double distance = 0.0, /**< |u~ - u_h|^2 in energy */ misfit = 0.0; ///< interfaceMisfit() squared

    double cost() const { return distance + misfit; }
  };

  Place at(Vector traction, IntermediateField field) const
  {
    Place place{std::move(traction), Vector(weights_.size(), 0.0), std::move(field)};
    if (place.field.displacement.empty())
      solveFields(scene_, {&place.field});
    for (const ContactPatch& patch : scene_.patches) {
      const auto here = patchOpening(scene_.bodies, patch, place.field.displacement),
                 there = patchOpening(scene_.bodies, patch, scene_.solved);
      for (std::size_t i = 0; i < patch.numNodes(scene_.order); ++i)
        place.motion[std::size_t(patch.nodes[i])] =
            dotProduct(patch.normalAt(i), here[i]) - dotProduct(patch.normalAt(i), there[i]);
    }
    place.distance = std::pow(changeInEnergy(scene_.bodies, scene_.solved, place.field.displacement), 2);
    place.misfit = std::pow(interfaceMisfit(scene_, place.field), 2);
    return place;
  }

  /// An admissible traction towards less distance.
  Vector nextTraction(const Place& from, double length) const
  {
    Vector wanted = from.traction;
    for (std::size_t i = 0; i < wanted.size(); ++i)
      wanted[i] -= length * from.motion[i];
    return admitNodal(scene_, wanted, admission_.sign, admission_.cost);
  }

  /// Barzilai and Borwein's step length for a change of the traction and of the motion; 0 when there is none.
  double length(const Vector& traction, const Vector& motion) const
  {
    const double work = product(traction, motion), square = product(motion, motion);
    return work > 0.0 && square > 0.0 ? work / square : 0.0;
  }

  /// In L2, by Simpson's rule.
  double product(const Vector& a, const Vector& b) const
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += weights_[i] * a[i] * b[i];
    return sum;
  }

private:
  const CertifiedScene& scene_;
  Admission admission_;
  Vector weights_;
};

} // namespace

IntermediateField fieldOf(const CertifiedScene& scene, const Vector& traction)
{
  const ContactTraction own = tractionFromNodes(scene.patches, traction, scene.order, scene.degree);
  return {{own, own}, {}};
}

IntermediateField nearestInEnergy(const CertifiedScene& scene, const Vector& computed, Vector admitted,
                                  IntermediateField field, const Admission& admission, Ledger& ledger)
{
  const TractionSearch search(scene, admission);
  const Vector moved = difference(admitted, computed);
  if (search.product(moved, moved) <= unchanged * unchanged * search.product(computed, computed))
    return field;
  TractionSearch::Place place = search.at(std::move(admitted), std::move(field));
  double least = place.cost(), length = firstPart * search.length(moved, place.motion);
  field = place.field;
  for (int taken = 0; taken < mostSteps && length > 0.0; ++taken) {
    const Vector next = search.nextTraction(place, length), change = difference(next, place.traction);
    const double expected = -search.product(change, place.motion);
    if (expected < std::max(worthOfDistance * place.distance, worthOfAll * place.cost()))
      break;
    TractionSearch::Place there = search.at(next, fieldOf(scene, next));
    ledger.count("traction steps");
    length = search.length(change, difference(there.motion, place.motion));
    place = std::move(there);
    if (place.cost() < least) {
      least = place.cost();
      field = place.field;
    }
  }
  return field;
}

} // namespace ndframe
