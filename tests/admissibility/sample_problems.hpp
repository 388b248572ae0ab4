#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assembly/sample_body.hpp"
#include "ndframe/equilibrium/cell_energy.hpp"
#include "ndframe/equilibrium/equilibrium_check.hpp"
#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe::test
{

/// A body without contact, solved: sigma_h = K eps(u_h) in finite element equilibrium with its data.
struct Problem
{
  BodyModel body;
  StaticData data;
  Vector displacement; ///< u_h, global axes

  FieldInput field() const { return {&displacement, nullptr}; }
};

Problem solved(BodyModel body, int degree);

/// For names of tests.
struct Space
{
  int dim, order, degree;
};
std::vector<Space> allSpaces();
std::string spaceName(const testing::TestParamInfo<Space>& test);

/// Conditions of a kind on a box: "clamped" (left; tractions on the others, body force), "rollers" (left and bottom, on
/// a turned box inclined; pressure), "prescribed" (displacements given on left and right), "corner" (left clamped,
/// bottom on rollers, so that they meet), "pinched" (the component across the box prescribed on top and bottom, left
/// clamped).
Conditions conditions(int dim, const std::string& kind);
const std::vector<std::string>& conditionKinds();

/// A box of unequal sides and a few cells with its inner points moved, turned by `rotation` degrees about z.
Mesh sampleMesh(int dim, double rotation, unsigned seed = 6);

/// Squared energy norm of the correction.
double energyOf(const BodyModel& body, const StressCorrection& correction);

} // namespace ndframe::test
