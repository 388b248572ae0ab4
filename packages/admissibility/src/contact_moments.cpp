#include "ndframe/admissibility/contact_moments.hpp"

#include <map>

#include "ndframe/admissibility/contact_nodes.hpp"
#include "ndframe/admissibility/turning_normal.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

/// 1/|f| int f(lambda) psi_i psi_j dS of the nodal functions of a facet, row-major; `extra`: the degree of f.
template <class Factor>
std::vector<double> contactMatrix(int dim, int order, int extra, const Factor& f)
{
  const QuadratureRule rule = simplexRule(dim - 1, 2 * order + extra);
  const auto nodes = std::size_t(numFacetNodes(dim, order));
  std::vector<double> matrix(nodes * nodes, 0.0);
  double N[mostFacetNodes];
  for (int g = 0; g < rule.size(); ++g) {
    facetFunctions(dim, order, rule.point(g), N);
    for (std::size_t i = 0; i < nodes; ++i)
      for (std::size_t j = 0; j < nodes; ++j)
        matrix[i * nodes + j] += rule.weights[std::size_t(g)] * f(rule.point(g)) * N[i] * N[j];
  }
  return matrix;
}

std::vector<double> facetContactMatrix(int dim, int order)
{
  return contactMatrix(dim, order, 0, [](const double*) { return 1.0; });
}

/// Those of patches along which n_c turns: the same times lambda_e, by vertex e.
std::vector<std::vector<double>> turningContactMatrices(int dim, int order)
{
  std::vector<std::vector<double>> matrices;
  for (int e = 0; e < dim; ++e)
    matrices.push_back(contactMatrix(dim, order, 1, [e](const double* lambda) { return lambda[e]; }));
  return matrices;
}

/// int n_c . w L_k on every patch of a field w(patch) given at the patch's nodes.
template <class Field>
Vector normalMoments(const std::vector<ContactPatch>& patches, int order, int degree, const Field& w)
{
  const DenseMatrix moments = facetMoments(dimOf(patches), order, degree);
  const EndTables turning = turningMoments(dimOf(patches), order, degree);
  Vector all;
  for (const ContactPatch& patch : patches) {
    const PatchVectors opening = w(patch);
    for (int k = 0; k < moments.cols(); ++k) {
      all.push_back(0.0);
      for (int i = 0; i < moments.rows(); ++i)
        if (patch.turns)
          for (std::size_t e = 0; e < turning.size(); ++e)
            all.back() += patch.measure * dotProduct(patch.ends[e], opening[std::size_t(i)]) * turning[e](i, k);
        else
          all.back() += patch.measure * dotProduct(patch.normal, opening[std::size_t(i)]) * moments(i, k);
    }
  }
  return all;
}

} // namespace

Vector jumpMoments(const std::vector<const BodyModel*>& bodies, const std::vector<ContactPatch>& patches,
                   const std::vector<NodalField>& displacement, int degree)
{
  return normalMoments(patches, bodies.front()->nodes.order, degree,
                       [&](const ContactPatch& patch) { return patchOpening(bodies, patch, displacement); });
}

Vector closingMoments(const std::vector<const BodyModel*>& bodies, const std::vector<ContactPatch>& patches,
                      const std::vector<NodalField>& displacement, int degree)
{
  return normalMoments(patches, bodies.front()->nodes.order, degree,
                       [&](const ContactPatch& patch) { return closing(bodies, patch, displacement); });
}

Vector nodalMoments(const std::vector<ContactPatch>& patches, const Vector& nodal, int order, int degree)
{
  const DenseMatrix moments = facetMoments(dimOf(patches), order, degree);
  Vector all;
  for (const ContactPatch& patch : patches)
    for (int k = 0; k < moments.cols(); ++k) {
      all.push_back(0.0);
      for (int i = 0; i < moments.rows(); ++i)
        all.back() += patch.measure * nodal[std::size_t(patch.nodes[std::size_t(i)])] * moments(i, k);
    }
  return all;
}

Vector contactForces(const BodyModel& body, int bodyIndex, const std::vector<ContactPatch>& patches,
                     const SideTractions& tractions)
{
  Vector force(std::size_t(body.numDofs()), 0.0);
  const auto dim = std::size_t(body.mesh.dim);
  const DenseMatrix moments = facetMoments(body.mesh.dim, body.nodes.order, tractions[0].degree);
  const EndTables turning = turningMoments(body.mesh.dim, body.nodes.order, tractions[0].degree);
  for (const BodyPatch& own : patchesOfBody(patches, bodyIndex)) {
    const ContactPatch& patch = patches[own.patch];
    const auto nodes = contactNodes(body, patch.sides[own.side]);
    const Vector traction = tractions[own.side].moments(int(own.patch));
    const auto add = [&](const DenseMatrix& table, const Direction& normal) {
      const Vector size = multiply(table, traction);
      for (std::size_t i = 0; i < size.size(); ++i)
        for (std::size_t k = 0; k < dim; ++k)
          force[std::size_t(nodes[i]) * dim + k] += sideSign(own.side) * size[i] * normal[k];
    };
    if (!patch.turns)
      add(moments, patch.normal);
    for (std::size_t e = 0; patch.turns && e < turning.size(); ++e)
      add(turning[e], patch.ends[e]);
  }
  return force;
}

Vector contactContributions(const std::vector<ContactPatch>& patches, const ContactTraction& traction, const Vector& w)
{
  const std::size_t modes = traction.numModes();
  Vector contributions;
  for (std::size_t f = 0; f < patches.size(); ++f) {
    const Vector t = traction.moments(int(f));
    double work = 0.0;
    for (std::size_t k = 0; k < modes; ++k)
      work += t[k] * w[f * modes + k];
    contributions.push_back(2.0 * work / patches[f].measure);
  }
  return contributions;
}

void addUnsureGap(const std::vector<ContactPatch>& patches, const ContactTraction& traction, const Vector& unsure,
                  Vector& contributions)
{
  if (unsure.empty())
    return;
  const DenseMatrix bernstein = bernsteinOfMoments(dimOf(patches), traction.degree);
  for (std::size_t f = 0; f < patches.size(); ++f)
    if (unsure[f] > 0.0)
      contributions[f] += 2.0 * unsure[f] * largestEntry(multiply(bernstein, traction.moments(int(f))));
}

SparseRow motionWork(const BodyModel& body, const Vector& motion, const std::vector<ContactPatch>& patches,
                     const std::vector<BodyPatch>& ofBody)
{
  const int dim = body.mesh.dim;
  const auto matrix = facetContactMatrix(dim, body.nodes.order);
  const auto turning = turningContactMatrices(dim, body.nodes.order);
  const auto n = std::size_t(body.nodes.nodesPerFacet);
  std::map<int, double> work;
  for (const BodyPatch& own : ofBody) {
    const ContactPatch& patch = patches[own.patch];
    const auto nodes = contactNodes(body, patch.sides[own.side]);
    const auto add = [&](const std::vector<double>& table, const Direction& normal) {
      for (std::size_t j = 0; j < n; ++j) {
        double moved = 0.0;
        for (int k = 0; k < dim; ++k)
          moved += normal[std::size_t(k)] * motion[std::size_t(nodes[j]) * std::size_t(dim) + std::size_t(k)];
        for (std::size_t i = 0; i < n; ++i)
          work[patch.nodes[i]] += sideSign(own.side) * patch.measure * table[i * n + j] * moved;
      }
    };
    if (!patch.turns)
      add(matrix, patch.normal);
    for (std::size_t e = 0; patch.turns && e < turning.size(); ++e)
      add(turning[e], patch.ends[e]);
  }
  return {work.begin(), work.end()};
}

} // namespace ndframe
