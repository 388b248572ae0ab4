#include "stress_unknowns.hpp"

#include "ndframe/algebra/threads.hpp"

namespace ndframe
{

StressUnknowns::StressUnknowns(const StressFaces& faces, const std::vector<StressEdge>& edges,
                               const StressBlocks& blocks)
    : faces_(faces), edges_(edges), blocks_(blocks), rings_(faces.size(), edges)
{}

Vector StressUnknowns::tractions(const Vector& unknowns, int threads) const
{
  const auto size = std::size_t(faces_.cells().facetData());
  Vector tractions(std::size_t(faces_.size()) * size, 0.0);
  runInRanges(faces_.size(), threads, [&](int first, int last) {
    for (int f = first; f < last; ++f)
      addTractions(f, unknowns, tractions.data() + std::size_t(f) * size);
  });
  return tractions;
}

void StressUnknowns::addTractions(int f, const Vector& unknowns, double* T) const
{
  const StressFace& face = faces_[f];
  Wrench amounts{}; // of the carriers
  for (const FaceRings::Place* place = rings_.begin(f); place != rings_.end(f); ++place) {
    const StressEdge& edge = edges_[std::size_t(place->edge)];
    addThrough(edge, edge.ring[std::size_t(place->step)], face,
               unknowns.data() + blocks_.ofEdge(std::size_t(place->edge)), amounts.data());
  }
  const auto add = [T](const DenseMatrix& columns, const double* factors) {
    for (int k = 0; k < columns.cols(); ++k)
      for (int i = 0; i < columns.rows(); ++i)
        T[i] += columns(i, k) * factors[k];
  };
  const double* y = unknowns.data() + blocks_.ofFace(f);
  add(face.own, y);
  add(face.carrier, amounts.data());
  for (int k = 0; k < face.higher; ++k)
    T[face.own.rows() + k] += y[face.own.cols() + k];
}

Vector StressUnknowns::gradient(const Vector& faceForces, int threads) const
{
  const auto size = std::size_t(faces_.cells().facetData());
  Vector gradient(std::size_t(blocks_.size()), 0.0);
  std::vector<Wrench> ofCarriers(std::size_t(faces_.size()), Wrench{});
  const auto ofFace = [&](int f) {
    const StressFace& face = faces_[f];
    const double* G = faceForces.data() + std::size_t(f) * size;
    const auto add = [G](const DenseMatrix& columns, double* sums) {
      for (int k = 0; k < columns.cols(); ++k)
        for (int i = 0; i < columns.rows(); ++i)
          sums[k] += columns(i, k) * G[i];
    };
    double* y = gradient.data() + blocks_.ofFace(f);
    add(face.own, y);
    add(face.carrier, ofCarriers[std::size_t(f)].data());
    for (int k = 0; k < face.higher; ++k)
      y[face.own.cols() + k] += G[face.own.rows() + k];
  };
  const auto ofEdge = [&](std::size_t e) {
    for (const StressEdge::Step& step : edges_[e].ring)
      addBack(edges_[e], step, faces_[step.face], ofCarriers[std::size_t(step.face)].data(),
              gradient.data() + blocks_.ofEdge(e));
  };
  const auto each = [&](int count, const auto& task) {
    runInRanges(count, threads, [&task](int first, int last) {
      for (int i = first; i < last; ++i)
        task(std::size_t(i));
    });
  };
  each(faces_.size(), [&](std::size_t f) { ofFace(int(f)); });
  each(int(edges_.size()), ofEdge);
  return gradient;
}

} // namespace ndframe
