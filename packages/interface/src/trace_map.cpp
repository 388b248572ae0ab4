#include "ndframe/interface/trace_map.hpp"

#include <algorithm>
#include <functional>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// A and b of u_N = A s + b: diagonal but for further normals of nodes.
AffineRows normalRows(const std::vector<TraceDof>& trace)
{
  AffineRows result;
  for (std::size_t k = 0; k < trace.size(); ++k) {
    result.rows.push_back({{int(k), trace[k].scale}});
    result.rows.back().insert(result.rows.back().end(), trace[k].others.begin(), trace[k].others.end());
    result.offset.push_back(trace[k].offset);
  }
  return result;
}

} // namespace

AffineRows AffineRows::after(const AffineRows& inner) const
{
  int columns = 0;
  for (const SparseRow& row : inner.rows)
    for (const auto& [column, value] : row)
      columns = std::max(columns, column + 1);
  AffineRows result{product(rows, inner.rows, columns), offset};
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [j, value] : rows[i])
      result.offset[i] += value * inner.offset[std::size_t(j)];
  return result;
}

AffineRows inverseOf(const AffineRows& map)
{
  AffineRows result{std::vector<SparseRow>(map.rows.size()), Vector(map.rows.size(), 0.0)};
  SparseSum sum(int(map.rows.size()));
  const std::function<void(std::size_t)> invert = [&](std::size_t k) {
    const SparseRow& row = map.rows[k];
    NDFRAME_ASSERT(row.front().first == int(k), "the diagonal comes first");
    for (auto entry = row.begin() + 1; entry != row.end(); ++entry)
      if (result.rows[std::size_t(entry->first)].empty())
        invert(std::size_t(entry->first));
    sum.add(int(k), 1.0 / row.front().second);
    double constant = map.offset[k];
    for (auto entry = row.begin() + 1; entry != row.end(); ++entry) {
      sum.add(result.rows[std::size_t(entry->first)], -entry->second / row.front().second);
      constant += entry->second * result.offset[std::size_t(entry->first)];
    }
    result.rows[k] = sum.take();
    result.offset[k] = -constant / row.front().second;
  };
  for (std::size_t k = 0; k < map.rows.size(); ++k)
    if (result.rows[k].empty())
      invert(k);
  return result;
}

TraceMap::TraceMap(const std::vector<TraceDof>& trace) : map_(normalRows(trace))
{
  for (const TraceDof& dof : trace)
    dofs_.push_back(dof.dof);
  inverse_ = inverseOf(map_).rows;
}

TraceMap::TraceMap(const std::vector<TraceDof>& trace, const AffineRows& coefficients) : TraceMap(trace)
{
  const AffineRows toKept{inverse_, Vector(inverse_.size(), 0.0)};
  map_ = coefficients.after(map_);
  inverse_ = toKept.after({inverseOf(coefficients).rows, Vector(inverse_.size(), 0.0)}).rows;
}

Vector TraceMap::values(const Vector& kept) const
{
  Vector result = product(map_.rows, kept);
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] += map_.offset[k];
  return result;
}

Vector TraceMap::keptValues(const Vector& values) const
{
  Vector strained = values;
  for (std::size_t k = 0; k < strained.size(); ++k)
    strained[k] -= map_.offset[k];
  return product(inverse_, strained);
}

Vector TraceMap::keptForces(const Vector& forces) const
{
  return transposedProduct(map_.rows, forces, size());
}

Vector TraceMap::forces(const Vector& keptForces) const
{
  return transposedProduct(inverse_, keptForces, size());
}

void TraceMap::exchange()
{
  for (auto* rows : {&map_.rows, &inverse_})
    for (SparseRow& row : *rows)
      for (auto& [column, value] : row)
        value = -value;
  for (double& value : map_.offset)
    value = -value;
}

bool TraceMap::isLike(const TraceMap& other) const
{
  return dofs_ == other.dofs_ && map_.rows == other.map_.rows;
}

} // namespace ndframe
