#include "ndframe/mesh/nearest_point.hpp"

#include <nanoflann.hpp>

namespace ndframe
{
namespace
{

/// Points as nanoflann wants them.
struct Cloud
{
  std::size_t dim;
  std::vector<double> points;

  std::size_t kdtree_get_point_count() const { return points.size() / dim; }
  double kdtree_get_pt(std::size_t i, std::size_t k) const { return points[i * dim + k]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

} // namespace

struct NearestPoint::Tree
{
  Cloud cloud;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, -1, std::size_t> index;

  Tree(int dim, std::vector<double> points)
      : cloud{std::size_t(dim), std::move(points)}, index(dim, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10))
  {}
};

NearestPoint::NearestPoint(int dim, std::vector<double> points)
    : tree_(std::make_shared<const Tree>(dim, std::move(points)))
{}

NearestPoint::Place NearestPoint::find(const double* point) const
{
  Place place;
  tree_->index.knnSearch(point, 1, &place.index, &place.squaredDistance);
  return place;
}

} // namespace ndframe
