#include "ndframe/interface/body_trace.hpp"

#include <algorithm>

#include "ndframe/interface/applied_operator.hpp"

namespace ndframe
{
namespace
{

Vector product(Vector v, const Vector& scale)
{
  for (std::size_t i = 0; i < v.size(); ++i)
    v[i] *= scale[i];
  return v;
}

/// a S_FF^-1 a.
class ScaledInverse final : public RestrictedInverse
{
public:
  ScaledInverse(std::unique_ptr<RestrictedInverse> inverse, const Vector& scale)
      : inverse_(std::move(inverse)), scale_(scale)
  {}
  Vector solve(const Vector& b) const override { return product(inverse_->solve(product(b, scale_)), scale_); }

private:
  std::unique_ptr<RestrictedInverse> inverse_;
  const Vector& scale_;
};

/// a^-1 S a^-1 for an operator that is only applied.
class ScaledOperator final : public AppliedOperator
{
public:
  ScaledOperator(std::unique_ptr<SymmetricOperator> S, Vector scale, Vector inverseScale)
      : AppliedOperator(toleranceOf(*S)), owned_(std::move(S)), S_(*asApplied(*owned_)), scale_(std::move(scale)),
        inverseScale_(std::move(inverseScale))
  {}
  int size() const override { return S_.size(); }
  Vector apply(const Vector& x) const override { return product(S_.apply(product(x, inverseScale_)), inverseScale_); }
  bool hasPreconditioner() const override { return S_.hasPreconditioner(); }
  Vector precondition(const Vector& b) const override { return product(S_.precondition(product(b, scale_)), scale_); }
  std::unique_ptr<RestrictedInverse> directInverse(const std::vector<char>& isFree) const override
  {
    auto inverse = S_.directInverse(isFree);
    return inverse ? std::make_unique<ScaledInverse>(std::move(inverse), scale_) : nullptr;
  }

private:
  std::unique_ptr<SymmetricOperator> owned_;
  const AppliedOperator& S_;
  Vector scale_, inverseScale_;
};

} // namespace

std::shared_ptr<const SymmetricOperator> traceOperator(const CondensedBody& body, const std::vector<TraceDof>& trace,
                                                       const InterfaceOperator& representation)
{
  auto S = representation.represent(body, int(trace.size()));
  if (std::all_of(trace.begin(), trace.end(), [](const TraceDof& t) { return t.scale == 1.0; }))
    return S;
  Vector scale, inverse;
  for (const auto& t : trace) {
    scale.push_back(t.scale);
    inverse.push_back(1.0 / t.scale);
  }
  if (const DenseMatrix* stored = S->dense()) {
    DenseMatrix scaled = *stored;
    for (int j = 0; j < scaled.cols(); ++j)
      for (int i = 0; i < scaled.rows(); ++i)
        scaled(i, j) *= inverse[std::size_t(i)] * inverse[std::size_t(j)];
    return makeDenseOperator(std::move(scaled));
  }
  return std::make_shared<ScaledOperator>(std::move(S), std::move(scale), std::move(inverse));
}

Vector traceLoad(const CondensedBody& body, const std::vector<TraceDof>& trace, const SymmetricOperator& S,
                 const Vector& load)
{
  Vector g = body.reduce(DenseMatrix(load)).column(0);
  Vector offset;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    g[i] /= trace[i].scale;
    offset.push_back(trace[i].offset);
  }
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
  return kept;
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
