#pragma once

#include <optional>

#include "ndframe/algebra/sparse_row.hpp"
#include "tpetra_maps.hpp"

namespace ndframe
{

/// Places of kept dofs among this rank's dofs.
class KeptPlaces
{
public:
  /// kept: their numbers, dim for each node; -1: not among these. nodes: of this rank.
  KeptPlaces(const std::vector<IndexMap::Global>& kept, const IndexMap& nodes, int dim,
             Teuchos::RCP<const Teuchos::Comm<int>> comm);

  struct Place
  {
    int kept;        ///< its place in the list of all kept dofs
    std::size_t dof; ///< of this rank
  };
  const std::vector<Place>& own() const { return own_; }
  const Teuchos::RCP<const Teuchos::Comm<int>>& comm() const { return comm_; }

private:
  std::vector<Place> own_;
  Teuchos::RCP<const Teuchos::Comm<int>> comm_;
};

/// Kept values become rows times them. A rank takes part with its own ones and gets from others those that they follow:
/// none where both partners of each contact pair are on one rank.
class KeptRows
{
public:
  KeptRows() = default;
  /// rows: of all ranks, by places in the list of kept dofs. places: must outlive it. Collective.
  KeptRows(const KeptPlaces& places, const std::vector<SparseRow>& rows);

  void apply(double* x) const; ///< x: the dofs of this rank; its values at kept dofs change
  Traffic traffic() const { return sent_ ? sent_->halo.traffic() : Traffic(); }

private:
  struct Sent
  {
    Halo halo;
    Teuchos::RCP<TpetraVectors> own, needed;
  };

  const KeptPlaces* places_ = nullptr;
  std::vector<SparseRow> rows_; ///< per own kept dof, by places in given_
  std::optional<Sent> sent_;    ///< none on one rank
  mutable std::vector<double> given_;
};

/// Rows that change and their transpose.
class FollowingRows
{
public:
  /// places: must outlive it. Collective.
  void follow(const KeptPlaces& places, const std::vector<SparseRow>& rows)
  {
    before_ = traffic();
    rows_ = KeptRows(places, rows);
    transpose_ = KeptRows(places, transposed(rows, int(rows.size())));
  }

  void apply(double* x) const { rows_.apply(x); }               ///< x: as of KeptRows
  void applyTranspose(double* x) const { transpose_.apply(x); } ///< the same
  Traffic traffic() const                                       ///< with what earlier rows have sent
  {
    Traffic sum = before_;
    sum += rows_.traffic();
    sum += transpose_.traffic();
    return sum;
  }

private:
  KeptRows rows_, transpose_;
  Traffic before_;
};

} // namespace ndframe
