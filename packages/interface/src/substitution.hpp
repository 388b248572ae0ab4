#pragma once

#include "ndframe/interface/congruence.hpp"

namespace ndframe
{

/// P x = v of all parts, solved for one unknown after the other.
class Substitution
{
public:
  /// Unknowns from `motions` on are left out. Does not exist where some value says nothing new, or cannot be used yet.
  Substitution(const std::vector<CongruencePart>& parts, int motions);

  bool exists() const { return exists_; }
  /// P^-1 v, zero for unknowns that no value says anything of; v per part.
  Vector unknowns(const std::vector<Vector>& values) const;
  /// P^-T b, per part.
  std::vector<Vector> forces(Vector b) const;
  /// Per part the values that determine unknowns of a set, where no value of the set feels others, nor the other way
  /// round; empty where some does.
  std::vector<std::vector<char>> valuesOf(const std::vector<char>& set) const;

private:
  struct Value
  {
    std::size_t part, entry;
    int unknown;
    double coefficient;
  };
  bool determine(std::size_t part, std::size_t entry, std::vector<char>& known);

  const std::vector<CongruencePart>& parts_;
  int motions_;
  std::vector<Value> values_; ///< in the order in which they determine
  bool exists_ = false;
};

} // namespace ndframe
