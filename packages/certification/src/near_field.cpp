#include "near_field.hpp"

namespace ndframe
{
namespace
{

constexpr int mostStepsNear = 10; ///< what is smooth by then takes more than the recovery

/// K of a body that every rank has as a whole, or of which this one has a part: values at others' nodes are zero then,
/// but for those that K is applied to.
class System
{
public:
  System(const BodySystem& system, const Comm& comm)
      : system_(system), comm_(comm), D_(system.share ? diagonalOfPart() : diagonal(system.K, comm))
  {}

  /// load - K x on what is not fixed, zero elsewhere.
  Vector residual(const Vector& load, Vector& x) const
  {
    if (system_.share)
      system_.share->fetch(x, system_.K.dim);
    Vector r = system_.forcesOf(x, comm_);
    for (std::size_t dof = 0; dof < r.size(); ++dof)
      r[dof] = system_.dofs.roles[dof] != DofRole::Fixed ? load[dof] - r[dof] : 0.0;
    if (system_.share)
      system_.share->annulOthers(r, system_.K.dim);
    return r;
  }

  double dotOfAll(const Vector& a, const Vector& b) const
  {
    Vector sum{dot(a, b)};
    if (system_.share)
      comm_.sum(sum);
    return sum.front();
  }

  /// D^-1 r
  Vector scaled(Vector r) const
  {
    for (std::size_t dof = 0; dof < r.size(); ++dof)
      r[dof] /= D_[dof];
    return r;
  }

private:
  /// Ones at others' nodes.
  Vector diagonalOfPart() const
  {
    Vector d(system_.dofs.roles.size(), 1.0);
    for (int r = 0; r < system_.K.numRows(); ++r)
      for (int i = 0; i < system_.K.dim; ++i)
        d[std::size_t(system_.partNodes[std::size_t(r)]) * std::size_t(system_.K.dim) + std::size_t(i)] =
            system_.K.block(r, r)[std::ptrdiff_t(i) * (system_.K.dim + 1)];
    return d;
  }

  const BodySystem& system_;
  const Comm& comm_;
  Vector D_;
};

/// Conjugate gradients from u; whether they came near enough.
bool descend(const System& system, const Vector& load, double enough, int mostSteps, Vector& u)
{
  const Vector none(u.size(), 0.0);
  Vector r = system.residual(load, u), p(u.size(), 0.0);
  double before = 0.0;
  for (int step = 0; step <= mostSteps; ++step) {
    const Vector z = system.scaled(r);
    const double square = system.dotOfAll(r, z);
    if (!(square > enough))
      return true;
    const double kept = step > 0 ? square / before : 0.0;
    for (std::size_t dof = 0; dof < p.size(); ++dof)
      p[dof] = z[dof] + kept * p[dof];
    const Vector change = system.residual(none, p); // - K p, zero where p has others' values
    const double curvature = -system.dotOfAll(p, change);
    if (!(curvature > 0.0))
      break;
    for (std::size_t dof = 0; dof < r.size(); ++dof) {
      u[dof] += square / curvature * p[dof];
      r[dof] += square / curvature * change[dof];
    }
    before = square;
  }
  return false;
}

} // namespace

std::optional<Vector> nearField(const BodySystem& system, const Vector& load, Vector u, double enough, const Comm& comm)
{
  if (descend(System(system, comm), load, enough, mostStepsNear, u))
    return u;
  return std::nullopt;
}

Vector fieldOfPart(const BodySystem& system, const Vector& load, Vector u, double enough, const Comm& comm)
{
  constexpr int mostSteps = 3000; // some ten times as many as a million dofs take
  constexpr double solved = 1e-8; // beside what is near; the recovery settles what is left of it
  descend(System(system, comm), load, solved * enough, mostSteps, u);
  return u;
}

} // namespace ndframe
