#include "pair_stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/mechanics/kernels.hpp"

namespace ndframe
{
namespace
{

/// A pair's node in a body.
struct Member
{
  int pair;
  std::size_t side;
};

/// Members of a body by its nodes.
using Members = std::map<int, std::vector<Member>>;

class PairStiffness
{
public:
  explicit PairStiffness(PairMoves& result) : result_(result), rows_(result.pairs.size()) {}

  template <int order>
  void addBody(const BodyModel& body, const Members& members)
  {
    constexpr int nodes = Lagrange<2, order>::nodes, dofs = 2 * nodes;
    const QuadratureRule rule = simplexRule(2, 2 * (order - 1));
    double points[6], element[dofs * dofs];
    for (int cell = 0; cell < body.mesh.numCells(); ++cell) {
      const int* cellNodes = body.nodes.cell(cell);
      if (std::none_of(cellNodes, cellNodes + nodes, [&](int node) { return members.count(node) > 0; }))
        continue;
      for (int v = 0; v < 3; ++v)
        std::copy_n(body.mesh.point(body.mesh.cell(cell)[v]), 2, points + v * 2);
      elementStiffness<2, order>(points, body.law, rule, element);
      for (int a = 0; a < nodes; ++a)
        for (int b = 0; b < nodes; ++b)
          addBlock(members, cellNodes[a], cellNodes[b], element + a * 2 * dofs + b * 2, dofs);
    }
  }

  void finish()
  {
    for (const auto& row : rows_)
      result_.rows.emplace_back(row.begin(), row.end());
  }

private:
  void addBlock(const Members& members, int a, int b, const double* K, int dofs)
  {
    const auto ours = members.find(a), theirs = members.find(b);
    if (ours == members.end() || theirs == members.end())
      return;
    for (const Member& i : ours->second)
      for (const Member& j : theirs->second) {
        const Direction &m = result_.moves[std::size_t(i.pair)].move[i.side],
                        &n = result_.moves[std::size_t(j.pair)].move[j.side];
        rows_[std::size_t(i.pair)][j.pair] +=
            m[0] * (K[0] * n[0] + K[1] * n[1]) + m[1] * (K[dofs] * n[0] + K[dofs + 1] * n[1]);
      }
  }

  PairMoves& result_;
  std::vector<std::map<int, double>> rows_;
};

/// The mean opening of a pair's facets when its nodes move.
double meanGain(const Pair& pair, const Compliance& apart, const std::vector<ContactFacet>& facets)
{
  double smallest = HUGE_VAL;
  for (const Corner& corner : pair.corners)
    smallest = std::min(smallest, apart.gain(facets[corner.facet].normal));
  return smallest;
}

} // namespace

double PairMoves::work(int i, const std::vector<Vector>& forces) const
{
  const Pair& pair = pairs[std::size_t(i)];
  double sum = 0.0;
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t k = 0; k < 2; ++k)
      sum += moves[std::size_t(i)].move[side][k] * forces[pair.body[side]][std::size_t(pair.node[side]) * 2 + k];
  return sum;
}

PairMoves pairMoves(const std::vector<const BodyModel*>& bodies, const std::vector<ContactFacet>& facets,
                    InterfacePairs& pairs)
{
  PairMoves result;
  std::vector<Members> members(bodies.size());
  for (const auto& [node, pair] : pairs.all()) {
    Compliance apart = pairs.compliance(pair);
    const double gain = meanGain(pair, apart, facets);
    if (gain <= 0.0)
      continue;
    const int number = int(result.pairs.size());
    for (std::size_t side = 0; side < 2; ++side) {
      for (double& component : apart.move[side])
        component /= gain;
      members[pair.body[side]][pair.node[side]].push_back({number, side});
    }
    result.index[node] = number;
    result.pairs.push_back(pair);
    result.moves.push_back(apart);
  }
  PairStiffness stiffness(result);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    bodies[b]->nodes.order == 1 ? stiffness.addBody<1>(*bodies[b], members[b])
                                : stiffness.addBody<2>(*bodies[b], members[b]);
  stiffness.finish();
  return result;
}

} // namespace ndframe
