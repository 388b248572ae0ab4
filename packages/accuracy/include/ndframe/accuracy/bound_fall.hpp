#pragma once

namespace ndframe
{

/// What the bound falls by from mesh to mesh beside what the contributions predict, both as parts of the bound before.
///
/// In the plane the prediction is taken as it is. In space solutions are singular along edges, which predictions do not
/// know at first, and bounds fall by a power of the prediction that hardly changes from level to level: with second
/// order 0.4 to 0.55. With the exponents of edges it is 0.5 to 0.95 at first (0.75 on average), and then nearer to 1
/// from level to level, by half of what is missing (twelve runs on beams, plates and a Fichera corner).
///
/// The contributions on meshes made anew are predicted from means over neighbourhoods, which leaves a factor, however
/// far the bound falls: 0.9 to 1.2 where the exponents of edges are known, nearer to 1 from level to level. A power
/// cannot say that: on a last step that falls little, a factor of 1.1 would be a power of 0.2 (seven scenes, three
/// targets).
class BoundFall
{
public:
  /// dim: of space. degree: of the displacements.
  BoundFall(int dim, int degree) : power_(dim == 2 ? 1.0 : 1.0 / degree), inSpace_(dim == 3) {}

  double power() const; ///< of the prediction, in [0.4, 1.3]; 1 in the plane
  /// Of meshes made anew predictions see the scatter of measures that the bound hardly notices: it falls by more.
  void meshesAreMadeAnew()
  {
    most_ = 1.3;
    areMadeAnew_ = true;
  }
  /// Bound of the next mesh: before (predicted / before)^power in space, a multiple of `predicted` on meshes made anew
  /// around known edges, `predicted` in the plane. before: of this one.
  double expected(double before, double predicted) const;
  /// The prediction with which `wanted` is expected.
  double predicted(double before, double wanted) const;

  /// The bound of the mesh that expected() was asked about is `found`. No effect in the plane.
  void learn(double before, double predicted, double found);
  /// From now on predictions know of edges.
  void edgesBecameKnown();

private:
  bool isProportional() const { return areMadeAnew_ && knowsEdges_; }

  double power_, most_ = 1.0;
  double factor_ = 1.1; ///< of proportional bounds; what the first such meshes had on average
  bool inSpace_, knowsEdges_ = false, areMadeAnew_ = false;
};

} // namespace ndframe
