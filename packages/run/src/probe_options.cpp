#include "ndframe/run/probe_options.hpp"

#include <algorithm>

namespace ndframe
{

std::vector<std::vector<double>> ProbeOptions::wanted() const
{
  if (!at.empty())
    return {at};
  std::vector<std::vector<double>> all;
  for (int i = 0; isLine() && i < points; ++i) {
    const double t = double(i) / double(points - 1);
    all.push_back(from);
    for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k)
      all.back()[k] = (1.0 - t) * from[k] + t * to[k];
  }
  return all;
}

} // namespace ndframe
