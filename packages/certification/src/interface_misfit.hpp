#pragma once

#include "certificate_steps.hpp"

namespace ndframe
{

/// How badly the stress K eps(u~) of a field carries its tractions and how much these do where u_h is open, about:
///   sqrt(sum_f h_f / E |t^ n - K eps(u~) nu|^2 + 2 int t^ ([u_h] - g)),
/// the first over both sides of all contact facets (a part of a residual indicator). Ranks tractions, bounds nothing.
double interfaceMisfit(const CertifiedScene& scene, const IntermediateField& field);

} // namespace ndframe
