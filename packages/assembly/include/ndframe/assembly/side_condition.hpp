#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/base/registry.hpp"
#include "ndframe/fem/node_map.hpp"

namespace ndframe
{

/// One scalar equation u . direction = value at a node (unit vector; a length).
struct NodeConstraint
{
  int node;
  std::array<double, 3> direction;
  double value;
};

/// What a support or a load has in common: it stands in the deck and may name a side of its body.
class SideCondition
{
public:
  explicit SideCondition(Params params) : params_(std::move(params)) {}
  virtual ~SideCondition() = default;

  /// Adds a mistake if the side that this condition names does not exist (saying which do) or does not suit it.
  virtual void check(const Mesh& mesh, Diagnostics& diagnostics) const;
  /// "clamp at bottom", for the header of a run.
  std::string description() const;
  const Params& params() const { return params_; }

protected:
  /// The side named by "Side"; check() has passed.
  const Side& side(const Mesh& mesh) const;
  /// An expression's value at a point; a value that is not finite is the user's mistake.
  double evaluate(const Expression& expression, const char* key, const double* point, int dim) const;

private:
  Params params_;
};

/// Prescribes displacements on a side.
class Support : public SideCondition
{
public:
  using SideCondition::SideCondition;
  virtual std::vector<NodeConstraint> constraints(const Mesh& mesh, const NodeMap& nodes) const = 0;
};

/// Adds to the load vector.
class Load : public SideCondition
{
public:
  using SideCondition::SideCondition;
  /// Adds int p . v dS or int b . v dV to `load` (numNodes * dim, global axes).
  virtual void addTo(Vector& load, const Mesh& mesh, const NodeMap& nodes) const = 0;
};

/// "Clamp", "Roller", "Displacement".
void registerSupports(Registry<Support>& registry);

/// "Pressure", "Traction", "Body Force".
void registerLoads(Registry<Load>& registry);

/// The key that every condition on a side has.
ParamSpec sideSpec();

/// "the sides of this body are: left, right" for messages about a side that does not exist.
std::string sideNames(const Mesh& mesh);

/// "(0.5, 1)" for messages.
std::string pointText(const double* point, int dim);

} // namespace ndframe
