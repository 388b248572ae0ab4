#include "stress_unknowns.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/algebra/threads.hpp"

namespace ndframe
{
namespace
{

/// T += columns factors
template <class Number>
void addColumns(const DenseMatrix& columns, const Number* factors, Number* T)
{
  for (int k = 0; k < columns.cols(); ++k)
    for (int i = 0; i < columns.rows(); ++i)
      T[i] += Number(columns(i, k) * double(factors[k]));
}

/// sums = columns^T G
void multiplyColumns(const DenseMatrix& columns, const double* G, double* sums)
{
  for (int k = 0; k < columns.cols(); ++k) {
    sums[k] = 0.0;
    for (int i = 0; i < columns.rows(); ++i)
      sums[k] += columns(i, k) * G[i];
  }
}

} // namespace

StressUnknowns::StressUnknowns(const StressFaces& faces, const std::vector<StressEdge>& edges,
                               const StressBlocks& blocks)
    : faces_(faces), edges_(edges), blocks_(blocks)
{
  const auto frame = [](const Direction& point, double size) { return Frame{{point[0], point[1], point[2]}, size}; };
  faceFrames_.reserve(std::size_t(faces.size()));
  splits_.reserve(std::size_t(faces.size()));
  for (int f = 0; f < faces.size(); ++f) {
    const StressFace& face = faces[f];
    faceFrames_.push_back(frame(face.centre, face.size));
    splits_.emplace_back(face.arms, face.size);
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
  std::size_t steps = 0;
  for (const StressEdge& edge : edges_)
    steps += edge.ring.size();
  ofEdges_.reserve(steps);
  for (const StressEdge& edge : edges_) {
    for (std::size_t s = 0; s < edge.ring.size(); ++s) {
      const StressEdge::Step& step = edge.ring[s];
      ofEdges_.push_back({step.face, std::int16_t(step.through != nullptr ? int(s) : -1), std::int16_t(step.sign)});
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

template <class Number>
void StressUnknowns::tractions(const std::vector<Number>& unknowns, int threads, std::vector<Number>& tractions) const
{
  const auto size = std::size_t(faces_.cells().facetData());
  tractions.resize(std::size_t(faces_.size()) * size);
  runInRanges(faces_.size(), threads, [&](int first, int last) {
    for (int f = first; f < last; ++f)
      tractionsOf(f, unknowns, tractions.data() + std::size_t(f) * size);
  });
}

template <class Number, class Result>
void StressUnknowns::tractionsOf(int f, const std::vector<Number>& unknowns, Result* T) const
{
  const auto size = std::size_t(faces_.cells().facetData());
  Result y[18]; // facet data at most
  const Number* own = unknowns.data() + blocks_.ofFace(f);
  std::copy_n(own, blocks_.ofFace(f + 1) - blocks_.ofFace(f), y);
  if (isInside_[std::size_t(f)] != 0) {
    split(f, Result()).tractions(y, amounts<Number, Result>(f, unknowns).data(), T);
    std::copy_n(y + StressFace::ownLinear, size - StressFace::linear, T + StressFace::linear);
    return;
  }
  std::fill_n(T, size, Result());
  if (!faces_.isNear(f))
    return;
  addColumns(faces_[f].free->own, y, T);
  addColumns(faces_[f].free->carrier, amounts<Number, Result>(f, unknowns).data(), T);
}

/// Of a face's carriers, by all edges.
template <class Number, class Result>
std::array<Result, 6> StressUnknowns::amounts(int f, const std::vector<Number>& unknowns) const
{
  const Frame& face = faceFrames_[std::size_t(f)];
  double sum[6] = {};
  for (int at = firstOfFace_[std::size_t(f)]; at < firstOfFace_[std::size_t(f) + 1]; ++at) {
    const Place& place = ofFaces_[std::size_t(at)];
    const Number* z = unknowns.data() + blocks_.ofEdge(std::size_t(place.other));
    if (place.step >= 0) {
      const DenseMatrix& through = *edges_[std::size_t(place.other)].ring[std::size_t(place.step)].through;
      for (int k = 0; k < through.cols(); ++k)
        for (int i = 0; i < through.rows(); ++i)
          sum[i] += through(i, k) * double(z[k]);
      continue;
    }
    const Frame& edge = edgeFrames_[std::size_t(place.other)];
    const double sign = place.sign, scale = sign / face.size,
                 arm[3] = {edge.point[0] - face.point[0], edge.point[1] - face.point[1], edge.point[2] - face.point[2]};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      sum[i] += sign * double(z[i]);
      sum[3 + i] += scale * (edge.size * double(z[3 + i]) + arm[j] * double(z[k]) - arm[k] * double(z[j]));
    }
  }
  return {Result(sum[0]), Result(sum[1]), Result(sum[2]), Result(sum[3]), Result(sum[4]), Result(sum[5])};
}

/// What forces on the carriers of an edge's ring are for its wrench.
template <class Number>
void StressUnknowns::ofEdge(int e, const Vector& ofCarriers, Number* result) const
{
  const Frame& edge = edgeFrames_[std::size_t(e)];
  double sum[6] = {};
  for (int at = firstOfEdge_[std::size_t(e)]; at < firstOfEdge_[std::size_t(e) + 1]; ++at) {
    const Place& place = ofEdges_[std::size_t(at)];
    const double* forces = ofCarriers.data() + std::ptrdiff_t(place.other) * 6;
    if (place.step >= 0) {
      const DenseMatrix& through = *edges_[std::size_t(e)].ring[std::size_t(place.step)].through;
      for (int k = 0; k < through.cols(); ++k)
        for (int i = 0; i < through.rows(); ++i)
          sum[k] += through(i, k) * forces[i];
      continue;
    }
    const Frame& face = faceFrames_[std::size_t(place.other)];
    const double *M = forces + 3, sign = place.sign, scale = sign / face.size,
                 arm[3] = {edge.point[0] - face.point[0], edge.point[1] - face.point[1], edge.point[2] - face.point[2]};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      sum[i] += sign * forces[i] + scale * (M[j] * arm[k] - M[k] * arm[j]);
      sum[3 + i] += scale * edge.size * M[i];
    }
  }
  const int unknowns = blocks_.ofEdge(std::size_t(e) + 1) - blocks_.ofEdge(std::size_t(e));
  for (int k = 0; k < unknowns; ++k)
    result[k] = Number(sum[k]);
}

template <class Number>
void StressUnknowns::gradient(const FaceForces& ofFace, int threads, Vector& ofCarriers,
                              std::vector<Number>& gradient) const
{
  const auto size = std::size_t(faces_.cells().facetData());
  gradient.resize(std::size_t(blocks_.size()));
  ofCarriers.resize(std::size_t(faces_.size()) * 6);
  runInRanges(faces_.size(), threads, [&](int first, int last) {
    for (int f = first; f < last; ++f) {
      double G[18] = {}, y[18] = {}, *carried = ofCarriers.data() + std::size_t(f) * 6; // facet data at most
      std::fill_n(carried, 6, 0.0);
      if (!faces_.isNear(f))
        continue;
      ofFace(f, G);
      if (isInside_[std::size_t(f)] != 0) {
        FaceFrame(splits_[std::size_t(f)]).forces(G, y, carried);
        std::copy_n(G + StressFace::linear, size - StressFace::linear, y + StressFace::ownLinear);
      } else {
        multiplyColumns(faces_[f].free->own, G, y);
        multiplyColumns(faces_[f].free->carrier, G, carried);
      }
      const int begin = blocks_.ofFace(f), end = blocks_.ofFace(f + 1);
      std::transform(y, y + (end - begin), gradient.data() + begin, [](double value) { return Number(value); });
    }
  });
  runInRanges(int(edges_.size()), threads, [&](int first, int last) {
    for (int e = first; e < last; ++e)
      ofEdge(e, ofCarriers, gradient.data() + blocks_.ofEdge(std::size_t(e)));
  });
}

template void StressUnknowns::tractions(const Vector&, int, Vector&) const;
template void StressUnknowns::tractions(const std::vector<float>&, int, std::vector<float>&) const;
template void StressUnknowns::tractionsOf(int, const std::vector<float>&, double*) const;
template void StressUnknowns::tractionsOf(int, const Vector&, double*) const;
template void StressUnknowns::gradient(const FaceForces&, int, Vector&, Vector&) const;
template void StressUnknowns::gradient(const FaceForces&, int, Vector&, std::vector<float>&) const;

} // namespace ndframe
