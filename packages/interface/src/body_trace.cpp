#include "ndframe/interface/body_trace.hpp"

#include <algorithm>

#include "ndframe/interface/applied_operator.hpp"

namespace ndframe
{
namespace
{

/// a S_FF^-1 a^T of a set that has both normals of a node or none.
class ScaledInverse final : public RestrictedInverse
{
public:
  ScaledInverse(std::unique_ptr<RestrictedInverse> inverse, const std::vector<TraceDof>& trace)
      : inverse_(std::move(inverse)), trace_(trace)
  {}
  Vector solve(const Vector& b) const override { return normalParts(trace_, inverse_->solve(keptForces(trace_, b))); }

private:
  std::unique_ptr<RestrictedInverse> inverse_;
  const std::vector<TraceDof>& trace_;
};

/// a^-T S a^-1 for an operator that is only applied.
class ScaledOperator final : public AppliedOperator
{
public:
  ScaledOperator(std::unique_ptr<SymmetricOperator> S, std::vector<TraceDof> trace)
      : AppliedOperator(toleranceOf(*S)), owned_(std::move(S)), S_(*asApplied(*owned_)), trace_(std::move(trace))
  {
    for (TraceDof& dof : trace_)
      dof.offset = 0.0;
  }
  int size() const override { return S_.size(); }
  Vector apply(const Vector& x) const override { return normalForces(trace_, S_.apply(keptValues(trace_, x))); }
  bool hasPreconditioner() const override { return S_.hasPreconditioner(); }
  Vector precondition(const Vector& b) const override
  {
    return normalParts(trace_, S_.precondition(keptForces(trace_, b)));
  }
  std::unique_ptr<RestrictedInverse> directInverse(const std::vector<char>& isFree) const override
  {
    for (std::size_t k = 0; k < trace_.size(); ++k)
      if (trace_[k].first >= 0 && isFree[k] != isFree[std::size_t(trace_[k].first)])
        return nullptr;
    auto inverse = S_.directInverse(isFree);
    return inverse ? std::make_unique<ScaledInverse>(std::move(inverse), trace_) : nullptr;
  }

private:
  std::unique_ptr<SymmetricOperator> owned_;
  const AppliedOperator& S_;
  std::vector<TraceDof> trace_; ///< without offsets
};

/// a^-T S a^-1 of a stored operator.
DenseMatrix scaledMatrix(DenseMatrix S, const std::vector<TraceDof>& trace)
{
  const int n = S.cols();
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      S(i, j) *= (1.0 / trace[std::size_t(i)].scale) * (1.0 / trace[std::size_t(j)].scale);
  for (int k = 0; k < n; ++k) {
    const TraceDof& dof = trace[std::size_t(k)];
    if (dof.first < 0)
      continue;
    const double share = dof.along / trace[std::size_t(dof.first)].scale;
    for (int i = 0; i < n; ++i)
      S(i, dof.first) -= share * S(i, k);
    for (int j = 0; j < n; ++j)
      S(dof.first, j) -= share * S(k, j);
  }
  return S;
}

} // namespace

std::shared_ptr<const SymmetricOperator> traceOperator(const CondensedBody& body, const std::vector<TraceDof>& trace,
                                                       const InterfaceOperator& representation)
{
  auto S = representation.represent(body, int(trace.size()));
  if (std::all_of(trace.begin(), trace.end(), [](const TraceDof& t) { return t.scale == 1.0 && t.first < 0; }))
    return S;
  if (const DenseMatrix* stored = S->dense())
    return makeDenseOperator(scaledMatrix(*stored, trace));
  return std::make_shared<ScaledOperator>(std::move(S), trace);
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
