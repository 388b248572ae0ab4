#pragma once

#include "initial_tractions.hpp"
#include "ndframe/equilibrium/star_data.hpp"
#include "ndframe/flow/flow_potentials.hpp"

namespace ndframe
{

/// Brings the cells of stars into balance by wrenches that flow from cell to cell like a current: what a cell lacks is
/// a potential's difference to its neighbours (and to the supports) times a conductance, the area of the face squared
/// over the volumes beside it. Not the least energy, but near enough to begin with: one small factorisation a star.
///
/// Stars know wrenches alone: the tractions that they have together are in the corrections from the beginning
/// (InitialTractions), and what flows through a face for its three vertices is added at once.
class WrenchBalance
{
public:
  /// body: its number in faces.cells(). corrections: of all fields, without data. All must outlive it.
  WrenchBalance(int body, const StressFaces& faces, const std::vector<FieldInput>& fields,
                const BodyCorrections& corrections, int threads);

  /// What flows in a star.
  struct Flows
  {
    std::vector<int> faces;      ///< of the body alone
    std::vector<Wrench> amounts; ///< per field and face: of the face's carriers, on its first cell
    Vector left, force; ///< per field: the wrench (moments over the star's size) that nothing takes; all forces there
  };
  /// Throws SelfTouching when the star's cells do not hang together through facets.
  Flows balance(int vertex) const;
  void add(const Flows& star);
  /// When all stars have been added: their tractions come into the corrections.
  void finish();

private:
  struct Around;

  Around around(int vertex) const;
  void requireConnected(const Around& star) const;
  void findLinks(Around& star) const;
  DenseMatrix imbalance(const Around& star, std::size_t field, double& force) const;
  const StressFace& face(int number) const { return (*faces_)[number]; }
  void share(const Around& star, const Vector& left, const DenseMatrix& free, DenseMatrix& needed) const;
  Wrench amounts(std::size_t link, const DenseMatrix& potentials, const Around& star) const;

  int number_;
  const StarBody* body_;
  const StressFaces* faces_;
  BodyCorrections corrections_;
  std::vector<InitialTractions> initial_; ///< per field
  Vector volumes_;
  std::vector<std::vector<Wrench>> through_; ///< per field and face: amounts of all stars
};

} // namespace ndframe
