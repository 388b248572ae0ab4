#pragma once

#include <map>
#include <utility>

#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// p_h on the boundary facets of a body, loads and contact together; zero where nothing is given.
class PrescribedTractions
{
public:
  PrescribedTractions(const BodyModel& body, const StaticData& data, const FieldInput& field);

  /// p_h at a point of a facet (barycentric coordinates by ascending vertices), global axes.
  Direction value(Facet facet, const double* point) const;
  /// Moments of p_h on a facet, mode by mode; null where nothing is given.
  const Vector* moments(Facet facet) const;
  /// Supports take a part of the traction there.
  bool isSupported(Facet facet) const;
  /// What of a traction (or one of its moments) on the facet supports do not take.
  Direction freePart(Facet facet, Direction traction) const;

private:
  struct OnFacet
  {
    Vector moments;
    const BoundaryFacet* support = nullptr;
  };
  void add(Facet facet, const double* shares);
  const OnFacet* find(Facet facet) const;

  const Mesh& mesh_;
  MomentBasis basis_;
  std::map<std::pair<int, int>, OnFacet> facets_;
};

} // namespace ndframe
