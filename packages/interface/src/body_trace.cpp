#include "ndframe/interface/body_trace.hpp"

#include <algorithm>

#include "ndframe/interface/congruence.hpp"

namespace ndframe
{
namespace
{

/// a^-1 by rows.
std::vector<SparseRow> keptRows(const std::vector<TraceDof>& trace)
{
  std::vector<SparseRow> rows;
  for (std::size_t k = 0; k < trace.size(); ++k) {
    const TraceDof& dof = trace[k];
    rows.push_back({{int(k), 1.0 / dof.scale}});
    if (dof.first >= 0)
      rows.back().emplace_back(dof.first, -dof.along / (dof.scale * trace[std::size_t(dof.first)].scale));
  }
  return rows;
}

} // namespace

std::shared_ptr<const SymmetricOperator> traceOperator(const CondensedBody& body, const std::vector<TraceDof>& trace,
                                                       const InterfaceOperator& representation)
{
  const int size = int(trace.size());
  return congruence({{representation.represent(body, size), keptRows(trace)}}, size);
}

Vector traceLoad(const CondensedBody& body, const std::vector<TraceDof>& trace, const SymmetricOperator& S,
                 const Vector& load)
{
  Vector g = normalForces(trace, body.reduce(DenseMatrix(load)).column(0));
  Vector offset;
  for (const TraceDof& dof : trace)
    offset.push_back(dof.offset);
  if (std::any_of(offset.begin(), offset.end(), [](double b) { return b != 0.0; })) {
    const Vector moved = S.apply(offset);
    for (std::size_t i = 0; i < g.size(); ++i)
      g[i] += moved[i];
  }
  return g;
}

Vector keptValues(const std::vector<TraceDof>& trace, const Vector& normalDisplacement)
{
  Vector kept;
  for (std::size_t i = 0; i < trace.size(); ++i)
    kept.push_back((normalDisplacement[i] - trace[i].offset) / trace[i].scale);
  for (std::size_t i = 0; i < trace.size(); ++i)
    if (trace[i].first >= 0)
      kept[i] -= trace[i].along / trace[i].scale * kept[std::size_t(trace[i].first)];
  return kept;
}

Vector normalParts(const std::vector<TraceDof>& trace, const Vector& kept)
{
  Vector normal;
  for (std::size_t i = 0; i < trace.size(); ++i)
    normal.push_back(trace[i].scale * kept[i] +
                     (trace[i].first < 0 ? 0.0 : trace[i].along * kept[std::size_t(trace[i].first)]));
  return normal;
}

Vector keptForces(const std::vector<TraceDof>& trace, const Vector& normalForce)
{
  Vector force;
  for (std::size_t i = 0; i < trace.size(); ++i)
    force.push_back(trace[i].scale * normalForce[i]);
  for (std::size_t i = 0; i < trace.size(); ++i)
    if (trace[i].first >= 0)
      force[std::size_t(trace[i].first)] += trace[i].along * normalForce[i];
  return force;
}

Vector normalForces(const std::vector<TraceDof>& trace, Vector keptForce)
{
  for (std::size_t i = 0; i < trace.size(); ++i)
    keptForce[i] /= trace[i].scale;
  for (std::size_t i = 0; i < trace.size(); ++i)
    if (trace[i].first >= 0)
      keptForce[std::size_t(trace[i].first)] -=
          trace[i].along / trace[std::size_t(trace[i].first)].scale * keptForce[i];
  return keptForce;
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

Vector BodyTrace::forces(const Vector& onDirichlet, const Vector& onNeumann) const
{
  Vector own;
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const auto unknown = std::size_t(unknowns[k]);
    own.push_back(onDirichletSide[k] ? onDirichlet[unknown] : -onNeumann[unknown]);
  }
  for (const DependentUnknown& dependent : dependents) {
    const auto unknown = std::size_t(dependent.unknown);
    const double force = dependent.onDirichletSide ? onDirichlet[unknown] : -onNeumann[unknown];
    own[std::size_t(dependent.follows.first)] += dependent.follows.share * force;
    if (dependent.follows.other >= 0)
      own[std::size_t(dependent.follows.other)] += dependent.follows.otherShare * force;
  }
  return own;
}

bool InterfaceSystem::isDirichlet(const BodyTrace& body) const
{
  for (std::size_t k = 0; k < body.unknowns.size(); ++k)
    if (!isObstacle[std::size_t(body.unknowns[k])])
      return body.onDirichletSide[k] != 0;
  return true;
}

Vector InterfaceSystem::withObstacles(Vector uNeumann) const
{
  for (std::size_t i = 0; i < isObstacle.size(); ++i)
    if (isObstacle[i])
      uNeumann[i] = obstacle[i];
  return uNeumann;
}

Vector InterfaceSystem::traction(const Vector& unknownForce) const
{
  Vector nodal(std::size_t(C->size()), 0.0);
  for (std::size_t i = 0; i < nodeOfUnknown.size(); ++i)
    nodal[std::size_t(nodeOfUnknown[i])] = unknownForce[i];
  return C->solve(nodal);
}

Vector InterfaceSystem::force(const Vector& nodalTraction) const
{
  const Vector nodal = C->apply(nodalTraction);
  Vector atUnknowns;
  for (const int node : nodeOfUnknown)
    atUnknowns.push_back(nodal[std::size_t(node)]);
  return atUnknowns;
}

} // namespace ndframe
