#pragma once

#include <cstdint>
#include <functional>

#include "stress_blocks.hpp"

namespace ndframe
{

/// The tractions that unknowns (StressBlocks) stand for, and the transposed map.
class StressUnknowns
{
public:
  /// All must outlive it.
  StressUnknowns(const StressFaces& faces, const std::vector<StressEdge>& edges, const StressBlocks& blocks);

  /// T per face that an own cell has, on its first cell; zero on the others. Number: float or double.
  template <class Number>
  void tractions(const std::vector<Number>& unknowns, int threads, std::vector<Number>& tractions) const;
  /// The same of one face.
  template <class Number, class Result>
  void tractionsOf(int face, const std::vector<Number>& unknowns, Result* T) const;
  /// What is known by the tractions of a face: forces on them, facet data of them. Any thread may ask.
  using FaceForces = std::function<void(int face, double* forces)>;
  /// By the unknowns, from that by the tractions of the faces that an own cell has. ofCarriers: room for six numbers a
  /// face. Gradient: float (rounded once) or double.
  template <class Number>
  void gradient(const FaceForces& ofFace, int threads, Vector& ofCarriers, std::vector<Number>& gradient) const;

private:
  /// Where a face or an edge is, and its size: wrenches are about the point, moments over the size.
  struct Frame
  {
    double point[3], size;
  };
  /// A step of an edge's ring through a face.
  struct Place
  {
    int other;         ///< the edge of a face, the face of an edge
    std::int16_t step; ///< in the ring; -1 where wrenches go through as they are
    std::int16_t sign; ///< there, of the traction on the face's first cell
  };

  void listPlaces();
  template <class Number, class Result>
  std::array<Result, 6> amounts(int face, const std::vector<Number>& unknowns) const;
  template <class Number>
  void ofEdge(int edge, const Vector& ofCarriers, Number* result) const;
  FaceFrame split(int face, double /*one*/) const { return faces_[face].frame(); }
  const FaceFrameOf<float>& split(int face, float /*one*/) const { return splits_[std::size_t(face)]; }

  const StressFaces& faces_;
  const std::vector<StressEdge>& edges_;
  const StressBlocks& blocks_;
  std::vector<Frame> faceFrames_, edgeFrames_;
  std::vector<FaceFrameOf<float>> splits_;     ///< per face; of use inside
  std::vector<char> isInside_;                 ///< per face: and an own cell has it
  std::vector<int> firstOfFace_, firstOfEdge_; ///< and the end
  std::vector<Place> ofFaces_, ofEdges_;
};

} // namespace ndframe
