#pragma once

#include <array>
#include <vector>

#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// Cells that follow each other.
struct CellRange
{
  int first = 0, last = 0; ///< last is not among them
  int size() const { return last - first; }
};

/// Mean stress of every cell, sigma_h = K eps(u_h), as (xx, yy, zz, xy, yz, xz).
/// displacement: numNodes * dim, global axes. For order 2 the mean equals the value at the centroid.
std::vector<std::array<double, 6>> cellStress(const BodyModel& body, const Vector& displacement);

/// int_E K eps(v) : eps(v) of every cell. displacement: v, numNodes * dim, global axes.
CellValues cellEnergies(const BodyModel& body, const Vector& displacement);
/// The same, of some cells that follow each other.
Vector cellEnergies(const BodyModel& body, const Vector& displacement, CellRange cells);

/// a(v, v) = int K eps(v) : eps(v) (no 1/2) of the body. Taken from the strains: in v . K v round-off of a large rigid
/// motion would drown the energy of a stiff body.
double energy(const BodyModel& body, const Vector& displacement);
/// The same of a body that may be shared out: of the cells of all ranks. Collective for shares.
double energy(const BodyModel& body, const Vector& displacement, const Comm& comm);

/// The cells of a body that this rank counts where ranks add up: its own ones, or all where it has all.
CellRange countedCells(const BodyModel& body);
/// Zeros elsewhere.
CellValues ofCountedCells(const BodyModel& body, CellValues values);

} // namespace ndframe
