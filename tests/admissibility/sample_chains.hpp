#pragma once

#include <random>

#include "ndframe/admissibility/admissible_traction.hpp"

namespace ndframe::test
{

/// Contact facets without bodies: chains of edges with numbers as bodies would give them.
struct Chain
{
  std::vector<ContactPatch> patches;
  std::vector<double> x; ///< per node: arc length
  int order = 0;

  int numNodes() const { return int(x.size()); }
};

/// An open chain on the line y = 0 seen from above (n_c = (0, -1)), edges of these lengths, numbered from left to
/// right.
Chain straightChain(const std::vector<double>& lengths, int order);
/// The same edges closed to a ring.
Chain closedChain(const std::vector<double>& lengths, int order);
/// Both, one after the other, without a common node.
Chain disjoint(const Chain& first, const Chain& second);
/// Nodes and facets in another order, some facets from their other end.
Chain shuffled(const Chain& chain, std::mt19937& random, std::vector<int>& newNumber);

/// Open and closed chains of order 1 and 2, both together in random order, and a single facet.
std::vector<Chain> sampleChains(std::mt19937& random);
/// `count` lengths between 0.1 and 1.
std::vector<double> randomLengths(int count, std::mt19937& random);

/// t at lambda (from the facet's first vertex 0 to its second 1) of a traction given by nodal values or by moments.
double valueAt(const ContactPatch& patch, const Vector& nodal, int order, double lambda);
double valueAt(const ContactPatch& patch, const ContactTraction& traction, int number, double lambda);

/// int s t dS of two nodal fields.
double innerProduct(const Chain& chain, const Vector& s, const Vector& t);

/// Resultant and moment about x = 0 of a normal traction on a straight chain.
BalanceConditions resultantAndMoment(const Chain& chain, double force, double moment);

/// Nodal values of a traction whose Bernstein coefficients are <= 0.
Vector admissibleNodes(const Chain& chain, std::mt19937& random);
Vector randomNodes(int numNodes, std::mt19937& random);

} // namespace ndframe::test
