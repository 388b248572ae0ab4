#pragma once

#include "batched_shape.hpp"

// Part of the kernels' translation units (see lanes.hpp): what sigma~ leaves out of balance in a star.

namespace ndframe
{
namespace
{

/// The tractions of sigma~ on both spokes of a cell, at the vertex and at the other end, as forces.
struct SpokeTractions
{
  Vector2 here1, there1, here2, there2;

  /// stress: at the vertex, at the ends of d1 and d2.
  SpokeTractions(const Lanes* stress, Vector2 d1, Vector2 d2)
      : here1(traction(stress, -1.0 * turned(d1))), there1(traction(stress + 3, -1.0 * turned(d1))),
        here2(traction(stress, turned(d2))), there2(traction(stress + 6, turned(d2)))
  {}

  Lanes size() const
  {
    const auto sum = [](Vector2 a, Vector2 b) { return absolute(a.x) + absolute(a.y) + absolute(b.x) + absolute(b.y); };
    return sum(here1, there1) + sum(here2, there2);
  }
};

/// int div sigma~ over a cell of linear stress.
inline Vector2 divergence(const Lanes* stress, Vector2 d1, Vector2 d2)
{
  Lanes change1[3], change2[3];
  for (int i = 0; i < 3; ++i) {
    change1[i] = stress[3 + i] - stress[i];
    change2[i] = stress[6 + i] - stress[i];
  }
  return 0.5 * (traction(change2, turned(d1)) - traction(change1, turned(d2)));
}

/// Jumps of sigma~ n on the spokes, int div sigma~ in the cells, the forces in the star; one field.
template <int q>
void findJumps(const StarTables& tables, const StarBatch& batch, int k)
{
  constexpr int data = Sizes<q>::facetData;
  const Lanes* spokes = lanes(batch.spokes);
  Lanes* jumps = lanes(batch.jumps) + k * (batch.cells + 1) * data;
  Lanes scale{};
  for (int i = 0; i < (batch.cells + 1) * data; ++i)
    jumps[i] = Lanes{};
  const auto add = [&](int spoke, Vector2 here, Vector2 there) {
    for (int mode = 0; mode <= q; ++mode) {
      Lanes* jump = jumps + spoke * data + 2 * mode;
      store2(jump, load2(jump) + tables.shareHere[mode] * here + tables.shareThere[mode] * there);
    }
  };
  for (int c = 0; c < batch.cells; ++c) {
    const Lanes* stress = lanes(batch.stress) + (k * batch.cells + c) * 9;
    const Vector2 d1 = load2(spokes + 2 * c), d2 = load2(spokes + 2 * c + 2);
    const SpokeTractions tractions(stress, d1, d2);
    add(c, tractions.here1, tractions.there1);
    add(batch.closed && c + 1 == batch.cells ? 0 : c + 1, tractions.here2, tractions.there2);
    scale += tractions.size();
    store2(lanes(batch.divergence) + (k * batch.cells + c) * 2, divergence(stress, d1, d2));
  }
  lanes(batch.scale)[k] = scale;
}

} // namespace
} // namespace ndframe
