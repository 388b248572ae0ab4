#include <algorithm>

#include "batched_tables.hpp"
#include "ndframe/equilibrium/star_wrench.hpp"
#include "ndframe/equilibrium/static_data.hpp"

namespace ndframe
{
namespace
{

/// The columns of a cell's data x = (T^, G^, bubbles) that belong to bubbles, w, s_1, s_2, loads, rim. Reference axes,
/// the star's vertex first: its spokes are facets 2 (along X_1) and 1 (along X_2), the rim is facet 0.
class Columns
{
public:
  explicit Columns(int degree)
      : reference_(referenceStress(2, degree)), degree_(degree), arm_(meanCoordinates(facetBasis(2, degree))[3]),
        loadMeans_(meanCoordinates(loadBasis(2, degree))), matrix_(reference_.data() + reference_.bubbles, size())
  {
    int column = 0;
    for (int b = 0; b < reference_.bubbles; ++b)
      matrix_(reference_.data() + b, column++) = 1.0;
    for (int i = 0; i < 3; ++i, ++column) {
      const std::array<double, 3> w{double(i == 0), double(i == 1), double(i == 2)};
      addWrench(column, 2, -1.0, w);
      addWrench(column, 1, 1.0, w);
    }
    for (const int facet : {2, 1}) {
      const double sign = facet == 2 ? -1.0 : 1.0;
      const int along = facet == 2 ? 0 : 1;
      at(facet, 1, along, column++) = sign;
      for (int k = 2; k <= degree; ++k) {
        at(facet, k, along, column++) = sign;
        at(facet, k, 1 - along, column++) = sign;
      }
    }
    addLoads(column);
  }

  const DenseMatrix& matrix() const { return matrix_; }
  /// Mean of s L_1 along a spoke.
  double arm() const { return arm_; }
  /// Wrench about the vertex that a unit load mode (or, after the loads, minus that of a traction on the rim) sends
  /// through the second spoke.
  std::array<double, 3> wrench(int mode, int i) const
  {
    const int rimMode = mode - reference_.loadModes;
    const bool isLoad = rimMode < 0;
    const double force = isLoad ? double(mode == 0) : -double(rimMode == 0);
    const double end = rimMode == 0 ? 0.5 : (rimMode == 1 ? arm_ : 0.0); // on the rim X_2 = s, X_1 = 1 - s
    const double arm1 = isLoad ? loadMeans_[3 * std::size_t(mode) + 1] : end + force;
    const double arm2 = isLoad ? loadMeans_[3 * std::size_t(mode) + 2] : -end;
    return {i == 0 ? force : 0.0, i == 1 ? force : 0.0, i == 0 ? -arm2 : arm1};
  }
  /// Moment mode, along X_1, of a traction with wrench w on the second spoke.
  double bend(const std::array<double, 3>& w) const { return -(w[2] + 0.5 * w[0]) / arm_; }

private:
  int size() const { return reference_.bubbles + cellUnknowns(degree_) + reference_.loads + 2 * reference_.facetModes; }

  double& at(int facet, int mode, int component, int column)
  {
    return matrix_((facet * reference_.facetModes + mode) * 2 + component, column);
  }

  /// A traction with this wrench on the first spoke (facet 2) or the second (facet 1): constant, and linear along the
  /// other spoke.
  void addWrench(int column, int facet, double sign, const std::array<double, 3>& w)
  {
    at(facet, 0, 0, column) += sign * w[0];
    at(facet, 0, 1, column) += sign * w[1];
    if (facet == 2)
      at(facet, 1, 1, column) += sign * (w[2] - 0.5 * w[1]) / arm_;
    else
      at(facet, 1, 0, column) += sign * bend(w);
  }

  void addLoads(int column)
  {
    for (int mode = 0; mode < reference_.loadModes + reference_.facetModes; ++mode)
      for (int i = 0; i < 2; ++i, ++column) {
        if (mode < reference_.loadModes)
          matrix_(reference_.tractions + 2 * mode + i, column) = 1.0;
        else
          at(0, mode - reference_.loadModes, i, column) = 1.0;
        addWrench(column, 1, 1.0, wrench(mode, i));
      }
  }

  const ReferenceStress& reference_;
  int degree_;
  double arm_;
  Vector loadMeans_;
  DenseMatrix matrix_;
};

/// The tables of energy in these columns.
std::vector<DenseMatrix> energyTables(const ReferenceStress& reference, const DenseMatrix& columns)
{
  std::vector<DenseMatrix> tables;
  for (const DenseMatrix& energy : reference.energy)
    tables.push_back(multiplyTransposed(columns, multiply(energy, columns)));
  return tables;
}

void append(std::vector<double>& list, const std::vector<DenseMatrix>& tables, int i, int j)
{
  for (const DenseMatrix& table : tables)
    list.push_back(table(i, j));
}

/// Moments on a spoke of the share of a traction that is linear, from its values at the star's vertex and at the other
/// end. Order 1: it is constant.
void setTractionShares(int degree, int order, StarTables& tables)
{
  const Shares shares(facetBasis(2, degree), order);
  std::copy_n(order == 1 ? shares.ofOne(0) : shares.ofLinear(0, 0), degree + 1, tables.shareHere);
  if (order == 2)
    std::copy_n(shares.ofLinear(0, 1), degree + 1, tables.shareThere);
}

/// Load modes that are combinations (rows of `mix`) of all modes: loads, then tractions on the rim.
LoadArrays mixModes(const Columns& columns, const std::vector<DenseMatrix>& energy, int rows, const DenseMatrix& mix)
{
  LoadArrays arrays;
  const auto combined = [&mix](int mode, auto value) {
    double sum = 0.0;
    for (int k = 0; k < mix.cols(); ++k)
      if (mix(mode, k) != 0.0)
        sum += mix(mode, k) * value(k);
    return sum;
  };
  for (int mode = 0; mode < mix.rows(); ++mode) {
    arrays.force.push_back(combined(mode, [&](int k) { return columns.wrench(k, 0)[0]; }));
    arrays.arms.push_back(combined(mode, [&](int k) { return columns.wrench(k, 1)[2]; }));
    arrays.arms.push_back(combined(mode, [&](int k) { return -columns.wrench(k, 0)[2]; }));
    for (int i = 0; i < 2; ++i)
      arrays.bend.push_back(combined(mode, [&](int k) { return columns.bend(columns.wrench(k, i)); }));
  }
  for (int row = 0; row < rows; ++row)
    for (int mode = 0; mode < mix.rows(); ++mode)
      for (int i = 0; i < 2; ++i)
        for (const DenseMatrix& table : energy)
          arrays.coupling.push_back(combined(mode, [&](int k) { return table(row, rows + 2 * k + i); }));
  return arrays;
}

DenseMatrix identity(int rows, int cols)
{
  DenseMatrix one(rows, cols);
  for (int i = 0; i < rows; ++i)
    one(i, i) = 1.0;
  return one;
}

} // namespace

LoadModes LoadArrays::modes() const
{
  return {int(force.size()), coupling.data(), force.data(), arms.data(), bend.data(), share.data()};
}

BatchedStarTables::BatchedStarTables(int degree, int order, const Elasticity& law)
{
  const ReferenceStress& reference = referenceStress(2, degree);
  const Columns columns(degree);
  const std::vector<DenseMatrix> energy = energyTables(reference, columns.matrix());
  const int rows = reference.bubbles + cellUnknowns(degree), modes = reference.loadModes;
  for (int i = 0; i < rows; ++i)
    for (int j = i; j < rows; ++j)
      append(form_, energy, i, j);
  const Shares shares(loadBasis(2, degree), order);
  DenseMatrix constant(1, modes);
  for (int k = 0; k < modes; ++k)
    constant(0, k) = shares.ofOne(0)[k];
  constant_ = mixModes(columns, energy, rows, constant);
  constant_.share = {1.0};
  full_ = mixModes(columns, energy, rows, identity(modes, modes));
  full_.share.assign(shares.ofOne(0), shares.ofOne(0) + modes);
  withRim_ = mixModes(columns, energy, rows, identity(modes + reference.facetModes, modes + reference.facetModes));
  tables_.form = form_.data();
  tables_.arm = columns.arm();
  setTractionShares(degree, order, tables_);
  std::copy_n(planeLaw(law).compliance, 6, tables_.compliance);
  tables_.constant = constant_.modes();
  tables_.full = full_.modes();
  tables_.withRim = withRim_.modes();
}

} // namespace ndframe
