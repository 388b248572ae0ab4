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

using Direction = std::array<double, 3>;

/// One scalar equation u . direction = value at a node (unit vector; a length).
struct NodeConstraint
{
  int node;
  Direction direction;
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

/// Prescribes displacements on a side: u . direction_k = value_k, the same directions on all its facets.
class Support : public SideCondition
{
public:
  using SideCondition::SideCondition;
  /// The directions, unit vectors.
  virtual std::vector<Direction> directions(const Mesh& mesh) const = 0;
  /// The displacement along the k-th of them at a point of a body of dimension `dim`: a length.
  virtual double value(int dim, int k, const double* point) const;
  /// The values are the same everywhere.
  virtual bool isConstant() const { return true; }

  const std::vector<Facet>& facets(const Mesh& mesh) const { return side(mesh).facets; }
  /// The equations at all nodes of the side.
  std::vector<NodeConstraint> constraints(const Mesh& mesh, const NodeMap& nodes) const;
};

/// A force per area on the facets of a side, or a force per volume in all cells, given by its value at a point.
class Load : public SideCondition
{
public:
  using SideCondition::SideCondition;
  /// The facets it acts on; null: it acts in all cells.
  const std::vector<Facet>* facets(const Mesh& mesh) const;
  /// It has one value on a facet, or in all cells.
  virtual bool isConstant() const = 0;
  /// Fills q (dim components) at a point; normal: the facet's outward normal, null in a cell.
  virtual void density(int dim, const double* point, const double* normal, double* q) const = 0;
  /// Adds int q . v to `load` (numNodes * dim, global axes), by the samples of visitLoad (load_samples.hpp).
  void addTo(Vector& load, const Mesh& mesh, const NodeMap& nodes) const;
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
