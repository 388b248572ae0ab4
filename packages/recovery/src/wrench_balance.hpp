#pragma once

#include "ndframe/equilibrium/star_data.hpp"
#include "stress_faces.hpp"

namespace ndframe
{

/// Brings the cells of stars into balance by wrenches that flow from cell to cell like a current: what a cell lacks is
/// a potential's difference to its neighbours (and to the supports) times a conductance, the area of the face squared
/// over the volumes beside it. Not the least energy, but near enough to begin with: one small factorisation a star.
class WrenchBalance
{
public:
  /// body: its number in faces.cells().
  WrenchBalance(int body, const StressFaces& faces);

  /// x (StarLoads::initial) of a star: jumps are divided evenly between their two cells, then every cell is balanced.
  /// Per field the norm of the wrench that nothing takes (moments over the star's size).
  Vector balance(const Star& star, StarFields& x) const;

private:
  struct Flow; ///< of one spoke

  std::vector<Flow> flows(const Star& star, double size) const;
  DenseMatrix imbalance(const Star& star, const StarFields& x, double size) const;
  static DenseMatrix freeMotions(const std::vector<Flow>& flows);
  const StressFace& faceOf(int cell, int facet) const;
  void share(const Star& star, const DenseMatrix& free, DenseMatrix& needed) const;
  static DenseMatrix conductances(int cells, const std::vector<Flow>& flows, const DenseMatrix& free, int components);
  static DenseMatrix potentials(int cells, const std::vector<Flow>& flows, const DenseMatrix& free,
                                const DenseMatrix& needed);
  static Vector leftOver(const DenseMatrix& needed, const DenseMatrix& free);
  static Vector amounts(const Flow& flow, const double* potentials, const Direction& vertex, double size);

  int number_;
  const StarBody* body_;
  const StressFaces* faces_;
  Vector volumes_;
  std::vector<Direction> centres_, loadArms_; ///< of the cells; per cell and load mode: mean of (x - centre) m_k
};

} // namespace ndframe
