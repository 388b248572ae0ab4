#include "initial_traction.hpp"

namespace ndframe
{
namespace
{

/// Motions that a traction must balance: R^T (C Lambda) = load.
struct Balance
{
  std::vector<Vector> motions; ///< columns of R, per unknown
  Vector load;
};

/// The free motions of some bodies; `sign`: with which the bodies feel r = C Lambda.
void addMotions(Balance& balance, const RoleSystem& bodies, double sign)
{
  for (int m = 0; m < bodies.freeMotions.cols(); ++m) {
    balance.motions.push_back(bodies.freeMotions.column(m));
    balance.load.push_back(-sign * dot(balance.motions.back(), bodies.g));
  }
}

/// C R_m at the unknowns: the forces of the traction that has the values of a motion's trace.
Vector forceLike(const InterfaceSystem& system, const Vector& motion)
{
  Vector traction(std::size_t(system.C->size()), 0.0);
  for (std::size_t i = 0; i < motion.size(); ++i)
    traction[std::size_t(system.nodeOfUnknown[i])] = motion[i];
  return system.force(traction);
}

/// The traction whose forces are the combination of C R that balances the motions.
Vector balancingTraction(const InterfaceSystem& system, const Balance& balance)
{
  Vector force(std::size_t(system.size()), 0.0);
  const int modes = int(balance.motions.size());
  std::vector<Vector> forces;
  for (const auto& motion : balance.motions)
    forces.push_back(forceLike(system, motion));
  DenseMatrix gram(modes, modes);
  for (int m = 0; m < modes; ++m)
    for (int l = 0; l < modes; ++l)
      gram(l, m) = dot(balance.motions[std::size_t(l)], forces[std::size_t(m)]);
  const Vector a = multiply(pseudoInverse(gram, rigidTolerance), balance.load);
  for (std::size_t m = 0; m < a.size(); ++m)
    for (std::size_t i = 0; i < force.size(); ++i)
      force[i] += a[m] * forces[m][i];
  return system.traction(force);
}

/// Zero, but for what floating Neumann bodies need: their problem has no solution under an unbalanced traction.
Vector zeroTraction(const InterfaceSystem& system, const RoleSystem&, const RoleSystem& neumann)
{
  Balance balance;
  addMotions(balance, neumann, -1.0);
  return balancingTraction(system, balance);
}

/// Carries the loads of all floating bodies. Zero where supports hold every body.
Vector balancedTraction(const InterfaceSystem& system, const RoleSystem& dirichlet, const RoleSystem& neumann)
{
  Balance balance;
  addMotions(balance, dirichlet, 1.0);
  addMotions(balance, neumann, -1.0);
  return balancingTraction(system, balance);
}

} // namespace

const Names<InitialTraction>& initialTractions()
{
  static const Names<InitialTraction> names{{"Zero", zeroTraction}, {"Balanced", balancedTraction}};
  return names;
}

} // namespace ndframe
