#pragma once

#include "data_enclosures.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// DataSampler::scaleOn.
double findScale(const std::vector<SampledFunction>& functions, DataEnclosures& data, int space,
                 const std::function<void(const DataSampler::Visit&)>& visit);

} // namespace ndframe
