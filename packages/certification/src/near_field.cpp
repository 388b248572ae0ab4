#include "near_field.hpp"

namespace ndframe
{
namespace
{

constexpr int mostSteps = 10; ///< what is smooth by then takes more than the recovery

/// load - K x on what is not fixed, zero elsewhere.
Vector residual(const BodySystem& system, const Vector& load, const Vector& x, const Comm& comm)
{
  Vector r = multiply(system.K, x, comm);
  for (std::size_t dof = 0; dof < r.size(); ++dof)
    r[dof] = system.dofs.roles[dof] != DofRole::Fixed ? load[dof] - r[dof] : 0.0;
  return r;
}

} // namespace

std::optional<Vector> nearField(const BodySystem& system, const Vector& load, Vector u, double enough, const Comm& comm)
{
  const Vector D = diagonal(system.K, comm), none(u.size(), 0.0);
  Vector r = residual(system, load, u, comm), p(u.size(), 0.0);
  double before = 0.0;
  for (int step = 0; step <= mostSteps; ++step) {
    double square = 0.0, curvature = 0.0;
    for (std::size_t dof = 0; dof < r.size(); ++dof)
      square += r[dof] * r[dof] / D[dof];
    if (!(square > enough))
      return u;
    const double kept = step > 0 ? square / before : 0.0;
    for (std::size_t dof = 0; dof < r.size(); ++dof)
      p[dof] = r[dof] / D[dof] + kept * p[dof];
    const Vector change = residual(system, none, p, comm); // - K p
    for (std::size_t dof = 0; dof < r.size(); ++dof)
      curvature -= p[dof] * change[dof];
    if (!(curvature > 0.0))
      break;
    for (std::size_t dof = 0; dof < r.size(); ++dof) {
      u[dof] += square / curvature * p[dof];
      r[dof] += square / curvature * change[dof];
    }
    before = square;
  }
  return std::nullopt;
}

} // namespace ndframe
