#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/base/list_place.hpp"
#include "ndframe/base/registry.hpp"
#include "ndframe/fem/node_map.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"

namespace ndframe
{

/// A vector in space; zero beyond the dimension of the body.
using Direction = std::array<double, 3>;

/// One scalar equation u . direction = value at a node (unit vector; a length).
struct NodeConstraint
{
  int node;            ///< of the body's NodeMap
  Direction direction; ///< global axes
  double value;        ///< a length
};

/// The expression of a key; a value that is not finite is the user's mistake.
SampledFunction sampledFunction(const Params& params, const char* key);
/// The same for an expression that the key of a list is a part of.
SampledFunction sampledFunction(const ListPlace& list, const char* key, const std::string& text);

/// What a support or a load has in common: it stands in the deck and may name a side of its body.
class SideCondition
{
public:
  explicit SideCondition(Params params) : params_(std::move(params)) {} ///< params: its list in the deck
  virtual ~SideCondition() = default;

  /// Adds a mistake if the side that this condition names does not exist (saying which do) or does not suit it.
  virtual void check(const Mesh& mesh, Diagnostics& diagnostics) const;
  /// "clamp at bottom", for the header of a run.
  virtual std::string description() const;
  const Params& params() const { return params_; } ///< its list in the deck

protected:
  /// The side named by "Side"; check() has passed.
  const Side& side(const Mesh& mesh) const;
  SampledFunction sampled(const char* key) const { return sampledFunction(params_, key); } ///< of its own list

private:
  Params params_;
};

/// Prescribes displacements on a side: u . direction_k = value_k, the same directions on all its facets. A support may
/// also hold a point (constraints without facets), or mean rigid motions (neither; the model chooses how).
class Support : public SideCondition
{
public:
  using SideCondition::SideCondition; ///< from its list in the deck
  /// The directions, unit vectors.
  virtual std::vector<Direction> directions(const Mesh& mesh) const = 0;
  /// The displacements along them as functions of the position: lengths. Empty: all are zero.
  virtual const std::vector<SampledFunction>& functions() const;
  /// The values are the same everywhere.
  bool isConstant() const;

  /// Where it prescribes displacements of the continuum.
  virtual const std::vector<Facet>& facets(const Mesh& mesh) const { return side(mesh).facets; }
  /// The equations at all nodes of the side.
  virtual std::vector<NodeConstraint> constraints(const Mesh& mesh, const NodeMap& nodes) const;
  /// It holds the mean rigid motions that nothing else resists, and can carry no force.
  virtual bool holdsMeanMotion() const { return false; }
  /// It holds a point, whose force no stress of finite energy can carry; not for bodies that are rigid.
  bool holdsPoint() const { return !params().has("Side") && !holdsMeanMotion(); }
  /// For a support without a side: its equations. They fix the motions that it holds in a system, or are those that a
  /// part of a body has of a point's.
  virtual void pin(const std::vector<NodeConstraint>&) {}
};

class LoadProjection;

/// A force per area on the facets of a side, or a force per volume in all cells, linear in functions of the position.
class Load : public SideCondition
{
public:
  using SideCondition::SideCondition; ///< from its list in the deck
  /// The facets it acts on; null: it acts in all cells.
  const std::vector<Facet>* facets(const Mesh& mesh) const;
  /// Groups of cells that it acts in, where it acts in cells; none: in all.
  virtual std::vector<std::string> groups() const { return {}; }
  /// The functions of the position that it is made of in a body of dimension `dim`.
  virtual std::vector<SampledFunction> functions(int dim) const = 0;
  /// Fills q (dim components), linear in the functions' values; normal: the facet's outward normal, null in a cell.
  /// |q| is at most dim times the largest value.
  virtual void density(int dim, const double* values, const double* normal, double* q) const = 0;
  /// It has one value on a facet, or in all cells.
  bool isConstant(int dim) const;
  /// What samples the functions, kept because it knows polynomials that they are on boxes. One thread at a time.
  DataSampler& sampler(int dim) const;
  /// What is kept of the samples in cells once they are integrated.
  enum class Keep
  {
    Nothing,
    Projections ///< for a certificate on this mesh
  };
  /// Those of the last integral (BodyLoads); null: none are kept.
  const LoadProjection* projection() const { return projection_.get(); }
  /// projection: null to forget them.
  void keep(std::shared_ptr<const LoadProjection> projection) const { projection_ = std::move(projection); }

private:
  mutable std::shared_ptr<DataSampler> sampler_;
  mutable std::shared_ptr<const LoadProjection> projection_;
};

/// All are constant.
bool areConstant(const std::vector<SampledFunction>& functions);

/// The value at a point of space (three coordinates are read only where the dimension has them).
double valueAt(const SampledFunction& function, int dim, const double* point);

/// What holds a rigid body: its list "Rigid", whose "Displacement" all nodes have.
std::unique_ptr<Support> makeRigidSupport(const Params& rigid);

/// "Clamp", "Roller", "Displacement", "Point", "Hold".
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
