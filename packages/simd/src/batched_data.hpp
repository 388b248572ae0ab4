#pragma once

#include "batched_jumps.hpp"

// Part of the kernels' translation units (see lanes.hpp): what the cells of a star carry before its unknowns are found.

namespace ndframe
{
namespace
{

/// Wrench about the star's vertex and self-equilibrated modes of a traction on a spoke d.
template <int q>
void decompose(Vector2 d, double arm, const Vector2* T, Lanes* w, Lanes* s)
{
  const Lanes inverse = 1.0 / dot(d, d);
  store2(w, T[0]);
  w[2] = cross(d, 0.5 * T[0] + arm * T[1]);
  s[0] = inverse * dot(d, T[1]);
  for (int k = 2; k <= q; ++k) {
    s[2 * k - 3] = inverse * dot(d, T[k]);
    s[2 * k - 2] = inverse * cross(d, T[k]);
  }
}

/// Loads G = - share of (b + div sigma~) in reference axes; returns their wrench's force in reference axes.
inline Vector2 findLoads(const StarBatch& batch, const CellShape& shape, int k, int c, Lanes* load)
{
  const LoadModes& modes = *batch.loads;
  const Vector2 total = load2(lanes(batch.divergence) + (k * batch.cells + c) * 2);
  Vector2 force{};
  for (int mode = 0; mode < modes.modes; ++mode) {
    Vector2 share = modes.share[mode] * total;
    if (batch.bodyLoad != nullptr)
      share = share + load2(lanes(batch.bodyLoad) + (c * modes.modes + mode) * 2);
    const Vector2 reference = -1.0 * shape.pullBack(share);
    lanes(batch.scale)[k] += absolute(share.x) + absolute(share.y);
    store2(load + 2 * mode, reference);
    force = force + modes.force[mode] * reference;
  }
  return force;
}

/// The part of the second spoke's tangential moment mode that the loads' wrench brings along.
inline Lanes bendOfLoads(const LoadModes& modes, const CellShape& shape, const Lanes* load)
{
  Lanes bend{};
  for (int i = 0; i < 2 * modes.modes; ++i)
    bend += modes.bend[i] * load[i];
  return shape.slant2() * bend;
}

/// Initial pass: going round the star, the wrench through each spoke is the one before plus jump and load.
template <int q>
void prepare(const StarTables& tables, const StarBatch& batch)
{
  constexpr int m = Sizes<q>::modes, n = Sizes<q>::unknowns, data = Sizes<q>::facetData;
  const LoadModes& modes = *batch.loads;
  const Lanes* spokes = lanes(batch.spokes);
  for (int k = 0; k < batch.fields; ++k) {
    findJumps<q>(tables, batch, k);
    Lanes* offset = lanes(batch.offsets) + 3 * k * (batch.cells + 1);
    offset[0] = offset[1] = offset[2] = Lanes{};
    for (int c = 0; c < batch.cells; ++c, offset += 3) {
      const CellShape shape(load2(spokes + 2 * c), load2(spokes + 2 * c + 2));
      Lanes* known = lanes(batch.known) + (k * batch.cells + c) * (n + 2 * modes.modes);
      for (int i = 0; i < n; ++i)
        known[i] = Lanes{};
      if (c > 0 || batch.closed) {
        const Lanes* jump = lanes(batch.jumps) + (k * (batch.cells + 1) + c) * data;
        Vector2 T[q + 1];
        for (int mode = 0; mode <= q; ++mode)
          T[mode] = load2(jump + 2 * mode);
        decompose<q>(shape.d1, tables.arm, T, known, known + 3);
      }
      const Vector2 force = findLoads(batch, shape, k, c, known + n);
      Lanes moment{};
      for (int mode = 0; mode < modes.modes; ++mode)
        moment += modes.arms[2 * mode] * known[n + 2 * mode + 1] - modes.arms[2 * mode + 1] * known[n + 2 * mode];
      for (int i = 0; i < 3; ++i)
        known[i] += offset[i];
      store2(offset + 3, load2(known) + force.x * shape.d1 + force.y * shape.d2);
      offset[5] = known[2] + shape.det * moment;
      known[3 + m] = bendOfLoads(modes, shape, known + n);
    }
  }
}

/// Sweeps: the current moments as wrench, modes and loads.
template <int q>
void takeTotals(const StarTables& tables, const StarBatch& batch)
{
  constexpr int m = Sizes<q>::modes, n = Sizes<q>::unknowns, data = Sizes<q>::facetData;
  const LoadModes& modes = *batch.loads;
  const Lanes* spokes = lanes(batch.spokes);
  for (int i = 0; i < batch.fields * batch.cells; ++i) {
    const int c = i % batch.cells;
    const CellShape shape(load2(spokes + 2 * c), load2(spokes + 2 * c + 2));
    const Lanes* total = lanes(batch.total) + i * (2 * data + 2 * modes.modes);
    Lanes *known = lanes(batch.known) + i * (n + 2 * modes.modes), unused[3];
    Vector2 T1[q + 1], T2[q + 1];
    for (int mode = 0; mode <= q; ++mode) {
      T1[mode] = -1.0 * load2(total + 2 * mode);
      T2[mode] = load2(total + data + 2 * mode);
    }
    decompose<q>(shape.d1, tables.arm, T1, known, known + 3);
    decompose<q>(shape.d2, tables.arm, T2, unused, known + 3 + m);
    for (int mode = 0; mode < modes.modes; ++mode)
      store2(known + n + 2 * mode, shape.pullBack(load2(total + 2 * data + 2 * mode)));
    known[3 + m] += bendOfLoads(modes, shape, known + n);
  }
}

} // namespace
} // namespace ndframe
