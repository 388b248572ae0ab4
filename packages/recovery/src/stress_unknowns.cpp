#include "stress_unknowns.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/algebra/threads.hpp"

namespace ndframe
{
namespace
{

/// T += columns factors
void addColumns(const DenseMatrix& columns, const double* factors, double* T)
{
  const int rows = columns.rows();
  const double* column = columns.data();
  for (int k = 0; k < columns.cols(); ++k, column += rows)
    for (int i = 0; i < rows; ++i)
      T[i] += column[i] * factors[k];
}

/// sums = columns^T G
void multiplyColumns(const DenseMatrix& columns, const double* G, double* sums)
{
  const int rows = columns.rows();
  const double* column = columns.data();
  for (int k = 0; k < columns.cols(); ++k, column += rows) {
    sums[k] = 0.0;
    for (int i = 0; i < rows; ++i)
      sums[k] += column[i] * G[i];
  }
}

} // namespace

StressUnknowns::StressUnknowns(const StressFaces& faces, const std::vector<StressEdge>& edges,
                               const StressBlocks& blocks)
    : faces_(faces), edges_(edges), blocks_(blocks), ofCarriers_(std::size_t(faces.size()), Wrench{})
{
  const auto frame = [](const Direction& point, double size) { return Frame{{point[0], point[1], point[2]}, size}; };
  faceFrames_.reserve(std::size_t(faces.size()));
  splits_.reserve(std::size_t(faces.size()));
  for (int f = 0; f < faces.size(); ++f) {
    const StressFace& face = faces[f];
    faceFrames_.push_back(frame(face.centre, face.size));
    splits_.push_back(face.frame());
    isInside_.push_back(char(face.isInside() && faces.isNear(f)));
  }
  for (const StressEdge& edge : edges)
    edgeFrames_.push_back(frame(edge.middle, edge.length));
  listPlaces();
}

void StressUnknowns::listPlaces()
{
  firstOfFace_.assign(faceFrames_.size() + 1, 0);
  firstOfEdge_.push_back(0);
  for (const StressEdge& edge : edges_) {
    for (std::size_t s = 0; s < edge.ring.size(); ++s) {
      const StressEdge::Step& step = edge.ring[s];
      ofEdges_.push_back({step.face, step.through.rows() > 0 ? int(s) : -1, step.sign});
      ++firstOfFace_[std::size_t(step.face) + 1];
    }
    firstOfEdge_.push_back(int(ofEdges_.size()));
  }
  std::partial_sum(firstOfFace_.begin(), firstOfFace_.end(), firstOfFace_.begin());
  ofFaces_.resize(ofEdges_.size());
  std::vector<int> next(firstOfFace_.begin(), firstOfFace_.end() - 1);
  for (int e = 0; e + 1 < int(firstOfEdge_.size()); ++e)
    for (int at = firstOfEdge_[std::size_t(e)]; at < firstOfEdge_[std::size_t(e) + 1]; ++at) {
      const Place& place = ofEdges_[std::size_t(at)];
      ofFaces_[std::size_t(next[std::size_t(place.other)]++)] = {e, place.step, place.sign};
    }
}

void StressUnknowns::tractions(const Vector& unknowns, int threads, Vector& tractions) const
{
  const auto size = std::size_t(faces_.cells().facetData());
  tractions.resize(std::size_t(faces_.size()) * size);
  runInRanges(faces_.size(), threads, [&](int first, int last) {
    for (int f = first; f < last; ++f) {
      double* T = tractions.data() + std::size_t(f) * size;
      if (isInside_[std::size_t(f)] != 0) {
        const double* y = unknowns.data() + blocks_.ofFace(f);
        splits_[std::size_t(f)].tractions(y, amounts(f, unknowns).data(), T);
        std::copy_n(y + StressFace::ownLinear, size - StressFace::linear, T + StressFace::linear);
        continue;
      }
      std::fill_n(T, size, 0.0);
      addTractions(f, unknowns, T);
    }
  });
}

/// Of a face's carriers, by all edges.
Wrench StressUnknowns::amounts(int f, const Vector& unknowns) const
{
  const Frame& face = faceFrames_[std::size_t(f)];
  Wrench sum{};
  for (int at = firstOfFace_[std::size_t(f)]; at < firstOfFace_[std::size_t(f) + 1]; ++at) {
    const Place& place = ofFaces_[std::size_t(at)];
    const double* z = unknowns.data() + blocks_.ofEdge(std::size_t(place.other));
    if (place.step >= 0) {
      const StressEdge& edge = edges_[std::size_t(place.other)];
      addColumns(edge.ring[std::size_t(place.step)].through, z, sum.data());
      continue;
    }
    const Frame& edge = edgeFrames_[std::size_t(place.other)];
    const double scale = place.sign / face.size,
                 arm[3] = {edge.point[0] - face.point[0], edge.point[1] - face.point[1], edge.point[2] - face.point[2]};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      sum[i] += place.sign * z[i];
      sum[3 + i] += scale * (edge.size * z[3 + i] + arm[j] * z[k] - arm[k] * z[j]);
    }
  }
  return sum;
}

void StressUnknowns::addTractions(int f, const Vector& unknowns, double* T) const
{
  if (!faces_.isNear(f))
    return;
  const StressFace& face = faces_[f];
  const double* y = unknowns.data() + blocks_.ofFace(f);
  addColumns(face.free->own, y, T);
  addColumns(face.free->carrier, amounts(f, unknowns).data(), T);
}

/// What forces on the faces of an edge's ring are for its wrench.
void StressUnknowns::addForces(int e, double* sum) const
{
  const Frame& edge = edgeFrames_[std::size_t(e)];
  for (int at = firstOfEdge_[std::size_t(e)]; at < firstOfEdge_[std::size_t(e) + 1]; ++at) {
    const Place& place = ofEdges_[std::size_t(at)];
    const Wrench& forces = ofCarriers_[std::size_t(place.other)];
    if (place.step >= 0) {
      const DenseMatrix& through = edges_[std::size_t(e)].ring[std::size_t(place.step)].through;
      for (int k = 0; k < through.cols(); ++k)
        for (int i = 0; i < through.rows(); ++i)
          sum[k] += through(i, k) * forces[std::size_t(i)];
      continue;
    }
    const Frame& face = faceFrames_[std::size_t(place.other)];
    const double scale = place.sign / face.size, *M = forces.data() + 3,
                 arm[3] = {edge.point[0] - face.point[0], edge.point[1] - face.point[1], edge.point[2] - face.point[2]};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      sum[i] += place.sign * forces[i] + scale * (M[j] * arm[k] - M[k] * arm[j]);
      sum[3 + i] += scale * edge.size * M[i];
    }
  }
}

void StressUnknowns::gradient(const Vector& faceForces, int threads, Vector& gradient) const
{
  const auto size = std::size_t(faces_.cells().facetData());
  gradient.resize(std::size_t(blocks_.size()));
  runInRanges(faces_.size(), threads, [&](int first, int last) {
    for (int f = first; f < last; ++f) {
      if (!faces_.isNear(f))
        continue;
      const StressFace& face = faces_[f];
      const double* G = faceForces.data() + std::size_t(f) * size;
      double* y = gradient.data() + blocks_.ofFace(f);
      if (isInside_[std::size_t(f)] != 0) {
        splits_[std::size_t(f)].forces(G, y, ofCarriers_[std::size_t(f)].data());
        std::copy_n(G + StressFace::linear, size - StressFace::linear, y + StressFace::ownLinear);
        continue;
      }
      multiplyColumns(face.free->own, G, y);
      multiplyColumns(face.free->carrier, G, ofCarriers_[std::size_t(f)].data());
    }
  });
  runInRanges(int(edges_.size()), threads, [&](int first, int last) {
    for (int e = first; e < last; ++e) {
      double* sum = gradient.data() + blocks_.ofEdge(std::size_t(e));
      std::fill(sum, sum + (blocks_.ofEdge(std::size_t(e) + 1) - blocks_.ofEdge(std::size_t(e))), 0.0);
      addForces(e, sum);
    }
  });
}

} // namespace ndframe
