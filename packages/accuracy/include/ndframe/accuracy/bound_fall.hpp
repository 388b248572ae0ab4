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
  /// dim: of space. degree: of the displacements.
  BoundFall(int dim, int degree) : power_(dim == 2 ? 1.0 : 1.0 / degree), inSpace_(dim == 3) {}

  double power() const { return power_; } ///< of the prediction, in [0.4, 1]; 1 in the plane
  /// Of meshes made anew predictions see the scatter of measures that the bound hardly notices: it falls by more.
  void meshesAreMadeAnew() { most_ = 1.3; }
  /// Bound of the next mesh: before (predicted / before)^power in space, `predicted` in the plane. before: of this one.
  double expected(double before, double predicted) const;
  /// The prediction with which `wanted` is expected.
  double predicted(double before, double wanted) const;

  /// The bound of the mesh that expected() was asked about is `found`. No effect in the plane.
  void learn(double before, double predicted, double found);
  /// From now on predictions know of edges.
  void edgesBecameKnown();

private:
  double power_, most_ = 1.0;
  bool inSpace_, knowsEdges_ = false;
};

} // namespace ndframe
