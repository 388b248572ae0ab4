#include "initial_traction.hpp"

namespace ndframe
{
namespace
{

Vector zeroTraction(const InterfaceSystem& system, const RoleSystem&)
{
  return Vector(std::size_t(system.C->size()), 0.0);
}

/// The traction R a, a combination of the traces R of the Dirichlet bodies' free motions, that carries their loads:
/// R^T (C R a) = - R^T g. Zero where the supports hold all Dirichlet bodies.
Vector balancedTraction(const InterfaceSystem& system, const RoleSystem& dirichlet)
{
  const int modes = dirichlet.freeMotions.cols();
  if (modes == 0)
    return zeroTraction(system, dirichlet);
  std::vector<Vector> tractions;
  for (int m = 0; m < modes; ++m) {
    tractions.push_back(zeroTraction(system, dirichlet));
    for (int i = 0; i < system.size(); ++i)
      tractions.back()[std::size_t(system.nodeOfUnknown[std::size_t(i)])] = dirichlet.freeMotions(i, m);
  }
  DenseMatrix gram(modes, modes);
  Vector load(std::size_t(modes), 0.0);
  for (int m = 0; m < modes; ++m) {
    const Vector force = system.force(tractions[std::size_t(m)]);
    for (int l = 0; l < modes; ++l)
      gram(l, m) = dot(dirichlet.freeMotions.column(l), force);
    load[std::size_t(m)] = -dot(dirichlet.freeMotions.column(m), dirichlet.g);
  }
  const Vector a = DenseCholesky(std::move(gram)).solve(load);
  Vector traction = zeroTraction(system, dirichlet);
  for (int m = 0; m < modes; ++m)
    for (std::size_t i = 0; i < traction.size(); ++i)
      traction[i] += a[std::size_t(m)] * tractions[std::size_t(m)][i];
  return traction;
}

} // namespace

const Names<InitialTraction>& initialTractions()
{
  static const Names<InitialTraction> names{{"Zero", zeroTraction}, {"Balanced", balancedTraction}};
  return names;
}

} // namespace ndframe
