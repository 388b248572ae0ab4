#pragma once

#include <algorithm>

namespace ndframe
{

/// What the bound falls by from mesh to mesh beside what the contributions predict, both as parts of the bound before.
///
/// In the plane the prediction is taken as it is. In space solutions are singular along edges, which predictions do not
/// know at first, and bounds fall by a power of the prediction that hardly changes from level to level: with second
/// order 0.4 to 0.55 before edges are known, 0.65 to 1 with their exponents (beams and a Fichera corner to 2 %). So the
/// power of the last step is half of the next one's.
class BoundFall
{
public:
  BoundFall(int dim, int degree) : power_(dim == 2 ? 1.0 : 1.0 / degree), inSpace_(dim == 3) {}

  double power() const { return power_; }
  double expected(double before, double predicted) const;
  /// The prediction with which `wanted` is expected.
  double predicted(double before, double wanted) const;

  void learn(double before, double predicted, double found);
  /// From now on predictions know of edges.
  void edgesBecameKnown() { power_ = std::max(power_, atKnownEdges); }

private:
  static constexpr double atKnownEdges = 0.7, least = 0.4;

  double power_;
  bool inSpace_;
};

} // namespace ndframe
