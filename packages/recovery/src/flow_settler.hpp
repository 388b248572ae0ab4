#pragma once

#include "ndframe/equilibrium/star_data.hpp"
#include "ndframe/flow/block_flow.hpp"
#include "stress_faces.hpp"

namespace ndframe
{

/// Brings cells into balance that their stars have left without, because u~ is not in finite element equilibrium:
/// supports take what a part of the body lacks in all, by the smallest reactions, and a BlockFlow the rest.
class FlowSettler
{
public:
  /// body: its number in faces.cells(); piece: what this rank holds of it, null where that is all of it. Collective.
  FlowSettler(int body, const StressFaces& faces, const BodyPiece* piece, const Comm& comm);

  /// Afterwards correction.imbalance is what cells then lack. The result does not depend on how cells are shared.
  /// Collective.
  void settle(StressCorrection& correction, const Comm& comm) const;

private:
  struct Support
  {
    int cell, facet;
    DenseMatrix map; ///< wrenches of the face's carriers about about_, moments over size_
  };

  bool isOwn(int cell) const { return piece_ == nullptr || piece_->owns(cell); }
  const StressFace& face(int cell, int facet) const
  {
    return faces_[faces_.within(faces_.cells().number(body_, cell), facet)];
  }
  const Direction& centre(int cell) const { return flow_.centre(cell); }
  Wrench lack(int cell, const StressCorrection& correction) const;
  std::vector<Wrench> lacks(const StressCorrection& correction) const;
  void give(const Support& support, const Vector& motion, std::vector<Wrench>& lacks,
            StressCorrection& correction) const;
  void react(std::vector<Wrench>& lacks, StressCorrection& correction, const Comm& comm) const;
  double* tractions(int cell, int facet, StressCorrection& correction) const;
  void pass(std::vector<Wrench> lacks, StressCorrection& correction, const Comm& comm) const;
  double largestOf(const std::vector<Wrench>& lacks, const Comm& comm) const;

  int body_;
  const StressFaces& faces_;
  const BodyPiece* piece_;
  const Mesh& mesh_; ///< what this rank holds
  BlockFlow flow_;
  Direction about_;
  double size_;                     ///< of the body: moments of parts are divided by it
  std::vector<Direction> loadArms_; ///< per cell and load mode: mean of (x - centre) m_k
};

/// Ranks agree on how far a body's stars were out of balance (StressCorrection::imbalance, force), and where that is
/// more than round-off a FlowSettler makes up for it. Collective.
void settleByFlows(int body, const StressFaces& faces, const BodyPiece* piece, const BodyCorrections& corrections,
                   const Comm& comm);

} // namespace ndframe
