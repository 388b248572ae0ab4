#include "feti_problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ndframe
{
namespace
{

constexpr int mostIterations = 2000; ///< a pass
/// A pass ends early, looked at every so many iterations, where the rest is this part of what statuses are wrong by,
/// and of the forces.
constexpr int looks = 2;
constexpr double ofViolation = 0.3, coarseTolerance = 0.1;
constexpr double amplification = 1e2; ///< of the tolerance: what single forces may be wrong by, relative to the largest

} // namespace

FetiProblem::FetiProblem(const Network& network, double tolerance, Ledger& ledger)
    : network_(network), tolerance_(tolerance), ledger_(ledger), bodies_(network), v_(std::size_t(network.size()), 0.0),
      force_(network.bound.size(), 0.0)
{
  for (const BodyTrace* body : network.bodies)
    motions_.insert(motions_.end(), body->motionNames.begin(), body->motionNames.end());
  for (const SparseRow& row : network.jump) {
    flexibility_.push_back(0.0);
    for (const auto& [entry, value] : row)
      flexibility_.back() += value * value / bodies_.weight()[std::size_t(entry)];
  }
}

bool FetiProblem::holds(const std::vector<char>& closed)
{
  if (!set_ || !set_->isOf(closed))
    set_ = std::make_unique<FetiSet>(network_, bodies_, closed, set_.get());
  return set_->holdsMotions();
}

/// The bodies with the motions that close the rows best.
Vector FetiProblem::placed(const Vector& strained) const
{
  Vector v = strained;
  if (!set_->projects())
    return v;
  const Vector motion = bodies_.moved(set_->amplitudes(rest(strained)));
  for (std::size_t k = 0; k < v.size(); ++k)
    v[k] += motion[k];
  return v;
}

/// bound - B v.
Vector FetiProblem::rest(const Vector& v) const
{
  Vector w = set_->jump(v);
  for (std::size_t i = 0; i < w.size(); ++i)
    w[i] = network_.bound[std::size_t(set_->rows()[i])] - w[i];
  return w;
}

/// Where the conjugate gradients stand.
struct FetiProblem::Iterate
{
  Vector load; ///< with the proximal term's
  Vector r, v; ///< forces; S^+ (load + B^T r)
  Vector w, z, p;
  double square = 0.0; ///< w . z
  double size = 0.0;   ///< of the forces, in the norm of F
};

/// Begins with the forces of the pass before and those that balance the load.
FetiProblem::Iterate FetiProblem::begun(double proximal) const
{
  Iterate now;
  now.load = network_.g;
  for (std::size_t k = 0; proximal > 0.0 && k < now.load.size(); ++k)
    now.load[k] += proximal * bodies_.weight()[k] * v_[k];
  for (const int row : set_->rows())
    now.r.push_back(force_[std::size_t(row)]);
  if (set_->projects()) { // G r = - R^T load
    Vector missing = set_->work(now.r);
    const Vector work = bodies_.work(now.load);
    for (std::size_t j = 0; j < missing.size(); ++j)
      missing[j] = -work[j] - missing[j];
    const Vector more = set_->balancing(missing);
    for (std::size_t i = 0; i < now.r.size(); ++i)
      now.r[i] += more[i];
  }
  const Vector pushed = set_->pushed(now.r);
  Vector force = now.load;
  for (std::size_t k = 0; k < force.size(); ++k)
    force[k] += pushed[k];
  now.v = bodies_.flexible(force);
  now.w = set_->projectedTransposed(rest(now.v));
  now.z = set_->projected(set_->preconditioned(now.w));
  now.p = now.z;
  now.square = dot(now.w, now.z);
  now.size = std::sqrt(std::max(now.square, std::abs(dot(pushed, bodies_.flexible(pushed)))));
  return now;
}

void FetiProblem::advance(Iterate& now) const
{
  ledger_.count("FETI iterations");
  const Vector dv = bodies_.flexible(set_->pushed(now.p)), Fp = set_->jump(dv);
  const double step = now.square / dot(now.p, Fp), last = now.square;
  for (std::size_t i = 0; i < now.r.size(); ++i) {
    now.r[i] += step * now.p[i];
    now.w[i] -= step * Fp[i];
  }
  for (std::size_t k = 0; k < dv.size(); ++k)
    now.v[k] += step * dv[k];
  now.w = set_->projectedTransposed(std::move(now.w));
  now.z = set_->projected(set_->preconditioned(now.w));
  now.square = dot(now.w, now.z);
  for (std::size_t i = 0; i < now.p.size(); ++i)
    now.p[i] = now.z[i] + now.square / last * now.p[i];
}

/// How wrong the statuses are: the energy of tension at closed and of penetration at open unknowns, each by itself.
double FetiProblem::violation(const Iterate& now, const std::vector<char>& closed) const
{
  const Vector jump = rowValues(network_.jump, Vector(network_.jump.size(), 0.0), placed(now.v));
  const double noForce = roundOff() * largestEntry(now.r), noGap = roundOff() * largestEntry(now.v);
  double square = 0.0;
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (const double gap = jump[i] - network_.bound[i]; !closed[i] && gap > noGap)
      square += gap * gap / flexibility_[i];
  for (std::size_t i = 0; i < now.r.size(); ++i)
    if (now.r[i] > noForce)
      square += now.r[i] * now.r[i] * flexibility_[std::size_t(set_->rows()[i])];
  return square;
}

void FetiProblem::solve(const std::vector<char>& closed, double proximal, StatusPass& pass)
{
  if (!holds(closed) && proximal == 0.0)
    throw NotPositiveDefinite(-1);
  bodies_.factor(proximal);
  Iterate now = begun(proximal);
  for (int iteration = 0; now.square > std::pow(tolerance_ * now.size, 2) && iteration < mostIterations; ++iteration) {
    if (iteration % looks == looks - 1 && now.square < std::pow(coarseTolerance * now.size, 2) &&
        now.square < std::pow(ofViolation, 2) * violation(now, closed))
      break; // the set is wrong: no need to know by how much
    advance(now);
  }
  const Vector before = std::exchange(v_, placed(now.v));
  std::fill(force_.begin(), force_.end(), 0.0);
  for (std::size_t i = 0; i < now.r.size(); ++i)
    force_[std::size_t(set_->rows()[i])] = now.r[i];
  pass.force = force_;
  pass.u = rowValues(network_.jump, Vector(network_.jump.size(), 0.0), v_);
  pass.displacement = largestEntry(v_);
  pass.load = largestEntry(network_.g);
  pass.roundOff = roundOff();
  pass.unbalanced = 0.0;
  for (std::size_t k = 0; k < v_.size(); ++k)
    pass.unbalanced = std::max(pass.unbalanced, proximal * bodies_.weight()[k] * std::abs(v_[k] - before[k]));
}

double FetiProblem::roundOff() const
{
  return std::max(statusRoundOff, amplification * tolerance_);
}

} // namespace ndframe
