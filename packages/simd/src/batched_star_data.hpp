#pragma once

#include <unordered_map>

#include "batched_fan.hpp"
#include "batched_rings.hpp"
#include "batched_tables.hpp"
#include "ndframe/simd/batched_stars.hpp"

namespace ndframe
{

/// What all stars of a body share.
struct BatchedStarData
{
  BatchedStarData(const BodyModel& model, const StaticData& staticData, const BatchedKernels& chosen);

  const DegreeKernels& kernelsOfDegree() const { return kernels.degree[data.degree - 1]; }

  const BodyModel& body;
  const StaticData& data;
  const BatchedKernels& kernels;
  Rings rings;
  BatchedStarTables tables;
  std::vector<PlaneLaw> laws; ///< severalLaws()
  LoadPermutations permutations;
  Shares loadShares;
  /// Numbers in StaticData::boundary and StaticData::contact by facet: 3 * cell + local.
  std::unordered_map<int, int> boundary, contact;
};

/// The fields of an initial pass.
struct StarFieldInputs
{
  StarFieldInputs(const BatchedStarData& stars, const std::vector<FieldInput>& fields);
  std::vector<Vector> stress;         ///< per field: vertexStress()
  std::vector<const Vector*> contact; ///< per field: FieldInput::contact
};

/// The end of a fan on facet `facet` (3 * cell + local) between `vertex` and `other`: directions, and the share of
/// prescribed tractions for `fields` fields, zero in sweeps (inputs null).
FanEnd fanEnd(const BatchedStarData& stars, int vertex, int other, int facet, const StarFieldInputs* inputs,
              int fields);

} // namespace ndframe
