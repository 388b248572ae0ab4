#include "initial_traction.hpp"

#include <algorithm>

#include "motion_balance.hpp"

namespace ndframe
{
namespace
{

/// Motions that contact forces must balance: R^T r = work.
struct Demand
{
  DenseMatrix motions;
  Vector work;
};

/// The free motions of both roles; r acts on the Dirichlet bodies, -r on the Neumann bodies.
Demand demandOfAll(const RoleSystem& dirichlet, const RoleSystem& neumann)
{
  const DenseMatrix &R1 = dirichlet.freeMotions, &R2 = neumann.freeMotions;
  Demand demand{DenseMatrix(R1.rows(), R1.cols() + R2.cols()), multiplyTransposed(R1, dirichlet.g)};
  for (int m = 0; m < R1.cols(); ++m)
    std::copy_n(R1.col(m), R1.rows(), demand.motions.col(m));
  for (int m = 0; m < R2.cols(); ++m)
    std::copy_n(R2.col(m), R2.rows(), demand.motions.col(R1.cols() + m));
  for (double& work : demand.work)
    work = -work;
  const Vector other = multiplyTransposed(R2, neumann.g);
  demand.work.insert(demand.work.end(), other.begin(), other.end());
  return demand;
}

InterfaceValues tractionFor(const InterfaceSystem& system, Demand demand, UnknownValues force)
{
  const MotionBalance balance(system, std::move(demand.motions));
  return system.traction(balance.corrected(std::move(force), std::move(demand.work)));
}

UnknownValues noForce(const InterfaceSystem& system)
{
  return ofUnknowns(Vector(std::size_t(system.size()), 0.0));
}

/// Zero, but for what floating Neumann bodies need: their problem has no solution under an unbalanced traction.
InterfaceValues zeroTraction(const InterfaceSystem& system, const RoleSystem&, const RoleSystem& neumann)
{
  return tractionFor(system, {neumann.freeMotions, multiplyTransposed(neumann.freeMotions, neumann.g)},
                     noForce(system));
}

/// Carries the loads of all floating bodies. Zero where supports hold every body.
InterfaceValues balancedTraction(const InterfaceSystem& system, const RoleSystem& dirichlet, const RoleSystem& neumann)
{
  return tractionFor(system, demandOfAll(dirichlet, neumann), noForce(system));
}

} // namespace

const Names<InitialTraction>& initialTractions()
{
  static const Names<InitialTraction> names{{"Zero", zeroTraction}, {"Balanced", balancedTraction}};
  return names;
}

InterfaceValues carriedTraction(const InterfaceSystem& system, const RoleSystem& dirichlet, const RoleSystem& neumann,
                                const InterfaceValues& given)
{
  return tractionFor(system, demandOfAll(dirichlet, neumann), system.force(given));
}

} // namespace ndframe
