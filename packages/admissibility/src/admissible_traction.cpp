#include "ndframe/admissibility/admissible_traction.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "banded_program.hpp"
#include "facet_unknowns.hpp"
#include "ndframe/admissibility/quadratic_program.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Work below this, relative to that of a unit pressure, is round-off: the motion slides along the interface.
constexpr double noWork = 1e-12;
/// Loads that are out of reach by less than this, relative to their magnitude, are round-off.
constexpr double unreachable = 1e-9;

/// Positions of the interface nodes along the patches, so that neighbours stay close: breadth first (Cuthill and McKee
/// 1969), every chain of edges from one of its ends, a surface from a vertex with one patch, closed ones from any node.
class ChainOrder
{
public:
  ChainOrder(const std::vector<ContactPatch>& patches, int numNodes, int nodesPerFacet)
      : patches_(patches), nodesPerFacet_(nodesPerFacet), around_(std::size_t(numNodes)),
        position_(std::size_t(numNodes), -1)
  {
    for (std::size_t f = 0; f < patches.size(); ++f)
      for (int i = 0; i < nodesPerFacet; ++i)
        around_[std::size_t(patches[f].nodes[std::size_t(i)])].push_back(f);
    for (const bool ends : {true, false})
      for (const ContactPatch& patch : patches)
        for (int i = 0; i < patch.dim; ++i)
          if (!ends || around_[std::size_t(patch.nodes[std::size_t(i)])].size() == 1)
            number(patch.nodes[std::size_t(i)]);
    NDFRAME_ASSERT(next_ == numNodes, "every interface node belongs to a patch");
  }

  int position(int node) const { return position_[std::size_t(node)]; }

private:
  /// Everything that hangs together with `start`, unless it has numbers already.
  void number(int start)
  {
    std::vector<int> reached;
    const auto reach = [&](int node) {
      if (position_[std::size_t(node)] < 0) {
        position_[std::size_t(node)] = next_++;
        reached.push_back(node);
      }
    };
    reach(start);
    for (std::size_t at = 0; at < reached.size(); ++at)
      for (const std::size_t f : around_[std::size_t(reached[at])])
        for (int i = nodesPerFacet_ - 1; i >= 0; --i) // the middle comes before the other end
          reach(patches_[f].nodes[std::size_t(i)]);
  }

  const std::vector<ContactPatch>& patches_;
  int nodesPerFacet_;
  std::vector<std::vector<std::size_t>> around_;
  std::vector<int> position_;
  int next_ = 0;
};

SymmetricRows massMatrix(const std::vector<ContactPatch>& patches, const FacetUnknowns& unknowns,
                         const ChainOrder& order, int numNodes, int p)
{
  SymmetricRows M(numNodes);
  for (std::size_t f = 0; f < patches.size(); ++f)
    for (int i = 0; i < numFacetNodes(patches[f].dim, p); ++i)
      for (int j = 0; j <= i; ++j)
        M.add(order.position(patches[f].nodes[std::size_t(i)]), order.position(patches[f].nodes[std::size_t(j)]),
              patches[f].measure * unknowns.mass(i, j));
  return M;
}

Vector permuted(const Vector& nodal, const ChainOrder& order)
{
  Vector values(nodal.size());
  for (std::size_t node = 0; node < nodal.size(); ++node)
    values[std::size_t(order.position(int(node)))] = nodal[node];
  return values;
}

/// The work of unit unknowns, n x conditions; motions that slide along the interface do none.
SparseColumns workMatrix(const FacetUnknowns& unknowns, const ChainOrder& order, const BalanceConditions& balance,
                         double area, int numNodes)
{
  SparseColumns W(numNodes, balance.work.cols());
  SparseSum sum(numNodes);
  for (int k = 0; k < W.cols(); ++k) {
    SparseRow row = unknowns.workFromNodal(balance.work.column(k), sum);
    double total = 0.0;
    for (auto& [node, work] : row) {
      node = order.position(node);
      total += std::abs(work);
    }
    std::sort(row.begin(), row.end());
    if (total > noWork * area)
      W.setColumn(k, std::move(row));
  }
  return W;
}

/// With more conditions what is out of reach is seen by the projection itself.
constexpr int mostOfOneProgram = 20;

/// The motions that take part in a combination: "translation along y and rotation about (0, 1)".
std::string namesOf(const Vector& combination, const std::vector<std::string>& names)
{
  constexpr double share = 0.1;
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    if (std::abs(combination[k]) > share * norm(combination))
      text += (text.empty() ? "" : " and ") + names[k];
  return text;
}

/// The value nearest to that of the conditions that some t_N <= 0 reaches. The rest is the nearest point of the polar
/// cone {rho : W rho >= 0}; if it is not round-off, it is Farkas's proof that the loads cannot be balanced.
Vector reachableValue(const SparseColumns& W, const BalanceConditions& balance)
{
  const int conditions = W.cols();
  QuadraticProgram polar{DenseMatrix(conditions, conditions), balance.value, DenseMatrix(W.rows(), conditions),
                         Vector(std::size_t(W.rows()), 0.0)};
  for (int k = 0; k < conditions; ++k) {
    polar.H(k, k) = 1.0;
    polar.h[std::size_t(k)] = -balance.value[std::size_t(k)];
    for (const auto& [i, work] : W.column(k))
      polar.B(i, k) = -work;
  }
  const auto rest = minimise(polar);
  NDFRAME_ASSERT(rest, "zero lies in every cone");
  const double magnitude = std::max(norm(balance.magnitude), norm(balance.value));
  if (norm(rest->x) > unreachable * magnitude)
    throw InfeasibleTraction{namesOf(rest->x, balance.names)};
  return multiplyTransposed(polar.B, DenseMatrix(rest->multipliers)).column(0);
}

/// The projection for one choice of unknowns, all of them <= 0.
class Projection
{
public:
  Projection(const std::vector<ContactPatch>& patches, int order, const Vector& mean, const BalanceConditions& balance,
             const Vector& cost)
      : patches_(patches), order_(order), mean_(mean), balance_(balance), cost_(cost),
        chain_(patches, int(mean.size()), numFacetNodes(dimOf(patches), order))
  {}

  /// Nodal values of the nearest.
  Vector nearest(const FacetUnknowns& unknowns) const
  {
    const int numNodes = int(mean_.size());
    double area = 0.0;
    for (const ContactPatch& patch : patches_)
      area += patch.measure;
    SparseColumns W = workMatrix(unknowns, chain_, balance_, area, numNodes);
    const bool few = W.cols() <= mostOfOneProgram;
    Vector value = few ? reachableValue(W, balance_) : balance_.value;
    BandedProgram program{massMatrix(patches_, unknowns, chain_, numNodes, order_),
                          {},
                          std::move(W),
                          std::move(value),
                          few ? 0.0 : std::max(largestEntry(balance_.magnitude), largestEntry(balance_.value))};
    Vector wanted = mean_;
    unknowns.fromNodal(wanted);
    program.f = product(program.M.rows(), permuted(wanted, chain_));
    addCost(unknowns, program.f);
    const auto solution = minimise(program);
    if (!solution)
      throw InfeasibleTraction("rigid motions of the bodies");
    const Vector& found = *solution;
    Vector nodal(mean_.size());
    for (int node = 0; node < numNodes; ++node)
      nodal[std::size_t(node)] = found[std::size_t(chain_.position(node))];
    unknowns.toNodal(nodal);
    return nodal;
  }

private:
  void addCost(const FacetUnknowns& unknowns, Vector& f) const
  {
    SparseRow nodal;
    for (std::size_t node = 0; node < cost_.size(); ++node)
      nodal.emplace_back(int(node), cost_[node]);
    SparseSum sum(int(mean_.size()));
    for (const auto& [node, cost] : unknowns.workFromNodal(nodal, sum))
      f[std::size_t(chain_.position(node))] -= cost;
  }

  const std::vector<ContactPatch>& patches_;
  int order_;
  const Vector& mean_;
  const BalanceConditions& balance_;
  const Vector& cost_;
  ChainOrder chain_;
};

} // namespace

Vector projectTraction(const std::vector<ContactPatch>& patches, int numNodes, int order, const Vector& mean,
                       const BalanceConditions& balance, TractionSign sign, const Vector& cost)
{
  NDFRAME_ASSERT(int(mean.size()) == numNodes, "one value per interface node is needed");
  const Projection projection(patches, order, mean, balance, cost);
  return projection.nearest(FacetUnknowns(patches, order, sign));
}

} // namespace ndframe
