#include "network_bodies.hpp"

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/subdomain/neumann_problem.hpp"

namespace ndframe
{
namespace
{

/// Of the largest diagonal entry: the least weight.
constexpr double softest = 1e-6;
constexpr double roundOff = 1e-10; ///< of motions that kept dofs do not feel

Vector part(const Vector& v, int first, int last)
{
  return {v.begin() + first, v.begin() + last};
}

} // namespace

NetworkBodies::NetworkBodies(const Network& network) : network_(network)
{
  for (const BodyTrace* body : network.bodies) {
    const DenseMatrix* S = body->S->dense();
    NDFRAME_ASSERT(S != nullptr, "a network needs stored interface operators");
    for (int k = 0; k < S->cols(); ++k)
      weight_.push_back((*S)(k, k));
    firstMotion_.push_back(firstMotion_.back() + body->freeMotions.cols());
  }
  const double largest = largestEntry(weight_);
  for (double& value : weight_)
    value = largest > 0.0 ? std::max(value, softest * largest) : 1.0;
  for (const double value : weight_)
    softness_.push_back(1.0 / value);
}

void NetworkBodies::factor(double proximal)
{
  if (proximal == proximal_)
    return;
  inverse_.clear();
  shifted_.clear();
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const BodyTrace& body = *network_.bodies[b];
    if (proximal == 0.0) {
      inverse_.push_back(body.S->inverseOn(freeWhenHeld(body.freeMotions), 0.0));
      continue;
    }
    DenseMatrix S = *body.S->dense();
    for (int k = 0; k < S.cols(); ++k)
      S(k, k) += proximal * weight_[std::size_t(network_.offsets[b]) + std::size_t(k)];
    const std::vector<char> all(std::size_t(S.cols()), 1);
    shifted_.push_back(makeDenseOperator(std::move(S)));
    inverse_.push_back(shifted_.back()->inverseOn(all, 0.0));
  }
  proximal_ = proximal;
}

Vector NetworkBodies::stiff(const Vector& v) const
{
  return bodyByBody(v, [&](std::size_t b, const Vector& own) { return network_.bodies[b]->S->apply(own); });
}

Vector NetworkBodies::unbalanced(const Vector& v, double proximal, const Vector& centre) const
{
  Vector rest = stiff(v);
  for (std::size_t k = 0; k < rest.size(); ++k)
    rest[k] = network_.g[k] - rest[k] - proximal * weight_[k] * (v[k] - centre[k]);
  return rest;
}

Vector NetworkBodies::flexible(const Vector& f) const
{
  return bodyByBody(f, [&](std::size_t b, const Vector& own) { return inverse_[b]->solve(own); });
}

Vector NetworkBodies::moved(const Vector& amplitudes) const
{
  Vector v;
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const Vector own =
        multiply(network_.bodies[b]->freeMotions, part(amplitudes, firstMotion_[b], firstMotion_[b + 1]));
    v.insert(v.end(), own.begin(), own.end());
  }
  return v;
}

SparseColumns NetworkBodies::motionColumns(const std::vector<SparseRow>& columns, int rows) const
{
  SparseColumns product(rows, numMotions());
  SparseSum sum(rows);
  for (std::size_t b = 0, motion = 0; b < network_.bodies.size(); ++b) {
    const DenseMatrix& R = network_.bodies[b]->freeMotions;
    for (int m = 0; m < R.cols(); ++m, ++motion) {
      for (int k = 0; k < R.rows(); ++k)
        sum.add(columns[std::size_t(network_.offsets[b]) + std::size_t(k)], R(k, m));
      product.setColumn(int(motion), sum.take());
    }
  }
  return product;
}

Vector NetworkBodies::amplitudes(const Vector& v) const
{
  Vector a;
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const Vector own = multiply(pseudoInverse(network_.bodies[b]->freeMotions, roundOff),
                                part(v, network_.offsets[b], network_.offsets[b + 1]));
    a.insert(a.end(), own.begin(), own.end());
  }
  return a;
}

Vector NetworkBodies::work(const Vector& f) const
{
  Vector result;
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    const Vector own =
        multiplyTransposed(network_.bodies[b]->freeMotions, part(f, network_.offsets[b], network_.offsets[b + 1]));
    result.insert(result.end(), own.begin(), own.end());
  }
  return result;
}

} // namespace ndframe
