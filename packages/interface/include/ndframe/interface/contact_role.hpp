#pragma once

#include <array>

namespace ndframe
{

/// What a body is at an interface: the Dirichlet body, whose outward normal is n_c, or the Neumann body. At an obstacle
/// the free body is the Dirichlet body.
enum class ContactRole : unsigned char
{
  Dirichlet,
  Neumann
};

inline constexpr std::array bothRoles{ContactRole::Dirichlet, ContactRole::Neumann}; ///< in the order of the signs
/// The sign of the body's part of the jump u1_N - u2_N, and of contact forces along n_c that act on it.
constexpr double signOf(ContactRole role)
{
  return role == ContactRole::Dirichlet ? 1.0 : -1.0;
}
/// The role of the body that it meets.
constexpr ContactRole facing(ContactRole role)
{
  return role == ContactRole::Dirichlet ? ContactRole::Neumann : ContactRole::Dirichlet;
}

} // namespace ndframe
