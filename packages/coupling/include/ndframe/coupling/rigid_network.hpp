#pragma once

#include <vector>

#include "ndframe/algebra/linear_program.hpp"

namespace ndframe
{

/// The rigid motions a that supports leave free, of all bodies together, and what contact says of them: (B R a)_i is
/// how far the motion takes the two sides of an interface node into each other, and must not be positive. Gaps do not
/// enter: they end a motion, not its direction.
struct RigidNetwork
{
  std::vector<SparseRow> approach; ///< B R; entries of the order of 1
  Vector work;                     ///< w: of the loads along each motion
  Vector magnitude;                ///< sum of |force| |displacement| at the points where the loads act
  Vector reluctance;               ///< > 0; of several motions that do, the one with the least sum of these is told

  int size() const { return int(work.size()); } ///< number of motions
};

// What rigid motions say about a scene before anything is solved. Linear programs over the cone B R a <= 0; that no
// motion at all goes on for ever takes one. A motion that is returned has a largest entry of 1.
//
// B R has full rank: bodies that move together without changing an interface are refused before (checkHeld). Work below
// 1e-7 of what the same loads could do, or 1e-9 of the largest loads, counts as none.

/// A motion along which the loads work and nothing stops it: there is no solution. Maximises w . a with |a_j| <= 1, so
/// that everything that is pulled off moves, and nothing else does. Empty when the loads pull nothing off.
Vector pulledOff(const RigidNetwork& network);

/// A motion without work that nothing stops: solutions differ by it, strains, contact forces and the bound of the error
/// do not. It parts every node that any such motion parts. Empty when there is none, and when loads pull bodies off.
/// Limits: bodies that are loose only because gaps are open or contact opens under the load show in the solution only.
Vector loose(const RigidNetwork& network);

} // namespace ndframe
