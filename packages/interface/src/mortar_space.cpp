#include "ndframe/interface/mortar_space.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

MortarSpace::MortarSpace(std::vector<SparseRow> functions, std::vector<SparseRow> means)
    : functions_(std::move(functions)), means_(std::move(means)), unknownOf_(means_.size(), 0)
{
  Vector largest(means_.size(), -1.0);
  for (std::size_t unknown = 0; unknown < functions_.size(); ++unknown)
    for (const auto& [condition, value] : functions_[unknown])
      if (double& most = largest[std::size_t(condition)]; std::abs(value) > most) {
        most = std::abs(value);
        unknownOf_[std::size_t(condition)] = int(unknown);
      }
}

Vector MortarSpace::meansOf(const Vector& unknowns) const
{
  return product(means_, unknowns);
}

Vector MortarSpace::forcesOf(const Vector& unknowns) const
{
  return transposedProduct(functions_, unknowns, numConditions());
}

Vector MortarSpace::forcesAtUnknowns(const Vector& forces) const
{
  return transposedProduct(means_, forces, int(functions_.size()));
}

Vector MortarSpace::valuesAtUnknowns(const Vector& coefficients) const
{
  return product(functions_, coefficients);
}

std::vector<char> MortarSpace::statusesOf(const std::vector<char>& closed) const
{
  std::vector<char> result;
  for (const int unknown : unknownOf_)
    result.push_back(closed[std::size_t(unknown)]);
  return result;
}

std::vector<char> MortarSpace::statusesAtUnknowns(const std::vector<char>& closed) const
{
  std::vector<char> result;
  for (const SparseRow& row : functions_)
    result.push_back(!row.empty() && std::all_of(row.begin(), row.end(), [&](const auto& entry) {
      return closed[std::size_t(entry.first)] != 0;
    }));
  return result;
}

} // namespace ndframe
