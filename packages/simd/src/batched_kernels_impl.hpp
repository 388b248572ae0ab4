#pragma once

#include "batched_cells.hpp"
#include "batched_data.hpp"
#include "batched_solution.hpp"

// Part of the kernels' translation units (see lanes.hpp).

namespace ndframe
{
namespace
{

template <int q>
constexpr DegreeKernels kernelsOfDegree()
{
  return {prepare<q>, takeTotals<q>, condense<q>, close<q>, expand<q>, distance<q>};
}

constexpr BatchedKernels makeKernels(const char* name)
{
  return {name, NDFRAME_LANES, vertexStress, {kernelsOfDegree<1>(), kernelsOfDegree<2>(), kernelsOfDegree<3>()}};
}

} // namespace
} // namespace ndframe
