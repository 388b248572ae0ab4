#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fem/sample_meshes.hpp"
#include "ndframe/assembly/body_system.hpp"
#include "ndframe/assembly/constraint_set.hpp"

namespace ndframe::test
{

/// One support or load as a deck gives it; the values are written as texts.
struct Condition
{
  std::string type;
  std::vector<std::pair<std::string, std::string>> entries;
};

/// A support of that type on a side.
Condition onSide(const std::string& type, const std::string& side);

struct Conditions
{
  std::vector<Condition> supports, loads;
};

/// Plane strain or space, E = 2, nu = 0.3.
Elasticity elastic(int dim, Hypothesis planeHypothesis = Hypothesis::PlaneStrain);

/// The body with its conditions read and checked. Conditions stand in "Supports" and "Loads", named by their numbers;
/// InputError goes through.
BodyModel makeBody(Mesh mesh, int order, const Conditions& conditions = {});

/// The message of the InputError that `step` throws; a test failure when it throws none.
std::string complaint(const std::function<void()>& step);

/// Nodes of this rank by METIS.
std::vector<int> ownedNodes(const BodyModel& body, const Comm& comm);

/// The body's supports as constraints.
ConstraintSet constraintsOf(const BodyModel& body);

/// The system with the body's supports, distributed over `comm`.
BodySystem assemble(const BodyModel& body, const Comm& comm);

/// Nodal values of a displacement field, global axes.
Vector interpolate(const NodeMap& nodes, const std::function<void(const double* x, double* u)>& field);

/// The free dofs from K u = load with the fixed ones at their prescribed values; by dense elimination, global axes.
NodalField solve(const BodySystem& system, const Comm& comm);

/// The largest absolute value.
double largest(const Vector& values);

} // namespace ndframe::test
