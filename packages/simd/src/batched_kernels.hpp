#pragma once

namespace ndframe
{

/// How the loads of a star's cells enter: the modes of G that a kernel sees. Reference axes of a cell seen from its
/// star: origin at the star's vertex, X_1 along the first spoke (counterclockwise), X_2 along the second.
struct LoadModes
{
  int modes;              ///< load modes (then, for sweeps, modes of the traction on the rim)
  const double* coupling; ///< per row of StarTables::form, per mode, per component: 6 coefficients of the compliance
  const double* force;    ///< per mode: its resultant
  const double* arms;     ///< per mode: its mean moment arm along X_1, X_2
  const double* bend;     ///< per mode and component: what it adds to the moment mode of the second spoke
  const double* share;    ///< per mode: the star's share of the constant 1
};

/// The reference tables as a star's kernels want them, degree q.
///
/// A cell's unknowns are  w: wrench about the star's vertex that goes through it (force 2, moment); s_1, s_2: per spoke
/// the self-equilibrated modes  t L_1, then t L_k, n L_k for k = 2..q  (t along the spoke, n = t turned by 90 degrees;
/// factors are forces over lengths), 2 q - 1 of them.
struct StarTables
{
  const double*
      form;   ///< upper triangle, row by row, over (bubbles, w, s_1, s_2): 6 coefficients of the compliance each
  double arm; ///< int s L_1 over a spoke's length, s from 0 at the vertex to 1
  double shareHere[4],
      shareThere[4];    ///< per mode: share of a traction that is 1 at the vertex, at the spoke's other end
  double compliance[6]; ///< of the material: upper triangle, row by row
  LoadModes constant, full, withRim; ///< no body force; body force; sweeps
};

/// Stars of equal valence, one per lane; arrays as in lanes.hpp. `cells` = valence; a fan has one more spoke than
/// cells, a closed star's last spoke is its first.
struct StarBatch
{
  int cells = 0, fields = 0;
  bool closed = false;
  const LoadModes* loads = nullptr;
  // Given.
  double* spokes = nullptr; ///< (cells + 1) x 2: from the vertex to the other end
  double* stress =
      nullptr; ///< initial pass: fields x cells x 9: sigma~ at the vertex and at the ends of the two spokes
  double* bodyLoad = nullptr;   ///< initial pass with body force: cells x modes x 2, shares
  double* total = nullptr;      ///< sweeps: fields x cells x (2 spokes, loads, rim): current moments
  double* compliance = nullptr; ///< bodies of several materials: cells x 6, instead of that of StarTables
  // Between the kernels.
  double* known = nullptr; ///< fields x cells x (w, s_1, s_2, loads): data of the cells without the unknowns
  double* jumps = nullptr; ///< fields x (cells + 1) x 2 (q + 1): share of the jump on each spoke (fans' ends: traction)
  double* offsets = nullptr;  ///< fields x (cells + 1) x 3: wrench through each spoke without the unknown one
  double* panels = nullptr;   ///< cells x panelSize: the eliminated spokes
  double* scratch = nullptr;  ///< fields x N
  double* border = nullptr;   ///< N x N: what is left over (w, s_0, s_last), N = 4 q + 1
  double* gradient = nullptr; ///< fields x N
  double* solution = nullptr; ///< fields x N
  // Results.
  double* tractions = nullptr;  ///< fields x (cells + 1) x 2 sides (cell before, cell after) x 2 (q + 1)
  double* divergence = nullptr; ///< fields x cells x 2: int div sigma~
  double* scale = nullptr;      ///< fields: the forces in the star
};

/// Cells, one per lane.
struct CellBatch
{
  double* edges = nullptr;        ///< 2 x 2: from the first vertex to the others
  double* displacement = nullptr; ///< 6 x 2: v at the vertices and at the middles of the edges opposite to them
  double* stress = nullptr;       ///< 3 x 3: at the vertices
  double* data = nullptr;         ///< tractions and loads of a correction; vertices in sorted order
  int firstData = 0;              ///< the values of `data` before this one, an even number, are zero
  double* law = nullptr;          ///< bodies of several materials: a PlaneLaw each, instead of that of CellTables
  double* distance = nullptr;     ///< 1
};

/// A material as the cells' kernels want it.
struct PlaneLaw
{
  double compliance[6], stiffness[6]; ///< upper triangles, row by row
  double root[6];                     ///< sigma : compliance sigma = |root sigma|^2: lower triangle, row by row
};

/// The reference tables as the cells' kernels want them.
struct CellTables
{
  const double* lift;       ///< per coefficient (of one stress component), per datum: 3 components
  const double* bubble;     ///< per coefficient, per bubble: 3 components
  const double* bubbleForm; ///< upper triangle over bubbles: 6 coefficients of the compliance each
  const double* linear;     ///< per sub-cell, 3 coefficients, per vertex: of the linear function that is 1 there
  PlaneLaw law;             ///< of the material
};

// Internal linkage: see lanes.hpp.

/// Self-equilibrated modes of a spoke.
static constexpr int spokeModes(int q)
{
  return 2 * q - 1;
}

/// A cell's unknowns w, s_1, s_2; also those of the border, w, s_0, s_last.
static constexpr int cellUnknowns(int q)
{
  return 3 + 2 * spokeModes(q);
}

static constexpr int cellBubbles(int q)
{
  return q == 1 ? 0 : 6 * q - 9;
}

static constexpr int loadModesOf(int q)
{
  return q == 3 ? 6 : 3;
}

/// Lanes of one eliminated spoke: rows over (itself, border without s_last, next spoke), reciprocal pivots, gradients.
static constexpr int panelSize(int q, int fields)
{
  return spokeModes(q) * (spokeModes(q) + cellUnknowns(q) + 1 + fields);
}

/// The kernels for one degree.
struct DegreeKernels
{
  void (*prepare)(const StarTables&, const StarBatch&);    ///< initial pass: known, jumps, offsets, divergence, scale
  void (*takeTotals)(const StarTables&, const StarBatch&); ///< sweeps: known
  void (*condense)(const StarTables&, const StarBatch&);   ///< border, gradient, panels
  void (*close)(const StarBatch&);                         ///< closed stars: solution
  void (*expand)(const StarTables&, const StarBatch&);     ///< tractions
  void (*distance)(const CellTables&, const CellBatch&);   ///< distance; without displacement that of v = 0
};

/// All kernels compiled for one instruction set.
struct BatchedKernels
{
  const char* name;
  int lanes;
  /// Stress of a displacement of order 2 with the batch's laws, or with this one.
  void (*vertexStress)(const PlaneLaw& law, const CellBatch&);
  DegreeKernels degree[3]; ///< q = 1, 2, 3
};

} // namespace ndframe
