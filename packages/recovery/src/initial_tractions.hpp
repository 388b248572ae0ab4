#pragma once

#include "ndframe/equilibrium/stress_correction.hpp"
#include "stress_faces.hpp"

namespace ndframe
{

/// What a solid's correction begins with, before anything flows: half of sigma~'s jumps on both sides of a face, p -
/// sigma~ n on the boundary (contact included; nothing along supported directions), loads -(b + div sigma~); and the
/// parts of that which belong to the stars of vertices (StaticData). Inside tractions are linear, so that a star's part
/// follows from the whole.
class InitialTractions
{
public:
  /// Puts them into a correction without data. body: its number in faces.cells(). All must outlive this, and the
  /// correction keep its tractions while shares are asked for.
  InitialTractions(int body, const StressFaces& faces, const FieldInput& field, StressCorrection& correction,
                   int threads);

  /// The wrench of a star's part of the tractions at a cell's facet, which is `face`, about the star's vertex, moments
  /// over `size`. apex: number of the vertex among the facet's.
  Wrench wrenchOf(const StressFace& face, int cell, int facet, int apex, const double* vertex, double size) const;
  /// Adds that of a star's part of a cell's loads. apex: number of the vertex among the cell's.
  void addLoad(int cell, int apex, const double* vertex, double size, Wrench& sum) const;
  /// What sigma~ and loads of a cell amount to: a sum of absolute values.
  double force(int cell) const { return forces_[std::size_t(cell)]; }

private:
  static constexpr std::size_t modes = 3; ///< linear
  using Table = std::array<std::array<std::array<double, modes>, modes>, modes>;

  void findTables();
  void putStress(int cell);
  void putFace(const StressFace& face);
  void putPrescribed(const StressFace& face, int cell);
  void subtractBodyLoads();
  double* tractions(int cell, int facet) const
  {
    return correction_->tractions.data() + (std::ptrdiff_t(cell) * 4 + facet) * faces_->cells().facetData();
  }

  int number_;
  const StressFaces* faces_;
  const StarBody* body_;
  const FieldInput* field_;
  StressCorrection* correction_;
  Shares facetShares_, cellShares_;
  Table ofVertices_{}; ///< [vertex][mode][mode]: moments of a vertex's part by those of the whole
  std::array<std::array<double, modes>, modes> moments_{}; ///< [mode][vertex] of barycentric coordinates
  double arm_ = 0.0; ///< of a vertex's part of a constant load, in parts of the way from the vertex to the centre
  std::vector<Direction> divergence_; ///< per cell: -div sigma~ times the volume
  Vector forces_;                     ///< per cell
  std::vector<int> prescribedAt_;     ///< per cell and facet, in what follows; empty: nowhere
  Vector prescribed_; ///< linear tractions of three vertices' parts, where they do not follow from the whole
};

} // namespace ndframe
