#include "mortar_conditions.hpp"

#include <algorithm>
#include <cmath>

#include "mortar_functions.hpp"
#include "ndframe/algebra/sparse_cholesky.hpp"

namespace ndframe
{
namespace
{

constexpr double roundOff = 1e-18; ///< of the largest entry of a row of an inverse mass matrix, which decays

/// The entries in columns that get a number, by that.
void renumber(std::vector<SparseRow>& rows, const std::vector<int>& numbers)
{
  for (SparseRow& row : rows) {
    SparseRow kept;
    for (const auto& [column, value] : row)
      if (numbers[std::size_t(column)] >= 0)
        kept.emplace_back(numbers[std::size_t(column)], value);
    row = std::move(kept);
  }
}

/// The functions of all interfaces and what they are at the nodes, in one numbering.
struct AllFunctions
{
  std::vector<SparseRow> values; ///< per node
  std::vector<int> nodes;        ///< per function, -1 where it has none
  std::vector<char> isMortar;    ///< per function: of an interface with isMortar
  bool isMean(int node) const { return isMortar[std::size_t(values[std::size_t(node)].front().first)] != 0; }
  bool differ = false; ///< from the nodes

  void add(const InterfaceMesh& interface, const std::vector<BodyModel>& bodies, bool isBernstein)
  {
    const auto firstNode = int(values.size()), first = int(nodes.size());
    if (!interface.isMortar) {
      for (int i = 0; i < interface.numNodes(); ++i) {
        values.push_back({{first + i, 1.0}});
        nodes.push_back(firstNode + i);
      }
    } else {
      const MortarFunctions own(interface, bodies, isBernstein);
      differ = differ || own.differ();
      for (SparseRow row : own.values()) {
        for (auto& entry : row)
          entry.first += first;
        values.push_back(std::move(row));
      }
      for (const int node : own.nodes())
        nodes.push_back(node < 0 ? -1 : firstNode + node);
    }
    isMortar.resize(nodes.size(), char(interface.isMortar));
  }
};

std::vector<SparseRow> basisRows(const InterfaceSystem& system)
{
  std::vector<SparseRow> rows;
  for (int i = 0; i < system.C->size(); ++i)
    rows.push_back(system.basis ? system.basis->row(i) : SparseRow{{i, 1.0}});
  return rows;
}

/// C in the coefficients at the unknowns: (B^-T C B^-1)_ij.
std::vector<SparseRow> massOfUnknowns(const InterfaceSystem& system, const std::vector<int>& unknownAt)
{
  std::vector<SparseRow> C, nodal = inverseOf({basisRows(system), Vector(unknownAt.size(), 0.0)}).rows;
  for (int i = 0; i < system.C->size(); ++i)
    C.push_back(system.C->row(i));
  renumber(nodal, unknownAt);
  return product(transposed(nodal, system.size()), product(C, nodal, system.size()), system.size());
}

/// E: per unknown the functions that carry contact, numbered anew; those of nodes without unknown do not. An unknown of
/// an interface without means is its own function, in whatever basis.
std::vector<SparseRow> functionsAtUnknowns(const InterfaceSystem& system, const std::vector<int>& unknownAt,
                                           AllFunctions& all)
{
  const auto coefficients = product(basisRows(system), all.values, int(all.nodes.size()));
  std::vector<SparseRow> E;
  for (const int node : system.nodeOfUnknown)
    E.push_back((all.isMean(node) ? coefficients : all.values)[std::size_t(node)]);
  std::vector<int> number(all.nodes.size(), -1);
  for (SparseRow& row : E) {
    row.erase(std::remove_if(row.begin(), row.end(), [](const auto& entry) { return entry.second == 0.0; }), row.end());
    for (const auto& entry : row)
      number[std::size_t(entry.first)] = 0;
  }
  std::vector<char> isMortar;
  for (std::size_t j = 0; j < number.size(); ++j) {
    const bool carries = number[j] == 0 && (all.nodes[j] < 0 || unknownAt[std::size_t(all.nodes[j])] >= 0);
    number[j] = carries ? int(isMortar.size()) : -1;
    if (carries)
      isMortar.push_back(all.isMortar[j]);
  }
  all.isMortar = std::move(isMortar);
  renumber(E, number);
  return E;
}

/// Per unknown whether it is a function of its own, on which W is 1.
std::vector<char> areFunctions(const std::vector<SparseRow>& Et, std::size_t unknowns)
{
  std::vector<char> are(unknowns, 0);
  for (const SparseRow& function : Et)
    if (function.size() == 1)
      are[std::size_t(function.front().first)] = 1;
  return are;
}

/// W = (E^T C E)^-1 E^T C; of other conditions than means the unknown itself.
std::vector<SparseRow> meansOf(const std::vector<SparseRow>& E, const std::vector<SparseRow>& C,
                               const std::vector<char>& isMean)
{
  const auto size = int(isMean.size()), unknowns = int(E.size());
  const std::vector<SparseRow> Et = transposed(E, size);
  std::vector<SparseRow> right = product(Et, C, unknowns);
  const std::vector<SparseRow> mass = product(right, E, size);
  SymmetricEntries entries;
  entries.size = size;
  for (int i = 0; i < size; ++i)
    for (const auto& [j, value] : mass[std::size_t(i)])
      if (i <= j)
        entries.add(i, j, value);
  const SparseCholesky factor(entries);
  const std::vector<char> alone = areFunctions(Et, E.size());
  for (SparseRow& row : right)
    row.erase(std::remove_if(row.begin(), row.end(), [&](const auto& e) { return alone[std::size_t(e.first)] != 0; }),
              row.end());
  std::vector<SparseRow> W;
  SparseSum sum(unknowns);
  for (int i = 0; i < size; ++i) {
    if (const SparseRow& function = Et[std::size_t(i)]; function.size() == 1)
      sum.add(function.front().first, 1.0);
    if (!isMean[std::size_t(i)]) {
      W.push_back(sum.take());
      continue;
    }
    Vector unit(std::size_t(size), 0.0);
    unit[std::size_t(i)] = 1.0;
    const Vector inverse = factor.solve(unit);
    const double least = roundOff * largestEntry(inverse);
    for (std::size_t j = 0; j < inverse.size(); ++j)
      if (std::abs(inverse[j]) > least)
        sum.add(right[j], inverse[j]);
    W.push_back(sum.take());
  }
  return W;
}

} // namespace

std::shared_ptr<const MortarSpace> mortarSpace(const Model& model, const InterfaceSystem& system)
{
  if (std::none_of(model.interfaces.begin(), model.interfaces.end(), [](const auto& i) { return i.isMortar; }))
    return nullptr;
  AllFunctions all;
  for (const InterfaceMesh& interface : model.interfaces)
    all.add(interface, model.bodies, system.basis != nullptr);
  if (!all.differ)
    return nullptr;
  std::vector<int> unknownAt(std::size_t(system.C->size()), -1);
  for (std::size_t i = 0; i < system.nodeOfUnknown.size(); ++i)
    unknownAt[std::size_t(system.nodeOfUnknown[i])] = int(i);
  std::vector<SparseRow> E = functionsAtUnknowns(system, unknownAt, all);
  std::vector<SparseRow> W = meansOf(E, massOfUnknowns(system, unknownAt), all.isMortar);
  return std::make_shared<MortarSpace>(std::move(E), std::move(W));
}

} // namespace ndframe
