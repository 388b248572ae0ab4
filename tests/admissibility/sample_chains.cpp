#include "sample_chains.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe::test
{

namespace
{

/// Vertices first, then the middles, so that the middles are far from their ends in number.
Chain makeChain(const std::vector<double>& lengths, int order, bool closed)
{
  const int edges = int(lengths.size()), vertices = closed ? edges : edges + 1;
  Chain chain;
  chain.order = order;
  chain.x.assign(std::size_t(vertices + (order == 2 ? edges : 0)), 0.0);
  double start = 0.0;
  for (int e = 0; e < edges; ++e) {
    const double length = lengths[std::size_t(e)];
    ContactPatch patch;
    patch.sides[1].body = 1;
    patch.normal = {0.0, -1.0, 0.0};
    patch.measure = length;
    patch.nodes = {e, (e + 1) % vertices, order == 2 ? vertices + e : 0};
    chain.x[std::size_t(e)] = start;
    if (order == 2)
      chain.x[std::size_t(vertices + e)] = start + 0.5 * length;
    start += length;
    if (!closed)
      chain.x[std::size_t(e + 1)] = start;
    chain.patches.push_back(patch);
  }
  return chain;
}

void nodalFunctions(int order, double lambda, double* N)
{
  const double barycentric[2] = {1.0 - lambda, lambda};
  if (order == 1)
    Lagrange<1, 1>::values(barycentric, N);
  else
    Lagrange<1, 2>::values(barycentric, N);
}

} // namespace

Chain straightChain(const std::vector<double>& lengths, int order)
{
  return makeChain(lengths, order, false);
}

Chain closedChain(const std::vector<double>& lengths, int order)
{
  return makeChain(lengths, order, true);
}

Chain disjoint(const Chain& first, const Chain& second)
{
  Chain both = first;
  both.x.insert(both.x.end(), second.x.begin(), second.x.end());
  for (ContactPatch patch : second.patches) {
    for (int i = 0; i <= second.order; ++i)
      patch.nodes[std::size_t(i)] += first.numNodes();
    both.patches.push_back(patch);
  }
  return both;
}

Chain shuffled(const Chain& chain, std::mt19937& random, std::vector<int>& newNumber)
{
  newNumber.resize(chain.x.size());
  std::iota(newNumber.begin(), newNumber.end(), 0);
  std::shuffle(newNumber.begin(), newNumber.end(), random);
  Chain other = chain;
  for (std::size_t node = 0; node < chain.x.size(); ++node)
    other.x[std::size_t(newNumber[node])] = chain.x[node];
  for (ContactPatch& patch : other.patches) {
    for (int i = 0; i <= chain.order; ++i)
      patch.nodes[std::size_t(i)] = newNumber[std::size_t(patch.nodes[std::size_t(i)])];
    if (random() % 2 == 0)
      std::swap(patch.nodes[0], patch.nodes[1]);
  }
  std::shuffle(other.patches.begin(), other.patches.end(), random);
  return other;
}

std::vector<Chain> sampleChains(std::mt19937& random)
{
  std::vector<Chain> chains;
  for (const int order : {1, 2}) {
    const Chain open = straightChain(randomLengths(9, random), order);
    const Chain ring = closedChain(randomLengths(6, random), order);
    std::vector<int> numbers;
    chains.push_back(open);
    chains.push_back(ring);
    chains.push_back(shuffled(disjoint(open, ring), random, numbers));
    chains.push_back(straightChain({2.0}, order));
  }
  return chains;
}

std::vector<double> randomLengths(int count, std::mt19937& random)
{
  std::uniform_real_distribution<double> length(0.1, 1.0);
  std::vector<double> lengths;
  for (int i = 0; i < count; ++i)
    lengths.push_back(length(random));
  return lengths;
}

double valueAt(const ContactPatch& patch, const Vector& nodal, int order, double lambda)
{
  double N[3], value = 0.0;
  nodalFunctions(order, lambda, N);
  for (int i = 0; i <= order; ++i)
    value += N[i] * nodal[std::size_t(patch.nodes[std::size_t(i)])];
  return value;
}

double valueAt(const ContactPatch& patch, const ContactTraction& traction, int number, double lambda)
{
  const double barycentric[2] = {1.0 - lambda, lambda};
  const Vector moments = traction.moments(number);
  Vector L(moments.size());
  facetBasis(2, traction.degree).values(barycentric, L.data());
  return std::inner_product(L.begin(), L.end(), moments.begin(), 0.0) / patch.measure;
}

double innerProduct(const Chain& chain, const Vector& s, const Vector& t)
{
  const QuadratureRule rule = simplexRule(1, 4);
  double sum = 0.0;
  for (const ContactPatch& patch : chain.patches)
    for (int q = 0; q < rule.size(); ++q)
      sum += patch.measure * rule.weights[std::size_t(q)] * valueAt(patch, s, chain.order, rule.point(q)[1]) *
             valueAt(patch, t, chain.order, rule.point(q)[1]);
  return sum;
}

BalanceConditions resultantAndMoment(const Chain& chain, double force, double moment)
{
  const auto n = chain.x.size();
  BalanceConditions balance{SparseColumns(int(n), 2), {force, moment}, {}, {"translation", "rotation"}};
  for (std::size_t node = 0; node < n; ++node) {
    Vector unit(n, 0.0);
    unit[node] = 1.0;
    balance.work(int(node), 0) = innerProduct(chain, unit, Vector(n, 1.0));
    balance.work(int(node), 1) = innerProduct(chain, unit, chain.x);
  }
  return balance;
}

Vector admissibleNodes(const Chain& chain, std::mt19937& random)
{
  std::uniform_real_distribution<double> value(-1.0, 0.3);
  Vector t;
  for (std::size_t i = 0; i < chain.x.size(); ++i)
    t.push_back(std::min(value(random), 0.0));
  for (const ContactPatch& patch : chain.patches)
    if (chain.order == 2) {
      double& middle = t[std::size_t(patch.nodes[2])];
      middle = 0.5 * middle + 0.25 * (t[std::size_t(patch.nodes[0])] + t[std::size_t(patch.nodes[1])]);
    }
  return t;
}

Vector randomNodes(int numNodes, std::mt19937& random)
{
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  Vector t;
  for (int i = 0; i < numNodes; ++i)
    t.push_back(value(random));
  return t;
}

} // namespace ndframe::test
