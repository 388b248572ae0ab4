#pragma once

#include <array>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/io/exodus_writer.hpp"

namespace ndframe
{

void append(std::vector<NamedField>& fields, std::vector<NamedField> more);

/// A symmetric tensor as six variables PREFIXxx, PREFIXyy, PREFIXzz, PREFIXxy, PREFIXyz, PREFIXzx: the names and the
/// order that ParaView joins into one array, also for plane scenes. values: (xx, yy, zz, xy, yz, zx) per cell or node.
std::vector<NamedField> tensorFields(const std::string& prefix, const std::vector<std::array<double, 6>>& values);

/// The stress and its von Mises stress in the cells (means) and at the nodes (averages over the cells around).
/// displacement: numNodes * dim, global axes.
std::vector<NamedField> cellStressFields(const BodyModel& body, const Vector& displacement);
std::vector<NamedField> nodalStressFields(const BodyModel& body, const Vector& displacement);

/// sigma_zz of a plane law for a stress (xx, yy, xy) is this times the stress: zero in plane stress.
std::array<double, 3> outOfPlaneOfStress(const Elasticity& law);

} // namespace ndframe
