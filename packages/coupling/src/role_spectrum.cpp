#include "ndframe/coupling/role_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "ndframe/subdomain/neumann_problem.hpp"
#include "sweep.hpp"

namespace ndframe
{
namespace
{

constexpr int mostSteps = 24;
constexpr double settled = 1e-3; ///< relative change of the extreme eigenvalues in one step
constexpr double nothing = 1e-6; ///< relative size below which a vector is round-off

/// For every body of the system the first body of its connected part.
std::vector<std::size_t> partOfBodies(const InterfaceSystem& system)
{
  std::vector<std::size_t> part(system.bodies.size()), first(std::size_t(system.size()), system.bodies.size());
  std::iota(part.begin(), part.end(), std::size_t(0));
  for (std::size_t b = 0; b < part.size(); ++b)
    for (const int unknown : system.bodies[b].unknowns) {
      auto& other = first[std::size_t(unknown)];
      if (other == part.size())
        other = b;
      const std::size_t from = std::max(part[other], part[b]), to = std::min(part[other], part[b]);
      if (from != to)
        std::replace(part.begin(), part.end(), from, to);
    }
  return part;
}

/// The system of one connected part; its contact matrix is not needed and stays out.
InterfaceSystem extractPart(const InterfaceSystem& system, const std::vector<std::size_t>& partOf, std::size_t part)
{
  InterfaceSystem result;
  std::vector<int> number(std::size_t(system.size()), -1);
  for (std::size_t b = 0; b < system.bodies.size(); ++b) {
    if (partOf[b] != part)
      continue;
    BodyTrace body = system.bodies[b];
    for (int& unknown : body.unknowns) {
      int& known = number[std::size_t(unknown)];
      if (known < 0) {
        known = result.size();
        result.nodeOfUnknown.push_back(system.nodeOfUnknown[std::size_t(unknown)]);
        result.isObstacle.push_back(system.isObstacle[std::size_t(unknown)]);
      }
      unknown = known;
    }
    result.bodies.push_back(std::move(body));
  }
  return result;
}

/// The sweep of the linear iteration, e -> S_D u with u = S_N^-1 e + R alpha and R^T S_D u = 0, R the free motions of
/// the Neumann bodies; on the forces e that strain both sides: R^T e = 0 for the motions of all bodies. Obstacles hold:
/// u = 0 there, and e does not count.
class LinearSweep
{
public:
  LinearSweep(const InterfaceSystem& part, Ledger& ledger)
      : dirichlet_(gatherRole(part, ContactRole::Dirichlet)), neumann_(gatherRole(part, ContactRole::Neumann)),
        isObstacle_(part.isObstacle),
        inverse_(neumann_.S->inverseOn(freeWhenHeld(neumann_.freeMotions, isObstacle_), 0.0)),
        stiffMotions_(part.size(), neumann_.freeMotions.cols()), ledger_(ledger)
  {
    ledger_.count("interface factorisations");
    for (int m = 0; m < stiffMotions_.cols(); ++m) {
      const Vector stiff = dirichlet_.S->apply(neumann_.freeMotions.column(m));
      std::copy(stiff.begin(), stiff.end(), stiffMotions_.col(m));
    }
    placing_ = pseudoInverse(multiplyTransposed(neumann_.freeMotions, stiffMotions_), rigidTolerance);
    const DenseMatrix own = motionsAtRest(dirichlet_.freeMotions, isObstacle_);
    const auto split = own.cols() * part.size();
    motions_ = DenseMatrix(part.size(), own.cols() + neumann_.freeMotions.cols());
    std::copy_n(own.data(), split, motions_.data());
    std::copy_n(neumann_.freeMotions.data(), stiffMotions_.cols() * part.size(), motions_.data() + split);
    balancing_ = pseudoInverse(motions_, rigidTolerance);
  }

  /// S_N^-1 e, up to rigid motions.
  Vector displacement(const Vector& force) const
  {
    ledger_.count("role steps");
    return inverse_->solve(force);
  }
  /// S_D (u + R alpha).
  Vector answer(const Vector& u) const
  {
    Vector force = dirichlet_.S->apply(u);
    if (stiffMotions_.cols() > 0)
      subtract(force, stiffMotions_, multiply(placing_, multiplyTransposed(neumann_.freeMotions, force)));
    return balanced(std::move(force));
  }
  /// The nearest force that does no work on the motions.
  Vector balanced(Vector force) const
  {
    clear(force.data());
    if (motions_.cols() > 0)
      subtract(force, motions_, multiply(balancing_, force));
    return force;
  }
  bool dirichletFloats() const { return dirichlet_.freeMotions.cols() > 0; }
  bool neumannFloats() const { return neumann_.freeMotions.cols() > 0; }

private:
  /// What stands at obstacles.
  void clear(double* values) const
  {
    for (std::size_t i = 0; i < isObstacle_.size(); ++i)
      if (isObstacle_[i])
        values[i] = 0.0;
  }

  static void subtract(Vector& force, const DenseMatrix& A, const Vector& x)
  {
    force = difference(std::move(force), multiply(A, x));
  }

  RoleSystem dirichlet_, neumann_;
  std::vector<char> isObstacle_;
  std::unique_ptr<RestrictedInverse> inverse_;
  DenseMatrix stiffMotions_, placing_; ///< S_D R, (R^T S_D R)^+
  DenseMatrix motions_, balancing_;    ///< of all bodies; its pseudo-inverse
  Ledger& ledger_;
};

/// Forces without preference for any wave length; the same in every run.
Vector mixedForces(int size)
{
  std::minstd_rand random;
  Vector forces;
  for (int i = 0; i < size; ++i)
    forces.push_back(2.0 * double(random() - std::minstd_rand::min()) / double(std::minstd_rand::max()) - 1.0);
  return forces;
}

/// Lanczos in the product <e, f> = e^T S_N^-1 f, in which the sweep is symmetric; with full orthogonalisation.
class Lanczos
{
public:
  explicit Lanczos(const LinearSweep& sweep) : sweep_(sweep) {}

  /// Joins the direction of a force to the basis; false when nothing of it is new. Throws NotPositiveDefinite.
  bool add(Vector force)
  {
    const double size = norm(force);
    for (int pass = 0; pass < 2; ++pass)
      for (std::size_t k = 0; k < forces_.size(); ++k)
        addScaled(force, -dot(force, displacements_[k]), forces_[k]);
    force = sweep_.balanced(std::move(force)); // what is left may be small, and round-off among the free motions large
    if (!(norm(force) > nothing * size))
      return false;
    Vector u = sweep_.displacement(force);
    const double work = dot(force, u);
    if (!(work > 0.0))
      throw NotPositiveDefinite{-1};
    const double length = std::sqrt(work);
    for (std::size_t i = 0; i < u.size(); ++i) {
      force[i] /= length;
      u[i] /= length;
    }
    answers_.push_back(sweep_.answer(u));
    forces_.push_back(std::move(force));
    displacements_.push_back(std::move(u));
    return true;
  }
  const Vector& lastAnswer() const { return answers_.back(); }

  /// Ritz values, ascending.
  Vector eigenvalues() const
  {
    const int n = int(forces_.size());
    DenseMatrix T(n, n);
    for (int j = 0; j < n; ++j)
      for (int i = j; i < n; ++i)
        T(i, j) = dot(answers_[std::size_t(i)], displacements_[std::size_t(j)]);
    return symmetricEigenvalues(std::move(T));
  }

private:
  static void addScaled(Vector& a, double factor, const Vector& b)
  {
    for (std::size_t i = 0; i < a.size(); ++i)
      a[i] += factor * b[i];
  }

  const LinearSweep& sweep_;
  std::vector<Vector> forces_, displacements_, answers_;
};

RoleSpectrum knownSpectrum(const InterfaceSystem& part, Ledger& ledger)
{
  const LinearSweep sweep(part, ledger);
  RoleSpectrum spectrum;
  spectrum.dirichletFloats = sweep.dirichletFloats();
  spectrum.neumannFloats = sweep.neumannFloats();
  const Vector start = mixedForces(part.size());
  Vector next = sweep.balanced(start);
  if (!(norm(next) > nothing * norm(start)))
    return spectrum;
  Lanczos lanczos(sweep);
  for (int step = 0; step < mostSteps && lanczos.add(std::move(next)); ++step) {
    const RoleSpectrum before = spectrum;
    const Vector mu = lanczos.eigenvalues();
    if (!(mu.front() > 0.0)) // forces that strain both sides
      throw NotPositiveDefinite{-1};
    spectrum.smallest = mu.front();
    spectrum.largest = mu.back();
    if (std::abs(spectrum.smallest - before.smallest) <= settled * spectrum.smallest &&
        std::abs(spectrum.largest - before.largest) <= settled * spectrum.largest)
      break;
    next = lanczos.lastAnswer();
  }
  return spectrum;
}

RoleSpectrum spectrumOf(const InterfaceSystem& part, Ledger& ledger)
{
  try {
    return knownSpectrum(part, ledger);
  } catch (const NotPositiveDefinite&) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, unknown};
  }
}

} // namespace

bool RoleSpectrum::isKnown() const
{
  return !std::isnan(largest);
}

double RoleSpectrum::contraction() const
{
  const double least = dirichletFloats ? 0.0 : smallest;
  return (largest - least) / (2.0 + least + largest);
}

double RoleSpectrum::bestTheta() const
{
  return 2.0 / (2.0 + (dirichletFloats ? 0.0 : smallest) + largest);
}

double RoleSpectrum::contraction(double theta) const
{
  const double least = dirichletFloats ? 0.0 : smallest;
  return std::max(std::abs(1.0 - theta * (1.0 + least)), std::abs(1.0 - theta * (1.0 + largest)));
}

RoleSpectrum RoleSpectrum::exchanged() const
{
  const auto inverse = [](double mu) { return mu > 0.0 ? 1.0 / mu : mu; };
  return {inverse(largest), inverse(smallest), neumannFloats, dirichletFloats};
}

std::vector<ConnectedBodies> roleSpectra(const InterfaceSystem& system, Ledger& ledger)
{
  const auto partOf = partOfBodies(system);
  std::vector<ConnectedBodies> parts;
  for (std::size_t part = 0; part < partOf.size(); ++part) {
    if (partOf[part] != part)
      continue;
    const InterfaceSystem bodies = extractPart(system, partOf, part);
    ConnectedBodies connected;
    for (const auto& body : bodies.bodies)
      connected.bodies.push_back(body.body);
    connected.spectrum = spectrumOf(bodies, ledger);
    parts.push_back(std::move(connected));
  }
  return parts;
}

RoleSpectrum joinedSpectrum(const std::vector<ConnectedBodies>& parts)
{
  RoleSpectrum joined;
  for (const auto& part : parts) {
    const RoleSpectrum& one = part.spectrum;
    const bool isFirst = &part == &parts.front();
    if (!one.isKnown())
      return one;
    joined.smallest = isFirst ? one.smallest : std::min(joined.smallest, one.smallest);
    joined.largest = std::max(joined.largest, one.largest);
    joined.dirichletFloats = joined.dirichletFloats || one.dirichletFloats;
    joined.neumannFloats = joined.neumannFloats || one.neumannFloats;
  }
  return joined;
}

} // namespace ndframe
