#pragma once

// Included only by the kernels' translation units, each compiled for one instruction set. Nothing here (and nothing
// that these units include) may have external linkage or come from the standard library: the linker would be free to
// take a copy made for a machine that the program does not run on.

namespace ndframe
{
namespace
{

/// One number of NDFRAME_LANES stars or cells: arithmetic works lane by lane.
typedef double Lanes __attribute__((vector_size(8 * NDFRAME_LANES), may_alias));

/// Arrays of lanes are handed over as arrays of double: value [i] of lane l stands at i * NDFRAME_LANES + l.
inline Lanes* lanes(double* values)
{
  return reinterpret_cast<Lanes*>(values);
}

inline const Lanes* lanes(const double* values)
{
  return reinterpret_cast<const Lanes*>(values);
}

inline Lanes absolute(Lanes a)
{
  return a < 0.0 ? -a : a;
}

struct Vector2
{
  Lanes x, y;
};

inline Vector2 operator+(Vector2 a, Vector2 b)
{
  return {a.x + b.x, a.y + b.y};
}

inline Vector2 operator-(Vector2 a, Vector2 b)
{
  return {a.x - b.x, a.y - b.y};
}

template <class Factor>
inline Vector2 operator*(Factor factor, Vector2 a)
{
  return {factor * a.x, factor * a.y};
}

inline Lanes dot(Vector2 a, Vector2 b)
{
  return a.x * b.x + a.y * b.y;
}

/// a x b.
inline Lanes cross(Vector2 a, Vector2 b)
{
  return a.x * b.y - a.y * b.x;
}

/// Turned by 90 degrees: cross(a, turned(a)) = |a|^2.
inline Vector2 turned(Vector2 a)
{
  return {-a.y, a.x};
}

inline Vector2 load2(const Lanes* values)
{
  return {values[0], values[1]};
}

inline void store2(Lanes* values, Vector2 a)
{
  values[0] = a.x;
  values[1] = a.y;
}

/// A symmetric stress (xx, yy, xy) times a vector.
inline Vector2 traction(const Lanes* stress, Vector2 n)
{
  return {stress[0] * n.x + stress[2] * n.y, stress[2] * n.x + stress[1] * n.y};
}

// Stresses and strains (xx, yy, xy). Written out, since compilers keep the sums in registers only then, unless told to
// optimise at any price.

/// sum += x (entries).
template <class Entry, class Factor>
void add3(const Entry* entries, Factor x, Lanes* sum)
{
  sum[0] += entries[0] * x;
  sum[1] += entries[1] * x;
  sum[2] += entries[2] * x;
}

inline void copy3(const Lanes* from, Lanes* to)
{
  to[0] = from[0];
  to[1] = from[1];
  to[2] = from[2];
}

/// y = matrix x; matrix: upper triangle of a symmetric 3 x 3 matrix, row by row.
template <class Entry>
void multiply3(const Entry* matrix, const Lanes* x, Lanes* y)
{
  y[0] = matrix[0] * x[0] + matrix[1] * x[1] + matrix[2] * x[2];
  y[1] = matrix[1] * x[0] + matrix[3] * x[1] + matrix[4] * x[2];
  y[2] = matrix[2] * x[0] + matrix[4] * x[1] + matrix[5] * x[2];
}

} // namespace
} // namespace ndframe
