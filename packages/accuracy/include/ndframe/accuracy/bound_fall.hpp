#pragma once

namespace ndframe
{

/// What the bound falls by from mesh to mesh beside what the contributions predict, both as parts of the bound before.
///
/// In the plane the prediction is taken as it is. In space solutions are singular along edges, which predictions do not
/// know at first, and bounds fall by a power of the prediction that hardly changes from level to level: with second
/// order 0.4 to 0.55. With the exponents of edges it is 0.5 to 0.95 at first (0.75 on average), and then nearer to 1
/// from level to level, by half of what is missing (twelve runs on beams, plates and a Fichera corner).
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
  void edgesBecameKnown();

private:
  double power_;
  bool inSpace_, knowsEdges_ = false;
};

} // namespace ndframe
