#pragma once

#include "stress_blocks.hpp"

namespace ndframe
{

/// The tractions that unknowns (StressBlocks) stand for, and the transposed map.
class StressUnknowns
{
public:
  /// All must outlive it.
  StressUnknowns(const StressFaces& faces, const std::vector<StressEdge>& edges, const StressBlocks& blocks);

  /// T per face that an own cell has, on its first cell; zero on the others.
  void tractions(const Vector& unknowns, int threads, Vector& tractions) const;
  /// By the unknowns, from that by the tractions of the faces that an own cell has.
  void gradient(const Vector& faceForces, int threads, Vector& gradient) const;

private:
  /// Where a face or an edge is, and its size: wrenches are about the point, moments over the size.
  struct Frame
  {
    double point[3], size;
  };
  /// A step of an edge's ring through a face.
  struct Place
  {
    int other;   ///< the edge of a face, the face of an edge
    int step;    ///< in the ring; -1 where wrenches go through as they are
    double sign; ///< there, of the traction on the face's first cell
  };

  void listPlaces();
  Wrench amounts(int face, const Vector& unknowns) const;
  void addTractions(int face, const Vector& unknowns, double* T) const;
  void addForces(int edge, double* sum) const;

  const StressFaces& faces_;
  const std::vector<StressEdge>& edges_;
  const StressBlocks& blocks_;
  std::vector<Frame> faceFrames_, edgeFrames_;
  std::vector<FaceFrame> splits_;              ///< per face; of use inside
  std::vector<char> isInside_;                 ///< per face: and an own cell has it
  std::vector<int> firstOfFace_, firstOfEdge_; ///< and the end
  std::vector<Place> ofFaces_, ofEdges_;
  mutable std::vector<Wrench> ofCarriers_; ///< per face: forces, while gradient() works
};

} // namespace ndframe
