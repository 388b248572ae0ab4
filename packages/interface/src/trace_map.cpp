#include "ndframe/interface/trace_map.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// a and b of u_N = a s + b: diagonal but for second normals of nodes.
AffineRows normalRows(const std::vector<TraceDof>& trace)
{
  AffineRows result;
  for (std::size_t k = 0; k < trace.size(); ++k) {
    result.rows.push_back({{int(k), trace[k].scale}});
    if (trace[k].first >= 0)
      result.rows.back().emplace_back(trace[k].first, trace[k].along);
    result.offset.push_back(trace[k].offset);
  }
  return result;
}

Vector transposedProduct(const std::vector<SparseRow>& rows, const Vector& x)
{
  Vector result(rows.size(), 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [j, value] : rows[i])
      result[std::size_t(j)] += value * x[i];
  return result;
}

Vector product(const std::vector<SparseRow>& rows, const Vector& x)
{
  Vector result(rows.size(), 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [j, value] : rows[i])
      result[i] += value * x[std::size_t(j)];
  return result;
}

} // namespace

AffineRows AffineRows::after(const AffineRows& inner) const
{
  int columns = 0;
  for (const SparseRow& row : inner.rows)
    for (const auto& [column, value] : row)
      columns = std::max(columns, column + 1);
  SparseSum sum(columns);
  AffineRows result{{}, offset};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const auto& [j, value] : rows[i]) {
      sum.add(inner.rows[std::size_t(j)], value);
      result.offset[i] += value * inner.offset[std::size_t(j)];
    }
    result.rows.push_back(sum.take());
  }
  return result;
}

AffineRows inverseOf(const AffineRows& map)
{
  AffineRows result;
  for (std::size_t k = 0; k < map.rows.size(); ++k) {
    const SparseRow& row = map.rows[k];
    NDFRAME_ASSERT(row.front().first == int(k), "the diagonal comes first");
    const double diagonal = row.front().second;
    result.rows.push_back({{int(k), 1.0 / diagonal}});
    result.offset.push_back(-map.offset[k] / diagonal);
    for (auto entry = row.begin() + 1; entry != row.end(); ++entry) {
      const auto other = std::size_t(entry->first);
      NDFRAME_ASSERT(map.rows[other].size() == 1, "what others need stands for itself");
      const double share = entry->second / (diagonal * map.rows[other].front().second);
      result.rows.back().emplace_back(entry->first, -share);
      result.offset.back() += share * map.offset[other];
    }
  }
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
  return transposedProduct(map_.rows, forces);
}

Vector TraceMap::forces(const Vector& keptForces) const
{
  return transposedProduct(inverse_, keptForces);
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
