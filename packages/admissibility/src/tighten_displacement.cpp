#include "ndframe/admissibility/tighten_displacement.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "pair_stiffness.hpp"

namespace ndframe
{
namespace
{

/// Passes over the nodes end when one lowers the bound by less than this, relative.
constexpr double settled = 1e-13;
constexpr int mostPasses = 200;

/// The bound as a function of the openings x of the interface's pairs of nodes, from u_h.
class Tightening
{
public:
  Tightening(const std::vector<const BodyModel*>& bodies, const std::vector<const ConstraintSet*>& constraints,
             const std::vector<ContactPatch>& patches, const GapBound& gap, const BoundOfDisplacement& bound,
             AdmissibleDisplacement& admissible)
      : patches_(patches), isQuadratic_(bodies.front()->nodes.order == 2), bound_(bound), admissible_(admissible),
        pairs_(bodies, constraints, patches, gap, admissible.displacement), moves_(pairMoves(patches, pairs_)),
        force_(moves_.pairs.size(), 0.0)
  {}

  void run(const std::vector<NodalField>& displacement);

private:
  /// What a Bernstein coefficient of the jump, lowered by 1, opens.
  using Opening = std::vector<std::pair<int, double>>;

  /// A coefficient of a patch's jump and how much it falls when a pair opens by 1.
  struct Condition
  {
    std::size_t patch, coefficient;
    double gain;
  };

  Opening opening(int pair) const;
  std::vector<Condition> conditions(const Opening& opening) const;
  double moved(int pair, const std::vector<NodalField>& displacement) const;
  double square(double sign, double contact) const;
  std::pair<double, double> range(int pair) const;
  void pass(double A, double R);
  void open(int pair, double amount);

  const std::vector<ContactPatch>& patches_;
  const bool isQuadratic_;
  const BoundOfDisplacement& bound_;
  AdmissibleDisplacement& admissible_;
  InterfacePairs pairs_;
  const PairMoves moves_;
  Vector residual_, traction_; ///< <d, eps(m)>, int t^ w_m of the pairs' moves m
  Vector x_, force_;           ///< openings; a(m, v)
  std::vector<Opening> openings_;
  std::vector<std::vector<Condition>> conditions_;
};

/// A vertex takes the middles of its edges along by a quarter: their coefficients stay.
Tightening::Opening Tightening::opening(int number) const
{
  Opening result{{number, 1.0}};
  const Pair& pair = moves_.pairs[std::size_t(number)];
  if (!isQuadratic_ || pair.isMiddle)
    return result;
  std::set<int> taken; // an edge in space has two patches
  for (const Corner& corner : pair.corners) {
    const ContactPatch& patch = patches_[corner.patch];
    const FacetEdges edges = facetEdges(patch.dim);
    for (int e = 0; e < edges.size; ++e) {
      const auto [a, b] = edges.ends[e];
      const auto middle = moves_.index.find(patch.pairs[std::size_t(patch.dim) + std::size_t(e)]);
      if ((a != int(corner.number) && b != int(corner.number)) || middle == moves_.index.end() ||
          !taken.insert(middle->second).second)
        continue;
      const Compliance &vertex = moves_.moves[std::size_t(number)],
                       &between = moves_.moves[std::size_t(middle->second)];
      result.emplace_back(middle->second, 0.25 * vertex.gain(patch.normal) / between.gain(patch.normal));
    }
  }
  return result;
}

/// How far u^ has opened a pair already.
double Tightening::moved(int number, const std::vector<NodalField>& displacement) const
{
  const Pair& pair = moves_.pairs[std::size_t(number)];
  double along = 0.0, size = 0.0;
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t k = 0; k < moves_.dim; ++k) {
      const std::size_t dof = std::size_t(pair.node[side]) * moves_.dim + k;
      const double m = moves_.moves[std::size_t(number)].move[side][k];
      along += m * (admissible_.displacement[pair.body[side]][dof] - displacement[pair.body[side]][dof]);
      size += m * m;
    }
  return along / size;
}

/// 4 A^2 (sign +1, contact 0) and 4 R^2 (sign -1, contact 4).
double Tightening::square(double sign, double contact) const
{
  double value = bound_.distance * bound_.distance + contact * bound_.contact;
  for (std::size_t i = 0; i < x_.size(); ++i)
    value += x_[i] * (2.0 * sign * residual_[i] + force_[i] + contact * traction_[i]);
  return std::max(value, 0.0);
}

/// What an opening decides: on a straight patch the pair's own coefficient (the others stay), on one along which the
/// normal turns all that it changes.
std::vector<Tightening::Condition> Tightening::conditions(const Opening& opening) const
{
  std::vector<Condition> result;
  const auto first = std::size_t(opening.front().first);
  for (const Corner& corner : moves_.pairs[first].corners) {
    const ContactPatch& patch = patches_[corner.patch];
    const JumpCoefficients jump = pairs_.coefficients(corner.patch);
    if (!patch.turns) {
      const std::size_t own = pairs_.decided(corner).front();
      result.push_back({corner.patch, own, moves_.moves[first].gain(jump.weight(own, corner.number))});
      continue;
    }
    for (std::size_t k = 0; k < jump.size(); ++k) {
      double gain = 0.0;
      for (std::size_t node = 0; node < patch.numNodes(jump.order); ++node)
        for (const auto& [pair, amount] : opening)
          if (const auto found = moves_.index.find(patch.pairs[node]);
              found != moves_.index.end() && found->second == pair)
            gain += amount * moves_.moves[std::size_t(pair)].gain(jump.weight(k, node));
      if (gain != 0.0)
        result.push_back({corner.patch, k, gain});
    }
  }
  return result;
}

/// From the opening (below zero: closing) by which the bodies just touch to the one that closes a coefficient beside.
std::pair<double, double> Tightening::range(int number) const
{
  double least = -HUGE_VAL, most = HUGE_VAL;
  for (const Condition& condition : conditions_[std::size_t(number)]) {
    double excess = pairs_.excess(condition.patch, condition.coefficient);
    if (patches_[condition.patch].turns) // u^ is admissible: above zero it is round-off, and gains may be small
      excess = std::min(excess, 0.0);
    const double amount = excess / condition.gain;
    if (condition.gain > 0.0)
      least = std::max(least, amount);
    else
      most = std::min(most, amount);
  }
  return {least, most};
}

void Tightening::open(int number, double amount)
{
  const Pair& pair = moves_.pairs[std::size_t(number)];
  for (std::size_t side = 0; side < 2; ++side)
    for (std::size_t k = 0; k < moves_.dim; ++k)
      admissible_.displacement[pair.body[side]][std::size_t(pair.node[side]) * moves_.dim + k] +=
          amount * moves_.moves[std::size_t(number)].move[side][k];
  x_[std::size_t(number)] += amount;
  for (const auto& [j, M] : moves_.rows[std::size_t(number)])
    force_[std::size_t(j)] += M * amount;
}

/// Every unknown once to the least of (A^2 / A_0 + R^2 / R_0) / 2 >= A + R - (A_0 + R_0) / 2.
void Tightening::pass(double A, double R)
{
  for (std::size_t i = 0; i < openings_.size(); ++i) {
    double slope = 0.0, curvature = 0.0;
    for (const auto& [k, amount] : openings_[i]) {
      const auto at = std::size_t(k);
      slope += amount * ((residual_[at] + force_[at]) / A + (force_[at] - residual_[at] + 2.0 * traction_[at]) / R);
      for (const auto& [l, other] : openings_[i])
        for (const auto& [j, M] : moves_.rows[at])
          if (j == l)
            curvature += amount * other * M;
    }
    curvature *= 1.0 / A + 1.0 / R;
    const auto [least, most] = range(int(i));
    const double step = std::max(std::min(-slope / curvature, most), least);
    for (const auto& [k, amount] : openings_[i])
      open(k, step * amount);
  }
}

void Tightening::run(const std::vector<NodalField>& displacement)
{
  for (int i = 0; i < int(moves_.pairs.size()); ++i) {
    residual_.push_back(moves_.work(i, bound_.residual));
    traction_.push_back(moves_.work(i, bound_.traction));
    openings_.push_back(opening(i));
    conditions_.push_back(conditions(openings_.back()));
    x_.push_back(moved(i, displacement));
  }
  for (std::size_t i = 0; i < x_.size(); ++i)
    for (const auto& [j, M] : moves_.rows[i])
      force_[i] += M * x_[std::size_t(j)];
  double before = HUGE_VAL;
  for (int count = 0; count < mostPasses; ++count) {
    const double A = 0.5 * std::sqrt(square(1.0, 0.0)), R = 0.5 * std::sqrt(square(-1.0, 4.0));
    if (A <= 0.0 || R <= 0.0 || A + R > (1.0 - settled) * before)
      break;
    before = A + R;
    pass(A, R);
  }
}

} // namespace

void tightenDisplacement(const std::vector<const BodyModel*>& bodies,
                         const std::vector<const ConstraintSet*>& constraints, const std::vector<ContactPatch>& patches,
                         const GapBound& gap, const std::vector<NodalField>& displacement,
                         const BoundOfDisplacement& bound, AdmissibleDisplacement& admissible, const Comm& parts)
{
  Tightening(bodies, constraints, patches, gap, bound, admissible).run(displacement);
  agreeAtContact(bodies, patches, admissible, parts);
  admissible.charge = changeInEnergy(bodies, displacement, admissible.displacement, parts);
}

} // namespace ndframe
