#include "feti_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace ndframe
{
namespace
{

constexpr int mostIterations = 2000; ///< a pass
/// A pass ends early, looked at every so many iterations, where the rest is this part of what statuses are wrong by,
/// or where its goal is met.
constexpr int looks = 2;
constexpr double ofViolation = 0.3;
constexpr double largestError = 0.1; ///< relative to the forces, whatever the goal: beyond it statuses are guesses
/// What single forces may be wrong by, relative to the largest: so many times the norm's relative error, where that is
/// small, and at least a digit more.
constexpr double amplification = 1e2, leastAmplification = 10.0, amplifiedUpTo = 1e-3;

constexpr double wantedRoundOff = 1e-13; ///< of refinedForces()

/// What S v may have lost: eps max |D v|, D the diagonal of S.
double forceRoundOff(const Network& network, const Vector& v)
{
  double largest = 0.0;
  for (std::size_t b = 0; b < network.bodies.size(); ++b) {
    const DenseMatrix& S = *network.bodies[b]->S->dense();
    for (int k = 0; k < S.cols(); ++k)
      largest = std::max(largest, S(k, k) * std::abs(v[std::size_t(network.offsets[b]) + std::size_t(k)]));
  }
  return std::numeric_limits<double>::epsilon() * largest;
}

} // namespace

FetiProblem::FetiProblem(const Network& network, const FetiStop& stop, Ledger& ledger)
    : network_(network), stop_(stop), ledger_(ledger), motions_(motionNames(network)), bodies_(network),
      v_(std::size_t(network.size()), 0.0), force_(network.bound.size(), 0.0)
{
  amplitude_.assign(std::size_t(bodies_.numMotions()), 0.0);
  std::vector<int> all(network.jump.size());
  std::iota(all.begin(), all.end(), 0);
  independent_ = ClosedRows(network.jump, all, network.bound, network.size()).independentRows();
  std::vector<SparseRow> B;
  for (const int row : independent_)
    B.push_back(network.jump[std::size_t(row)]);
  weighted_ = averagesOf(B, bodies_.softness());
  for (const SparseRow& row : network.jump) {
    flexibility_.push_back(0.0);
    for (const auto& [entry, value] : row)
      flexibility_.back() += value * value / bodies_.weight()[std::size_t(entry)];
  }
}

StatusMemory FetiProblem::memory()
{
  StatusMemory memory;
  memory.displacement = v_;
  memory.force = force_;
  memory.motions = amplitude_;
  memory.isOfForces = true;
  return memory;
}

bool FetiProblem::recall(const StatusMemory& memory)
{
  if (!memory.isOfForces || memory.displacement.size() != v_.size() || memory.force.size() != force_.size() ||
      memory.motions.size() != amplitude_.size())
    return false;
  v_ = memory.displacement;
  force_ = memory.force;
  amplitude_ = memory.motions;
  return true;
}

bool FetiProblem::holds(const std::vector<char>& closed)
{
  if (!set_ || !set_->isOf(closed))
    set_ = std::make_unique<FetiSet>(network_, bodies_, closed, set_.get());
  return set_->holdsMotions();
}

/// The bodies with motions of these amplitudes.
Vector FetiProblem::moved(Vector v, const Vector& amplitudes) const
{
  const Vector motion = bodies_.moved(amplitudes);
  for (std::size_t k = 0; k < v.size(); ++k)
    v[k] += motion[k];
  return v;
}

/// The bodies with the motions that close the rows best.
Vector FetiProblem::placed(const Vector& strained) const
{
  return set_->projects() ? moved(strained, set_->amplitudes(rest(strained), amplitude_)) : strained;
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

/// |B_D^T (B v - bound)_+| in the energy norm.
double FetiProblem::penetration(const Vector& v) const
{
  const Vector jump = rowValues(network_.jump, Vector(network_.jump.size(), 0.0), v);
  Vector moved(v.size(), 0.0);
  for (std::size_t i = 0; i < independent_.size(); ++i) {
    const auto row = std::size_t(independent_[i]);
    for (const auto& [entry, share] : weighted_.rows[i])
      moved[std::size_t(entry)] += share * std::max(0.0, jump[row] - network_.bound[row]);
  }
  return std::sqrt(std::max(0.0, dot(moved, bodies_.stiff(moved))));
}

/// Whether the iterations of a pass end here.
bool FetiProblem::isEnough(const Iterate& now, int iteration, const std::vector<char>& closed)
{
  const double error = std::sqrt(std::max(0.0, now.square));
  relativeError_ = stop_.tolerance;
  if (error <= stop_.tolerance * now.size)
    return true;
  if (iteration % looks != looks - 1 || error > largestError * now.size)
    return false;
  if (error < ofViolation * std::sqrt(violation(now, closed)))
    return true; // the set is wrong: no need to know by how much
  if (error > stop_.goal || penetration(placed(now.v)) > stop_.goal)
    return false;
  relativeError_ = std::max(stop_.tolerance, error / now.size);
  return true;
}

void FetiProblem::solve(const std::vector<char>& closed, double proximal, StatusPass& pass)
{
  if (!holds(closed) && proximal == 0.0)
    throw NotPositiveDefinite(-1);
  // Loads that do no work on what the set leaves free need no proximal term: bodies stay where they were.
  set_->project(set_->canBalance(bodies_.work(network_.g)));
  proximal = set_->projects() ? 0.0 : proximal;
  bodies_.factor(proximal);
  Iterate now = begun(proximal);
  for (int iteration = 0; iteration < mostIterations && !isEnough(now, iteration, closed); ++iteration) {
    ledger_.tell(Depth::Iteration, Progress::falling("iteration", iteration + 1, "error",
                                                     std::sqrt(std::max(0.0, now.square)), stop_.tolerance * now.size));
    advance(now);
  }
  amplitude_ = set_->projects() ? set_->amplitudes(rest(now.v), amplitude_) : bodies_.amplitudes(now.v);
  const Vector before = std::exchange(v_, set_->projects() ? moved(now.v, amplitude_) : now.v);
  error_ = std::max(std::sqrt(std::max(0.0, now.square)), penetration(v_));
  std::fill(force_.begin(), force_.end(), 0.0);
  for (std::size_t i = 0; i < now.r.size(); ++i)
    force_[std::size_t(set_->rows()[i])] = now.r[i];
  pass.force = force_;
  setDisplacement(network_, v_, pass);
  pass.roundOff = roundOff();
  pass.unbalanced = 0.0;
  for (std::size_t k = 0; k < v_.size(); ++k)
    pass.unbalanced = std::max(pass.unbalanced, proximal * bodies_.weight()[k] * std::abs(v_[k] - before[k]));
}

double FetiProblem::roundOff() const
{
  return std::max(
      {statusRoundOff, leastAmplification * relativeError_, std::min(amplification * relativeError_, amplifiedUpTo)});
}

Vector refinedForces(const Network& network, const Vector& v, UnilateralState& status, Ledger& ledger)
{
  if (forceRoundOff(network, v) <= wantedRoundOff * largestEntry(status.force))
    return v;
  FetiProblem forces(network, {refinedTolerance}, ledger);
  if (!forces.holds(status.closed))
    return v;
  StatusPass pass;
  forces.startFrom(status.force);
  forces.solve(status.closed, 0.0, pass);
  status.u = std::move(pass.u);
  status.force = std::move(pass.force);
  return forces.displacement();
}

} // namespace ndframe
