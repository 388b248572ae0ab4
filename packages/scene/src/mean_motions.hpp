#pragma once

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Row of a body's first coefficient in a joint motion.
int offsetOf(const Model& model, int body);

/// Coefficients of one body in a joint motion.
Vector ofBody(const Model& model, const DenseMatrix& joint, int motion, int body);

/// Displacement of a rigid motion with these coefficients at a point.
Direction displacementOf(const RigidBasis& rigid, const Vector& motion, const double* point);

/// sum_i f_i . (rigid motion at node i)
double workAlong(const BodyModel& body, const RigidBasis& rigid, const Vector& motion, const Vector& forces);

/// Weights w with w . u = int u . (rigid motion), over the body or over the side that the support names.
Vector meanWeights(const BodyModel& body, const Params& hold, const RigidBasis& rigid, const Vector& motion);

} // namespace ndframe
