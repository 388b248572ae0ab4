#include "mean_motions.hpp"

#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "ndframe/scene/holds.hpp"

namespace ndframe
{
namespace
{

/// Adds int u . m over one simplex as weights of the nodes' displacements.
template <int simplexDim, int order>
void addMean(Vector& weights, const NodeMap& nodes, const int* simplex, double measure, const QuadratureRule& rule,
             const RigidBasis& rigid, const Vector& motion)
{
  using Basis = Lagrange<simplexDim, order>;
  NDFRAME_ASSERT(nodes.dim <= 3, "points have three coordinates at most");
  double N[Basis::nodes];
  for (int q = 0; q < rule.size(); ++q) {
    Basis::values(rule.point(q), N);
    double x[3] = {0.0, 0.0, 0.0};
    for (int v = 0; v <= simplexDim; ++v)
      for (int k = 0; k < nodes.dim; ++k)
        x[k] += rule.point(q)[v] * nodes.point(simplex[v])[k];
    const Direction m = displacementOf(rigid, motion, x);
    for (int a = 0; a < Basis::nodes; ++a)
      for (int k = 0; k < nodes.dim; ++k)
        weights[std::size_t(simplex[a]) * std::size_t(nodes.dim) + std::size_t(k)] +=
            measure * rule.weights[std::size_t(q)] * N[a] * m[std::size_t(k)];
  }
}

template <int dim, int order>
Vector meanOver(const BodyModel& body, const Side* side, const RigidBasis& rigid, const Vector& motion)
{
  Vector weights(std::size_t(body.numDofs()), 0.0);
  const QuadratureRule rule = simplexRule(side == nullptr ? dim : dim - 1, order + 1);
  const int numCells = body.share ? body.share->numOwnCells() : body.mesh.numCells(); // the first
  if (side == nullptr)
    for (int c = 0; c < numCells; ++c)
      addMean<dim, order>(weights, body.nodes, body.nodes.cell(c), cellMeasure(body.mesh, c), rule, rigid, motion);
  else
    for (const Facet facet : side->facets) {
      if (facet.cell >= numCells)
        continue;
      int onFacet[Lagrange<dim - 1, order>::nodes];
      double normal[3];
      facetNodes(body.nodes, facet, onFacet);
      addMean<dim - 1, order>(weights, body.nodes, onFacet, facetNormal(body.mesh, facet, normal), rule, rigid, motion);
    }
  return weights;
}

} // namespace

int offsetOf(const Model& model, int body)
{
  int offset = 0;
  for (int b = 0; b < body; ++b)
    offset += model.rigid[std::size_t(b)].size();
  return offset;
}

/// Coefficients of one body in a joint motion.
Vector ofBody(const Model& model, const DenseMatrix& joint, int motion, int body)
{
  const double* first = joint.col(motion) + offsetOf(model, body);
  return {first, first + model.rigid[std::size_t(body)].size()};
}

Direction displacementOf(const RigidBasis& rigid, const Vector& motion, const double* point)
{
  Direction u{};
  for (int m = 0; m < rigid.size(); ++m) {
    const Direction mode = rigid.displacement(m, point);
    for (std::size_t k = 0; k < u.size(); ++k)
      u[k] += motion[std::size_t(m)] * mode[k];
  }
  return u;
}

/// sum_i f_i . (rigid motion at node i)
double workAlong(const BodyModel& body, const RigidBasis& rigid, const Vector& motion, const Vector& forces)
{
  double work = 0.0;
  for (int node = 0; node < body.nodes.numNodes(); ++node) {
    const Direction u = displacementOf(rigid, motion, body.nodes.point(node).data());
    for (int k = 0; k < body.mesh.dim; ++k)
      work += forces[std::size_t(node) * std::size_t(body.mesh.dim) + std::size_t(k)] * u[std::size_t(k)];
  }
  return work;
}

Vector meanWeights(const BodyModel& body, const Params& hold, const RigidBasis& rigid, const Vector& motion)
{
  const Side* side = hold.has("Side") ? body.side(hold.get<std::string>("Side")) : nullptr;
  return withDimAndOrder(body.mesh.dim, body.nodes.order,
                         [&](auto d, auto p) { return meanOver<d(), p()>(body, side, rigid, motion); });
}

void removeMeanMotions(const Model& model, std::vector<NodalField*> displacement, const Comm& comm)
{
  Vector sums; // per mean that of the displacement, and of every joint motion
  for (const HeldMean& hold : model.holds)
    for (const NodalField& weights : hold.means) {
      sums.push_back(dot(weights, *displacement[std::size_t(hold.body)]));
      for (int j = 0; j < model.jointMotions.cols(); ++j)
        sums.push_back(workAlong(model.bodies[std::size_t(hold.body)], model.rigid[std::size_t(hold.body)],
                                 ofBody(model, model.jointMotions, j, hold.body), weights));
    }
  if (sums.empty())
    return;
  if (model.told)
    comm.sum(sums);
  const std::size_t width = 1 + std::size_t(model.jointMotions.cols());
  DenseMatrix means(int(sums.size() / width), model.jointMotions.cols());
  Vector mean;
  for (int i = 0; i < means.rows(); ++i) {
    const double* const row = sums.data() + std::size_t(i) * width;
    mean.push_back(row[0]);
    for (int j = 0; j < means.cols(); ++j)
      means(i, j) = row[1 + j];
  }
  const Vector motion = multiply(model.jointMotions, multiply(pseudoInverse(means, rigidTolerance), mean));
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const double* const first = motion.data() + offsetOf(model, int(b));
    const Vector own(first, first + model.rigid[b].size());
    const NodeMap& nodes = model.bodies[b].nodes;
    for (int node = 0; largestEntry(own) > 0.0 && node < nodes.numNodes(); ++node) {
      const Direction u = displacementOf(model.rigid[b], own, nodes.point(node).data());
      for (int k = 0; k < nodes.dim; ++k)
        (*displacement[b])[std::size_t(node) * std::size_t(nodes.dim) + std::size_t(k)] -= u[std::size_t(k)];
    }
  }
}

} // namespace ndframe
