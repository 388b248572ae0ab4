#pragma once

#include <array>
#include <cmath>

#include "ndframe/assembly/constraint_set.hpp"

namespace ndframe
{

/// How the linear tractions (T_0, T_1, T_2) of a face divide into those without wrench, (r_1, 0), (0, r_2), (r_2, r_1)
/// of unit norm, and the smallest ones of a force and a moment over the face's size about its centre: what splitFacet()
/// has as a matrix, in the axes of r_1 and r_2, the arms of T_1 and T_2.
template <class Real>
class FaceFrameOf
{
  template <class Other>
  friend class FaceFrameOf;

public:
  /// The same with other digits.
  template <class Other>
  explicit FaceFrameOf(const FaceFrameOf<Other>& frame)
      : along_(converted(frame.along_)), across_(converted(frame.across_)), normal_(converted(frame.normal_)),
        byFirst_(frame.byFirst_), second_(frame.second_), byHeight_(frame.byHeight_), size_(frame.size_),
        own_(converted(frame.own_))
  {}
  FaceFrameOf(const std::array<Direction, 2>& arms, double size) : size_(Real(size))
  {
    const double first = std::sqrt(dotProduct(arms[0], arms[0]));
    Direction along{}, across{};
    for (std::size_t i = 0; i < 3; ++i)
      along[i] = arms[0][i] / first;
    const double second = dotProduct(arms[1], along);
    for (std::size_t i = 0; i < 3; ++i)
      across[i] = arms[1][i] - second * along[i];
    const double height = std::sqrt(dotProduct(across, across)), square = second * second + height * height,
                 other = 1.0 / std::sqrt(square), both = 1.0 / std::sqrt(first * first + square);
    for (std::size_t i = 0; i < 3; ++i)
      across[i] /= height;
    for (std::size_t i = 0; i < 3; ++i) {
      along_[i] = Real(along[i]);
      across_[i] = Real(across[i]);
      normal_[i] = Real(along[(i + 1) % 3] * across[(i + 2) % 3] - along[(i + 2) % 3] * across[(i + 1) % 3]);
    }
    byFirst_ = Real(1.0 / first);
    second_ = Real(second);
    byHeight_ = Real(1.0 / height);
    own_ = {Real(other * second), Real(other * height), Real(both * second), Real(both * height), Real(both * first)};
  }

  /// T = what `own` (3 numbers) and a wrench (6) amount to, 9 numbers.
  void tractions(const Real* own, const Real* wrench, Real* T) const
  {
    const Real *M = wrench + 3, twist = Real(0.5) * size_ * dotOf(normal_, M);
    // components along, across and normal to r_1
    const Real second[3] = {-byHeight_ * twist, Real(0), byHeight_ * size_ * dotOf(along_, M)};
    const Real T1[3] = {-byFirst_ * second_ * second[0] + own[0] + own_[2] * own[2],
                        byFirst_ * twist + own_[3] * own[2],
                        -byFirst_ * (size_ * dotOf(across_, M) + second_ * second[2])};
    const Real T2[3] = {second[0] + own_[0] * own[1] + own_[4] * own[2], own_[1] * own[1], second[2]};
    for (std::size_t i = 0; i < 3; ++i) {
      T[i] = (wrench[i]);
      T[3 + i] = (T1[0] * along_[i] + T1[1] * across_[i] + T1[2] * normal_[i]);
      T[6 + i] = (T2[0] * along_[i] + T2[1] * across_[i] + T2[2] * normal_[i]);
    }
  }

  /// The transposed map, from forces G on T.
  void forces(const Real* G, Real* own, Real* wrench) const
  {
    const Real G1[3] = {dotOf(along_, G + 3), dotOf(across_, G + 3), dotOf(normal_, G + 3)},
               G2[3] = {dotOf(along_, G + 6), dotOf(across_, G + 6), dotOf(normal_, G + 6)};
    own[0] = (G1[0]);
    own[1] = (own_[0] * G2[0] + own_[1] * G2[1]);
    own[2] = (own_[2] * G1[0] + own_[3] * G1[1] + own_[4] * G2[0]);
    const Real along = size_ * byHeight_ * (G2[2] - second_ * byFirst_ * G1[2]), across = -size_ * byFirst_ * G1[2],
               normal = Real(0.5) * size_ * (byFirst_ * G1[1] - byHeight_ * (G2[0] - second_ * byFirst_ * G1[0]));
    for (std::size_t i = 0; i < 3; ++i) {
      wrench[i] = G[i];
      wrench[3 + i] = along * along_[i] + across * across_[i] + normal * normal_[i];
    }
  }

private:
  template <class Other, std::size_t count>
  static std::array<Real, count> converted(const std::array<Other, count>& values)
  {
    std::array<Real, count> result{};
    for (std::size_t i = 0; i < count; ++i)
      result[i] = Real(values[i]);
    return result;
  }
  static Real dotOf(const std::array<Real, 3>& a, const Real* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  std::array<Real, 3> along_{}, across_{}, normal_{}; ///< r_1 along the first, r_2 in the plane of the first two
  Real byFirst_, second_, byHeight_;                  ///< 1 / |r_1|; r_2 along and, inverse, across
  Real size_;
  std::array<Real, 5> own_; ///< what the second (2) and third (3) traction without wrench have along and across
};

using FaceFrame = FaceFrameOf<double>;

} // namespace ndframe
