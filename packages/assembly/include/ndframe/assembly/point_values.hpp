#pragma once

#include <array>
#include <vector>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/mesh/cells_of_points.hpp"

namespace ndframe
{

/// A solution of a body at a point; zeros beyond dim.
struct PointValues
{
  std::array<double, 3> displacement{}; ///< u_h, a length, global axes
  std::array<double, 6> stress{};       ///< sigma_h as (xx, yy, zz, xy, yz, xz)
};

/// u_h and sigma_h = K eps(u_h) at a point. Where several cells hold it (cellsOfPoints), sigma_h has a value in each:
/// their mean, weighted by the cells' measures, as nodalStress has it at the nodes.
/// displacement: numNodes * dim, global axes; strained: the same up to a rigid motion, for the stress.
PointValues valuesAt(const BodyModel& body, const Vector& displacement, const Vector& strained,
                     const std::vector<PointInCell>& places);

/// The same at several points, on every rank. A body that ranks share is looked at by all of them: a point in cells of
/// several ranks gets the mean over all these, one in none the value of the cell that it is least outside of, of the
/// first rank that has one; as far as cellsOfPoints with this tolerance finds any. Collective.
std::vector<PointValues> valuesAtPoints(const BodyModel& body, const Vector& displacement, const Vector& strained,
                                        const std::vector<std::vector<double>>& points, double tolerance,
                                        const Comm& comm);

/// Integrals over a side; zeros beyond dim.
struct SideIntegrals
{
  double measure = 0.0;                 ///< length or area
  std::array<double, 3> centre{};       ///< centroid
  std::array<double, 3> displacement{}; ///< mean of u_h
  std::array<double, 3> force{};        ///< int sigma_h n dS, n the outward normal: what acts on the body
  std::array<double, 3> moment{};       ///< int (x - centre) x sigma_h n dS; in the plane about z, the last one

  /// The moment about another point.
  std::array<double, 3> momentAbout(const std::array<double, 3>& point) const;
};

/// sigma_h is that of the cells at the side, integrated exactly. It converges with the mesh and is not in balance with
/// the loads: reactions of supports and contact forces (body and interface summaries) are. Of a body that ranks share
/// each adds its own cells' facets. Collective.
SideIntegrals integrateSide(const BodyModel& body, const Side& side, const Vector& displacement, const Vector& strained,
                            const Comm& comm = Comm::single());

} // namespace ndframe
