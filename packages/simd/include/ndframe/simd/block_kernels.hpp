#pragma once

#include <array>

#include "ndframe/equilibrium/cell_forms.hpp"

/// What CellBlocks does with many cells side by side; all numbers per entry and lane, matrices column by column.
namespace ndframe::block_kernels
{

/// A = F^-T A^ F^-1, vector by vector, from the lower triangle of A^ (`size` x `size`); A has columns of 18 and both
/// triangles.
void turnSymmetric(const double* triangle, const double* inverse, int size, double* A);
/// The same of a matrix between linear tractions.
void turn(const double* given, const double* inverse, double* A);

/// Linear tractions T_1, T_2 by the moments (over `size`) that they carry, as splitFacet() has them: 6 x 3, row by row.
void findCarrier(const double* arms, const double* size, double* carrier);
/// own^T A own, 12 x 12 at most: (r_1, 0), (0, r_2), (r_2, r_1) of unit norm, then all that is not linear.
void findOwn(const double* A, const double* arms, int facetData, double* own);
/// left^T A right of forces and moments, 6 x 6; columns of A are `stride` apart.
void multiplyCarriers(const double* A, std::ptrdiff_t stride, const double* left, const double* right, double* product);

/// What a wrench around an edge does that enters a cell through one facet and leaves it through another. parts: between
/// the carriers of the first, of the second, and rows of the second with columns of the first; arms from centres to
/// the edge's middle and its length, both over the facets' sizes.
void findEdge(std::array<const double*, 3> parts, std::array<const double*, 2> arms,
              std::array<const double*, 2> lengths, double* block);

/// visit(row, column, place) for a triangle below the diagonal, column by column.
template <class Visit>
void eachBelow(std::size_t size, const Visit& visit)
{
  for (std::size_t j = 0, place = 0; j < size; ++j)
    for (std::size_t i = j; i < size; ++i, ++place)
      visit(i, j, place);
}

/// Inverses of `lanes` symmetric matrices in place (both triangles). Returns whether all pivots are above `least` times
/// the largest diagonal entry of their matrix.
bool invert(double* A, int size, double least);

/// y = factor A x for one block: A column by column in single precision, or its lower triangle in double precision.
void multiplyRounded(const void* A, const float* x, std::size_t size, float factor, float* y);
void multiplyTriangle(const void* triangle, const float* x, std::size_t size, double factor, float* y);

/// y = factor A x for a symmetric matrix in single precision of 36 or 72 rows, the tractions of a cell.
void multiplyCell(const float* A, const float* x, std::size_t size, float factor, float* y);

/// y = F^-1 x for `count` / 3 vectors, and in place forces = units F^-T forces; F^-1 and units per lane.
void pullBack(const float* inverse, const float* x, std::size_t count, float* y);
void push(const float* inverse, const float* units, std::size_t count, float* forces);

/// sum a_i b_i in double precision, in an order of its own.
double dotOf(const float* a, const float* b, std::size_t count);

} // namespace ndframe::block_kernels
