#pragma once

#include "ndframe/interface/obstacle.hpp"

namespace ndframe
{

Direction plus(const Direction& a, double factor, const Direction& b);
/// v / |v|; |v| > 0.
Direction unit(const Direction& v);

/// The list of a rigid body as Obstacles read it. How many coordinates it should give is known when a side is.
class ObstacleList
{
public:
  explicit ObstacleList(const Params& list) : list_(list) {}

  /// A point or a vector of so many coordinates. InputError if the deck gives another number.
  Direction vector(const char* key, int dim) const;
  /// A vector that points somewhere, with length 1.
  Direction direction(const char* key, int dim, const char* meaning) const;
  /// Checks what every rigid body has.
  void checkDisplacement(int dim) const;
  Diagnostic mistake(const char* key, const std::string& message) const { return list_.mistake(key, message); }

  const Params& list() const { return list_; }

private:
  Params list_;
};

/// Those that every rigid body has, after `params`.
std::vector<ParamSpec> withDisplacement(std::vector<ParamSpec> params);

/// "Cylinder" and "Sphere".
void registerRoundObstacles(Registry<Obstacle>& registry);

/// An edge of the body, which lies to its left.
SideEdge edgeBetween(const Direction& from, const Direction& to);

/// Surfaces face each other up to this cosine between their normals, as edges do (SideMap).
constexpr double facingCosine = 0.5;

} // namespace ndframe
