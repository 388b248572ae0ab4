#pragma once

#include <array>
#include <memory>
#include <vector>

#include "ndframe/admissibility/contact_traction.hpp"
#include "ndframe/equilibrium/star_wrench.hpp"
#include "ndframe/simd/face_frame.hpp"
#include "ndframe/simd/stress_cells.hpp"
#include "wrench.hpp"

namespace ndframe
{

/// The tractions of a face on the boundary or in contact that may be changed: T = own y + carrier r. `own` carries no
/// wrench; `carrier` carries the wrench  reach r  about the centre. On the boundary they are along supported
/// directions, between two bodies in contact along the normal.
struct FreeTractions
{
  DenseMatrix own;     ///< facet data x columns
  DenseMatrix carrier; ///< facet data x r
  DenseMatrix reach;   ///< 6 x r, independent columns
  DenseMatrix choose;  ///< r x 6: the pseudo-inverse of reach
};

/// A facet of the cells of solids.
struct StressFace
{
  static constexpr int linear = 9, ownLinear = 3; ///< data of linear tractions, and how many have no wrench

  std::array<int, 2> cell{-1, -1};  ///< the second is -1 on the boundary and at rigid bodies
  std::array<int, 2> facet{-1, -1}; ///< its sorted number in each cell; T acts on the first, -T on the second
  int contact = -1; ///< number of the patch: the cells belong to two bodies, or there is one that touches a rigid body
  std::array<int, 3> theirs{0, 1, 2}; ///< there: PatchSide::places of its second side
  DenseMatrix turned{};               ///< and its modesInOrder(); empty where the order is the same
  Direction centre{};
  double size = 0.0;               ///< square root of the area: moments are divided by it
  std::array<Direction, 2> arms{}; ///< means of (x - centre) L_1, (x - centre) L_2
  int higher = 0;                  ///< inside: data of T beyond the linear ones
  /// Null inside, where all tractions may change: those of frame(), and the last `higher` as they stand.
  std::shared_ptr<const FreeTractions> free;

  bool isInside() const { return cell[1] >= 0 && contact < 0; }
  bool isBoundary() const { return cell[1] < 0; }
  FaceFrame frame() const { return {arms, size}; }
  int numOwn() const { return free ? free->own.cols() : ownLinear + higher; }
  int numCarriers() const { return free ? free->carrier.cols() : wrenchSize(3); }
  /// T of the unknowns y, facet data x numOwn().
  DenseMatrix allOwn() const;
  /// T of the carriers, facet data x numCarriers().
  DenseMatrix carriers() const;
  /// T += carriers times amounts.
  void addCarried(const double* amounts, double* T) const;
  std::size_t sideOf(int number) const { return cell[0] == number ? 0 : 1; }
  /// The wrench of tractions T about a point, moments over `length`.
  Wrench wrench(const double* T, const double* point, double length) const;
  /// T (`count` data) as the cell of one side feels it.
  void toSide(std::size_t side, const double* T, int count, double* result) const;
  /// The transposed map: adds what forces on that cell's data are as forces on T.
  void fromSide(std::size_t side, const double* forces, int count, double* sum) const;
  /// Columns of tractions by toSide().
  DenseMatrix onSide(std::size_t side, const DenseMatrix& columns) const;
};

/// All faces of solids. A patch whose two sides coincide is one face that both bodies share; at a rigid body it
/// is a boundary face whose normal traction may change. Where cells are those that a rank holds, faces of ghosts that
/// have another cell elsewhere look like a boundary without loads; no edge of an own cell meets them.
class StressFaces
{
public:
  /// Whose traction a cell has at a facet, and with what sign; 0: by StressFace::toSide.
  struct Seat
  {
    int face;
    float sign;
  };

  /// contact: patches whose normal tractions may change, vertices ascending on their first sides; bodies by their
  /// numbers in `cells`.
  explicit StressFaces(const StressCells& cells, const std::vector<ContactPatch>& contact = {});

  const StressCells& cells() const { return *cells_; }
  const std::vector<StressFace>& all() const { return faces_; }
  int size() const { return int(faces_.size()); }
  const StressFace& operator[](int face) const { return faces_[std::size_t(face)]; }
  /// The face of a cell's sorted facet.
  int of(int cell, int facet) const
  {
    const int face = within(cell, facet);
    return joined_[std::size_t(face)] < 0 ? face : joined_[std::size_t(face)];
  }
  std::vector<Seat> seats() const; ///< per cell and sorted facet
  /// The same without contact: as its body alone has it.
  int within(int cell, int facet) const { return faceOf_[std::size_t(cell) * 4 + std::size_t(facet)]; }
  /// Whether an own cell has it: only then its tractions may be changed by this rank.
  bool isNear(int face) const
  {
    const auto& cell = faces_[std::size_t(face)].cell;
    return cells_->isOwn(cell[0]) || (cell[1] >= 0 && cells_->isOwn(cell[1]));
  }
  /// A face of one body with another in its place.
  bool isReplaced(int face) const { return joined_[std::size_t(face)] >= 0; }

private:
  void addFaces(int body, std::size_t more);
  void findGeometry(StressFace& face) const;
  void freeAlong(StressFace& face, const Direction* directions, int count);
  void freeReactions(StressFace& face);
  void joinContact(const std::vector<ContactPatch>& contact);
  bool coincide(const StressFace& face, const Direction& normal) const;

  const StressCells* cells_;
  std::vector<StressFace> faces_;
  std::vector<int> faceOf_;
  std::shared_ptr<const FreeTractions> none_; ///< of faces without freedom
  std::vector<int> joined_;                   ///< per face the one in contact that replaces it, or -1
};

} // namespace ndframe
