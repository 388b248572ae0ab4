#pragma once

#include <functional>

#include "ndframe/algebra/comm.hpp"
#include "stress_faces.hpp"

namespace ndframe
{

/// A traction of a face, on its first cell.
struct FaceTraction
{
  int face;
  Vector T; ///< facet data
};

/// Tractions without wrench that move the given ones away from zero: where a Bernstein coefficient is smaller than a
/// part of the mean pressure on its patch, all become that large, or half of it, or ..; none where nothing suits, as
/// where bodies part.
std::vector<FaceTraction> interiorChange(const StressFaces& faces, const std::vector<ContactPatch>& contact,
                                         const ContactTraction& traction);

/// The moments of a traction's normal part: modes of T . n_c.
Vector normalMoments(const ContactPatch& patch, const double* T, std::size_t modes);

/// How far normal tractions may change before one of their Bernstein coefficients becomes positive.
class PressureRoom
{
public:
  /// traction: admissible, on the patches `contact`. All must outlive it. Collective.
  PressureRoom(const StressFaces& faces, const std::vector<ContactPatch>& contact, const ContactTraction& traction,
               const Comm& comm);

  /// Per patch: nonzero where the traction stays as it is.
  const std::vector<char>& held() const { return held_; }

  /// Moves along tractions (of a face, on its first cell) by `length` or as far as admissible; facets that allow less
  /// than half of `length` are held from then on. Returns how far; less than `length` where facets were held.
  /// Collective.
  double move(const std::function<void(int face, double* T)>& tractions, double length);

private:
  void agree();
  Vector coefficients(int face, const double* T) const;

  const StressFaces* faces_;
  const std::vector<ContactPatch>* contact_;
  Comm comm_;
  DenseMatrix toBernstein_;
  std::vector<int> inContact_; ///< faces that an own cell has
  std::vector<char> held_;
  std::vector<Vector> room_; ///< per entry of inContact_: minus the coefficients
};

} // namespace ndframe
