#pragma once

#include "stress_blocks.hpp"

namespace ndframe
{

/// The tractions that unknowns (StressBlocks) stand for, and the transposed map.
class StressUnknowns
{
public:
  /// All must outlive it.
  StressUnknowns(const StressFaces& faces, const std::vector<StressEdge>& edges, const StressBlocks& blocks);

  /// T per face, on its first cell.
  Vector tractions(const Vector& unknowns, int threads) const;
  /// By the unknowns, from that by the faces' tractions.
  Vector gradient(const Vector& faceForces, int threads) const;

private:
  void addTractions(int face, const Vector& unknowns, double* T) const;

  const StressFaces& faces_;
  const std::vector<StressEdge>& edges_;
  const StressBlocks& blocks_;
  FaceRings rings_;
};

} // namespace ndframe
