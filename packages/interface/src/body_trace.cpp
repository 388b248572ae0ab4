#include "ndframe/interface/body_trace.hpp"

#include <algorithm>
#include <utility>

#include "ndframe/interface/congruence.hpp"

namespace ndframe
{

namespace
{

Vector negative(Vector values)
{
  for (double& value : values)
    value = -value;
  return values;
}

} // namespace

Vector& ReducedLoad::found() const
{
  if (const auto find = std::exchange(find_, nullptr))
    values_ = find();
  return values_;
}

void ReducedLoad::negate()
{
  if (find_)
    find_ = [find = std::move(find_)] { return negative(find()); };
  else
    values_ = negative(std::move(values_));
}

std::shared_ptr<const SymmetricOperator> traceOperator(const CondensedBody& body, const TraceMap& map,
                                                       const InterfaceOperator& representation)
{
  return congruence({{representation.represent(body, map.size()), map.inverse()}}, map.size());
}

Vector traceLoad(const CondensedBody& body, const TraceMap& map, const SymmetricOperator& S, const Vector& load)
{
  Vector g = map.forces(body.reduce(DenseMatrix(load)).column(0));
  const Vector& offset = map.offset();
  if (std::any_of(offset.begin(), offset.end(), [](double b) { return b != 0.0; })) {
    const Vector moved = S.apply(offset);
    for (std::size_t i = 0; i < g.size(); ++i)
      g[i] += moved[i];
  }
  return g;
}

DenseMatrix motionTraces(const RigidBasis& basis, const DenseMatrix& motions, const std::vector<const double*>& points,
                         const std::vector<Direction>& normals)
{
  DenseMatrix traces(int(points.size()), motions.cols());
  for (int i = 0; i < traces.rows(); ++i)
    for (int m = 0; m < basis.size(); ++m) {
      const double along = dotProduct(basis.displacement(m, points[std::size_t(i)]), normals[std::size_t(i)]);
      for (int j = 0; j < motions.cols(); ++j)
        traces(i, j) += along * motions(m, j);
    }
  return traces;
}

Vector BodyTrace::forces(const UnknownValues& onDirichlet, const UnknownValues& onNeumann) const
{
  const auto along = [&](ContactRole role, int unknown) {
    return signOf(role) * (role == ContactRole::Dirichlet ? onDirichlet : onNeumann)[std::size_t(unknown)];
  };
  Vector own;
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    own.push_back(along(roles[k], unknowns[k]));
  for (const DependentUnknown& dependent : dependents) {
    const double force = along(dependent.role, dependent.unknown);
    for (const auto& [k, part] : dependent.row)
      own[std::size_t(k)] += part * force;
  }
  return own;
}

ContactRole InterfaceSystem::roleOf(const BodyTrace& body) const
{
  for (std::size_t k = 0; k < body.unknowns.size(); ++k)
    if (!isObstacle[std::size_t(body.unknowns[k])])
      return body.roles[k];
  return ContactRole::Dirichlet;
}

UnknownValues InterfaceSystem::withObstacles(UnknownValues uNeumann) const
{
  for (std::size_t i = 0; i < isObstacle.size(); ++i)
    if (isObstacle[i])
      uNeumann[i] = obstacle[i];
  return uNeumann;
}

InterfaceValues InterfaceSystem::shares() const
{
  Vector nodal = C->apply(Vector(std::size_t(C->size()), 1.0));
  return atInterface(basis ? basis->forces(nodal) : std::move(nodal));
}

UnknownValues InterfaceSystem::atUnknowns(const InterfaceValues& ofNodes) const
{
  Vector values;
  for (const int node : nodeOfUnknown)
    values.push_back(ofNodes[std::size_t(node)]);
  return ofUnknowns(std::move(values));
}

Vector InterfaceSystem::atNodes(const UnknownValues& ofUnknowns) const
{
  Vector all(std::size_t(C ? C->size() : 0), 0.0); // a scene without interfaces has no contact matrix
  for (std::size_t i = 0; i < nodeOfUnknown.size(); ++i)
    all[std::size_t(nodeOfUnknown[i])] = ofUnknowns[i];
  return all;
}

InterfaceValues InterfaceSystem::nodalForces(const UnknownValues& unknownForce) const
{
  Vector nodal = atNodes(unknownForce);
  return atInterface(basis ? basis->nodalForces(nodal) : std::move(nodal));
}

InterfaceValues InterfaceSystem::traction(const UnknownValues& unknownForce) const
{
  Vector force = atNodes(unknownForce);
  const InterfaceValues share = slitEnds.empty() ? InterfaceValues() : shares();
  for (const SlitEnd& end : slitEnds) {
    double forceBeside = 0.0, shareBeside = 0.0;
    for (const int node : end.beside) {
      forceBeside += force[std::size_t(node)];
      shareBeside += share[std::size_t(node)];
    }
    if (shareBeside > 0.0)
      force[std::size_t(end.node)] = forceBeside / shareBeside * share[std::size_t(end.node)];
  }
  return atInterface(C->solve(basis ? basis->nodalForces(force) : force));
}

UnknownValues InterfaceSystem::force(const InterfaceValues& nodalTraction) const
{
  Vector nodal = C->apply(nodalTraction);
  if (basis)
    nodal = basis->forces(nodal);
  return atUnknowns(atInterface(std::move(nodal)));
}

UnknownValues InterfaceSystem::forceOf(const UnknownValues& tractionAtUnknowns) const
{
  Vector nodal = atNodes(tractionAtUnknowns);
  return force(atInterface(basis ? basis->values(nodal) : std::move(nodal)));
}

} // namespace ndframe
