#pragma once

#include <string>

#include "ndframe/mesh/mesh.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// Where data are least certain: the simplex on which enclosures leave most of their mean values open.
struct Doubt
{
  double uncertainty = 0.0; ///< of the data's largest value
  std::string place;        ///< "(0.5, 1)"

  /// Keeps the simplex if its samples are not certain and less so than those before.
  void add(const Samples& samples, const Mesh& mesh, int dim, const int* vertices);
  explicit operator bool() const { return uncertainty > 0.0; }
  /// "to 0.002 of its largest value", or that nothing is known.
  std::string size() const;
};

} // namespace ndframe
