#include "ndframe/interface/body_trace.hpp"

#include <algorithm>

#include "ndframe/interface/applied_operator.hpp"

namespace ndframe
{
namespace
{

/// a^-1 S a^-1 for an operator that is only applied.
class ScaledOperator final : public AppliedOperator
{
public:
  ScaledOperator(std::unique_ptr<SymmetricOperator> S, Vector inverseScale, double tolerance)
      : AppliedOperator(tolerance), S_(std::move(S)), inverseScale_(std::move(inverseScale))
  {}
  int size() const override { return S_->size(); }
  Vector apply(const Vector& x) const override { return scaled(S_->apply(scaled(x))); }

private:
  Vector scaled(Vector v) const
  {
    for (std::size_t i = 0; i < v.size(); ++i)
      v[i] *= inverseScale_[i];
    return v;
  }
  std::unique_ptr<SymmetricOperator> S_;
  Vector inverseScale_;
};

} // namespace

std::shared_ptr<const SymmetricOperator> traceOperator(const CondensedBody& body, const std::vector<TraceDof>& trace,
                                                       const InterfaceOperator& representation)
{
  auto S = representation.represent(body, int(trace.size()));
  if (std::all_of(trace.begin(), trace.end(), [](const TraceDof& t) { return t.scale == 1.0; }))
    return S;
  Vector inverse;
  for (const auto& t : trace)
    inverse.push_back(1.0 / t.scale);
  if (const DenseMatrix* stored = S->dense()) {
    DenseMatrix scaled = *stored;
    for (int j = 0; j < scaled.cols(); ++j)
      for (int i = 0; i < scaled.rows(); ++i)
        scaled(i, j) *= inverse[std::size_t(i)] * inverse[std::size_t(j)];
    return makeDenseOperator(std::move(scaled));
  }
  const double tolerance = toleranceOf(*S);
  return std::make_shared<ScaledOperator>(std::move(S), std::move(inverse), tolerance);
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
