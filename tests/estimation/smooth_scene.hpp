#pragma once

#include <string>

#include "assembly/sample_body.hpp"

namespace ndframe::test
{

/// The unit square held on all sides under the body force that belongs to u = sin(pi x) sin(pi y) (1, 1/2), n x n
/// boxes.
BodyModel smoothBody(int n, int order, const std::string& pattern = "Right");

/// Finite element solution of a body, global axes.
Vector solution(const BodyModel& body);

/// |u - u_h|^2 in smoothBody, by Galerkin orthogonality.
double smoothErrorSquared(const BodyModel& body, const Vector& solved);

double sum(const Vector& values);

} // namespace ndframe::test
