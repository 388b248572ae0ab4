#pragma once

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/equilibrium/stress_correction.hpp"

namespace ndframe
{

/// What a rank holds of a body whose cells are shared by the ranks: its own cells, and those that have a vertex in
/// common with one of them, its ghosts. Cells and vertices are numbered in the order of the body's, nodes as in the
/// body, so that displacements of the whole body serve the piece.
struct BodyPiece
{
  BodyModel model;                   ///< cells, vertices, node numbers and laws; without sides, supports and loads
  StaticData data;                   ///< of the held cells, without the oscillation
  const BodyModel* body = nullptr;   ///< not owned: the whole one, or this rank's share of it
  std::size_t numContact = 0;        ///< contact facets of the body
  std::vector<int> cells;            ///< held ones by their places in `body`
  std::vector<int> places;           ///< per cell of `body` its place in `cells`, or -1
  std::vector<std::int64_t> numbers; ///< of held cells, known to all ranks, ascending
  std::vector<int> owner;            ///< per held cell
  std::vector<int> points;           ///< vertices by their numbers in the body, ascending
  std::vector<int> contact;          ///< per facet of data.contact its place among the body's
  int rank = 0;                      ///< this one
  Direction centre{};                ///< of the box around the whole body
  double extent = 0.0;               ///< its diagonal
  SharedValues shared;               ///< the values of held cells

  bool owns(int cell) const { return owner[std::size_t(cell)] == rank; } ///< a held cell
  std::vector<int> ownCells() const;
  int local(int cell) const { return places[std::size_t(cell)]; } ///< the held cell that this one of `body` is, or -1
  int held(std::int64_t number) const;                            ///< the cell with this of `numbers`, or -1
  /// The shares of all contact facets of the body (FieldInput::contact), of the held ones.
  Vector ofContact(const Vector& all) const;
  /// Those of a piece become those of `body`: of all cells on all ranks, or of those of a share that this rank holds.
  /// Collective.
  void gather(StressCorrection& correction, const Comm& comm) const;
  /// The ghosts' data become those of their owners. Collective.
  void fetchGhosts(StressCorrection& correction) const;
};

/// owner: per cell of the body. isTouched: per vertex of the body, nonzero where an own cell has it (and where one does
/// through contact): cells that have such a vertex are held. body: a whole one or a share; must outlive the piece.
/// Collective.
BodyPiece cutPiece(const BodyModel& body, const StaticData& data, const std::vector<int>& owner,
                   const std::vector<char>& isTouched, const Comm& comm);

} // namespace ndframe
