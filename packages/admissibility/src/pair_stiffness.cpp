#include "pair_stiffness.hpp"

#include <algorithm>
#include <cmath>

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

/// Adds a body's part of a(m_i, m_j).
void addBody(const NodeStiffness& blocks, const Members& members, const std::vector<Compliance>& moves,
             std::vector<std::map<int, double>>& rows)
{
  for (const auto& [nodes, block] : blocks) {
    const auto ours = members.find(nodes.first), theirs = members.find(nodes.second);
    if (ours == members.end() || theirs == members.end())
      continue;
    for (const Member& i : ours->second)
      for (const Member& j : theirs->second)
        rows[std::size_t(i.pair)][j.pair] +=
            block.work(moves[std::size_t(i.pair)].move[i.side], moves[std::size_t(j.pair)].move[j.side]);
  }
}

/// The least opening of a pair's patches when its nodes move.
double leastGain(const Pair& pair, const Compliance& apart, const std::vector<ContactPatch>& patches)
{
  double smallest = HUGE_VAL;
  for (const Corner& corner : pair.corners)
    smallest = std::min(smallest, apart.gain(patches[corner.patch].normal));
  return smallest;
}

} // namespace

double PairMoves::work(int i, const std::vector<NodalField>& forces) const
{
  const Pair& pair = pairs[std::size_t(i)];
  double sum = 0.0;
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t k = 0; k < dim; ++k)
      sum += moves[std::size_t(i)].move[side][k] * forces[pair.body[side]][std::size_t(pair.node[side]) * dim + k];
  return sum;
}

PairMoves pairMoves(const std::vector<ContactPatch>& patches, InterfacePairs& pairs)
{
  PairMoves result;
  result.dim = std::size_t(dimOf(patches));
  std::vector<Members> members(pairs.numBodies());
  for (const auto& [node, pair] : pairs.all()) {
    Compliance apart = pairs.compliance(pair);
    const double gain = leastGain(pair, apart, patches);
    if (gain <= 0.0 || pairs.isShared(pair))
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
  std::vector<std::map<int, double>> rows(result.pairs.size());
  for (std::size_t b = 0; b < members.size(); ++b)
    if (!members[b].empty())
      addBody(pairs.stiffness(b), members[b], result.moves, rows);
  for (const auto& row : rows)
    result.rows.emplace_back(row.begin(), row.end());
  return result;
}

} // namespace ndframe
