#pragma once

#include "ndframe/equilibrium/cell_stress.hpp"
#include "ndframe/equilibrium/reference_stress.hpp"
#include "ndframe/equilibrium/star_wrench.hpp"
#include "part_graph.hpp"
#include "prescribed_tractions.hpp"

namespace ndframe
{

/// settleBalance() of one body, or of this rank's piece of it.
class BalanceSettler
{
public:
  /// size: the body's diameter. piece: what is settled, where this is not the whole body.
  BalanceSettler(const BodyModel& body, const StaticData& data, const FieldInput& field, double size,
                 const BodyPiece* piece, StressCorrection& correction)
      : body_(body), mesh_(body.mesh), data_(data), prescribed_(body, data, field), displacement_(*field.displacement),
        correction_(correction), reference_(referenceStress(data.dim, data.degree)),
        facetMeans_(meanCoordinates(facetBasis(data.dim, data.degree))),
        cellMeans_(meanCoordinates(loadBasis(data.dim, data.degree))), piece_(piece), size_(size),
        tree_(body.mesh, ownOf(piece))
  {
    elastic_.reserve(std::size_t(mesh_.numCells()));
    left_.reserve(elastic_.capacity());
    for (int cell = 0; cell < mesh_.numCells(); ++cell)
      elastic_.push_back(cellStress(body, cell, tree_.cell(cell), displacement_));
  }

  void run()
  {
    begin();
    for (const CellTree::Part& part : tree_.parts()) {
      const Vector about = centre(part.cells.front());
      Vector total(std::size_t(wrenchSize(data_.dim)), 0.0);
      DenseMatrix resistance(wrenchSize(data_.dim), wrenchSize(data_.dim));
      addTotal(part, about, total);
      addResistance(part, about, resistance);
      react(part, about, total, resistance);
      handOn(part);
    }
    correction_.imbalance = largestLeft();
  }

  void runWith(const Comm& comm);

private:
  static std::vector<char> ownOf(const BodyPiece* piece);
  bool isOwn(int cell) const { return piece_ == nullptr || piece_->owns(cell); }
  void begin();
  Vector totals(const PartGraph& graph, const Vector& about, const Comm& comm) const;
  void reactTogether(const PartGraph& graph, const Vector& about, const Comm& comm);
  void passOn(const PartGraph& graph, const Vector& about, const Comm& comm);
  int facetData() const { return reference_.facetModes * data_.dim; }
  double* traction(int half) { return correction_.tractions.data() + std::ptrdiff_t(half) * facetData(); }
  Facet facetOf(int half) const;
  Vector elasticTraction(int half) const;
  void setTractions();
  void setOuterTraction(int half, const Vector& elastic);
  void setLoads(int cell);

  Vector centre(int cell) const;
  Vector arms(int half, const Vector& about) const;
  Vector cellWrench(int cell);
  void addTo(Vector& wrench, int half, const Vector& about, const Vector& traction, double sign) const;
  void change(int half, const Vector& moments, double sign);
  DenseMatrix reactions(int half, const Vector& about) const;
  void addTotal(const CellTree::Part& part, const Vector& about, Vector& total) const;
  std::vector<int> supported(const CellTree::Part& part) const;
  void addResistance(const CellTree::Part& part, const Vector& about, DenseMatrix& resistance) const;
  void react(const CellTree::Part& part, const Vector& about, const Vector& total, const DenseMatrix& resistance);
  void handOn(const CellTree::Part& part);
  double largestLeft() const;

  const BodyModel& body_;
  const Mesh& mesh_;
  const StaticData& data_;
  const PrescribedTractions prescribed_;
  const Vector& displacement_;
  StressCorrection& correction_;
  const ReferenceStress& reference_;
  const Vector facetMeans_, cellMeans_;
  const BodyPiece* piece_;
  const double size_; ///< moments are divided by it
  const CellTree tree_;
  std::vector<CellStress> elastic_; ///< K eps(u~) per cell
  std::vector<Vector> left_;        ///< per cell: wrench of its tractions minus that of its loads, about its centre
};

} // namespace ndframe
