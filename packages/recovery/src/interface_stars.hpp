#pragma once

#include <memory>

#include "interface_star.hpp"
#include "ndframe/base/ledger.hpp"
#include "ndframe/recovery/stress_recovery.hpp"

namespace ndframe
{

/// The stars of all interface vertices (2-D), each spanning both bodies: they choose the interface traction.
///
/// The bound holds for every traction t^ that is admissible (<= 0 in its Bernstein coefficients, in balance); among
/// these, what depends on t^ is  J = |c|^2 + 2 int t^ (u~1_N - u~2_N - g)  over both bodies (docs/theory.md). Vertex
/// after vertex the traction on the patches that meet there is changed so that J becomes least: a small quadratic
/// program (TractionStep). The traction stays admissible after every step, so any number of steps gives a bound.
///
/// Vertices are taken in the order in which they lie on the interface, so their numbers do not matter (unless an
/// interface is closed). Every rank does all of it.
class InterfaceStars
{
public:
  /// bodies: one for each body of the scene, null for rigid ones. Scene and bodies must outlive this.
  InterfaceStars(const RecoveryScene& scene, std::vector<const StarBody*> bodies);

  /// The traction of an initial pass: the energy of every star is its own. field: with `optimise`; its traction is the
  /// start. Three passes over the vertices; their steps are "interface stars" in the ledger.
  ContactTraction optimise(const SceneField& field, int threads, Ledger& ledger) const;

  /// One pass in which the energy is that of the whole correction, which changes with the traction: a part of a block
  /// Gauss-Seidel sweep, from both ends to the middle: mirrored scenes have mirrored tractions, as stars in the middle
  /// hardly differ. corrections: per body, of the field that opening and traction belong to.
  void sweep(const Vector& opening, ContactTraction& traction, const std::vector<StressCorrection*>& corrections,
             Ledger& ledger) const;

private:
  std::vector<TractionStep> firstSteps(const SceneField& field, const std::vector<std::unique_ptr<StarLoads>>& loads,
                                       int threads) const;

  const RecoveryScene& scene_;
  std::vector<const StarBody*> bodies_;
  std::vector<InterfaceVertex> vertices_;
};

} // namespace ndframe
