#pragma once

#include "ndframe/algebra/dense.hpp"
#include "ndframe/equilibrium/moment_basis.hpp"

namespace ndframe
{

/// Force and moment about a star's vertex a, the moment divided by the star's size h: a force everywhere.
/// dim 2: (Fx, Fy, M / h); dim 3: (Fx, Fy, Fz, Mx / h, My / h, Mz / h).
constexpr int wrenchSize(int dim)
{
  return dim == 2 ? 3 : 6;
}

/// The wrench of moments (of a traction or a load) as a matrix: wrench = map T, T = mode by mode, component by
/// component:
///   F = T_0,   M = sum_k arm_k x T_k,   arm_k = mean of (x - a) L_k.   arms: dim per mode.
DenseMatrix wrenchMap(int dim, const Vector& arms, int modes, double size);

/// wrench += sign wrenchMap T, for the modes that the arms are of.
void addWrench(int dim, const Vector& arms, const double* T, double sign, double size, Vector& wrench);

/// A wrench about another point: M' = M + (from - to) x F.
Vector wrenchAbout(int dim, Vector wrench, const Vector& from, const Vector& to, double size);

/// The traction on a facet with vertex a, split into the part that carries its wrench and what is in balance by itself:
///
///   T = carrier w + modes y,   map T = w,   map carrier = 1,   map modes = 0.
///
/// The carrier uses constant and linear tractions only; all higher polynomials are in balance by themselves.
struct FacetSplit
{
  DenseMatrix map;     ///< wrench x facet data
  DenseMatrix carrier; ///< facet data x wrench
  DenseMatrix modes;   ///< facet data x (facet data - wrench)
};

/// Means of barycentric coordinates times basis functions: (dim + 1) per function, the same for every simplex.
Vector meanCoordinates(const MomentBasis& basis);

/// Points of a cell's vertices, without the one opposite to a facet (facet < 0: all).
std::vector<const double*> corners(const Mesh& mesh, const SortedCell& cell, int facet);

/// Arms of a basis on the simplex with these vertices (dim components each) about a.
Vector momentArms(const Vector& means, const std::vector<const double*>& vertices, const double* a, int dim);

/// The split for a facet with these momentArms(). modes: basis functions a component; size: length that makes moments
/// forces.
FacetSplit splitFacet(int dim, const Vector& arms, int modes, double size);

} // namespace ndframe
