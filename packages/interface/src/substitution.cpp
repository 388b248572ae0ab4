#include "substitution.hpp"

#include <algorithm>

namespace ndframe
{

Substitution::Substitution(const std::vector<CongruencePart>& parts, int motions) : parts_(parts), motions_(motions)
{
  std::vector<char> known(std::size_t(motions), 0);
  std::vector<std::pair<std::size_t, std::size_t>> waiting;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (std::size_t k = 0; k < parts[p].P.size(); ++k)
      waiting.emplace_back(p, k);
  while (!waiting.empty()) {
    const std::size_t before = waiting.size();
    waiting.erase(std::remove_if(waiting.begin(), waiting.end(),
                                 [&](const auto& value) { return determine(value.first, value.second, known); }),
                  waiting.end());
    if (waiting.size() == before)
      return;
  }
  exists_ = true;
}

/// Whether a value has exactly one unknown that is not known yet; it is then.
bool Substitution::determine(std::size_t part, std::size_t entry, std::vector<char>& known)
{
  Value value{part, entry, -1, 0.0};
  for (const auto& [unknown, coefficient] : parts_[part].P[entry])
    if (unknown < motions_ && !known[std::size_t(unknown)]) {
      if (value.unknown >= 0)
        return false;
      value.unknown = unknown;
      value.coefficient = coefficient;
    }
  if (value.unknown < 0)
    return false;
  known[std::size_t(value.unknown)] = 1;
  values_.push_back(value);
  return true;
}

Vector Substitution::unknowns(const std::vector<Vector>& values) const
{
  Vector x(std::size_t(motions_), 0.0);
  for (const Value& value : values_) {
    double rest = values[value.part][value.entry];
    for (const auto& [unknown, coefficient] : parts_[value.part].P[value.entry])
      if (unknown < motions_ && unknown != value.unknown)
        rest -= coefficient * x[std::size_t(unknown)];
    x[std::size_t(value.unknown)] = rest / value.coefficient;
  }
  return x;
}

std::vector<Vector> Substitution::forces(Vector b) const
{
  std::vector<Vector> forces;
  for (const CongruencePart& part : parts_)
    forces.emplace_back(part.P.size(), 0.0);
  for (auto value = values_.rbegin(); value != values_.rend(); ++value) {
    const double force = b[std::size_t(value->unknown)] / value->coefficient;
    forces[value->part][value->entry] = force;
    for (const auto& [unknown, coefficient] : parts_[value->part].P[value->entry])
      if (unknown < motions_ && unknown != value->unknown)
        b[std::size_t(unknown)] -= coefficient * force;
  }
  return forces;
}

std::vector<std::vector<char>> Substitution::valuesOf(const std::vector<char>& set) const
{
  std::vector<std::vector<char>> ofSet;
  for (const CongruencePart& part : parts_)
    ofSet.emplace_back(part.P.size(), 0);
  for (const Value& value : values_) {
    const char isIn = set[std::size_t(value.unknown)];
    for (const auto& [unknown, coefficient] : parts_[value.part].P[value.entry])
      if (set[std::size_t(unknown)] != isIn)
        return {};
    ofSet[value.part][value.entry] = isIn;
  }
  return ofSet;
}

} // namespace ndframe
