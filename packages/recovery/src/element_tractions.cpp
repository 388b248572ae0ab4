#include "element_tractions.hpp"

#include <algorithm>
#include <cmath>

#include "element_forces.hpp"
#include "ndframe/admissibility/facet_functions.hpp"

namespace ndframe
{
namespace
{

/// Nodal functions and moments on an edge:  T_k = sum_i L_k(x_i) int t phi_i  for t of the displacements' order p, and
/// int p phi_i = sum_k <phi_i, L_k> P_k  for any p; k = 0..p.
struct EdgeBasis
{
  explicit EdgeBasis(int order) : values(order + 1, order + 1), means(facetMoments(2, order, order))
  {
    const MomentBasis basis = facetBasis(2, order);
    const double nodes[3][2] = {{1.0, 0.0}, {0.0, 1.0}, {0.5, 0.5}};
    for (int i = 0; i <= order; ++i)
      basis.values(nodes[i], values.col(i));
  }
  DenseMatrix values; ///< modes x nodes: L_k(x_i)
  DenseMatrix means;  ///< nodes x modes: <phi_i, L_k>
};

/// Corrections of the tractions of one field.
class ElementBalance
{
public:
  ElementBalance(const EdgeMap& edges, const BodyModel& body, const StaticData& data, const FieldInput& field)
      : edges_(edges), mesh_(body.mesh), forces_(nodalForces(edges, body, data, *field.displacement)),
        boundary_(body.mesh, data, field.contact), basis_(data.order), tractions_(forces_.tractions.size())
  {}
  void balanceMiddles();
  void balanceVertex(const EdgeFan& fan);
  StressCorrection correction(int degree) const;

private:
  int index(int half, int node) const { return half * forces_.edgeNodes + node; }
  Force stressForce(int half, int node) const { return forces_.tractions[std::size_t(index(half, node))]; }
  Force& traction(int half, int node) { return tractions_[std::size_t(index(half, node))]; }
  Force residual(int cell, int node) const
  {
    return forces_.residual[std::size_t(cell) * 3 * std::size_t(forces_.edgeNodes - 1) + std::size_t(node)];
  }
  /// int_e (sigma~_1 n_1 + sigma~_2 n_2) phi_i; zero on the boundary.
  Force jump(int half, int node) const
  {
    return edges_.onBoundary(half) ? Force{}
                                   : stressForce(half, node) + stressForce(edges_.twin[std::size_t(half)], node);
  }
  Force prescribed(int half, int node) const;
  void setInside(int half, int node, Force flow);
  void setOnBoundary(int half, int node, Force traction);
  double weight(int half) const;
  Circulation circulation(const EdgeFan& fan) const;
  void note(double imbalance, double force)
  {
    imbalance_ = std::max(imbalance_, imbalance);
    force_ = std::max(force_, force);
  }

  const EdgeMap& edges_;
  const Mesh& mesh_;
  const ElementForces forces_;
  const BoundaryTractions boundary_;
  const EdgeBasis basis_;
  std::vector<Force> tractions_;         ///< as ElementForces::tractions: int_e t phi_i
  double imbalance_ = 0.0, force_ = 0.0; ///< largest at a node
};

Force ElementBalance::prescribed(int half, int node) const
{
  Force force;
  for (int k = 0; k < forces_.edgeNodes; ++k)
    force = force + basis_.means(node, k) * boundary_.moment(half, k);
  return force - stressForce(half, node);
}

/// flow: what the traction on the half edge is above the mean of both sides.
void ElementBalance::setInside(int half, int node, Force flow)
{
  const Force mean = -0.5 * jump(half, node);
  traction(half, node) = mean + flow;
  traction(edges_.twin[std::size_t(half)], node) = mean - flow;
}

void ElementBalance::setOnBoundary(int half, int node, Force traction)
{
  this->traction(half, node) = traction + boundary_.givenPart(half, prescribed(half, node) - traction);
}

double ElementBalance::weight(int half) const
{
  double normal[2];
  const int facet = edges_.cells[std::size_t(half / 3)].local[std::size_t(half % 3)];
  const double length = facetNormal(mesh_, {half / 3, facet}, normal);
  return 1.0 / (length * length);
}

void ElementBalance::balanceMiddles()
{
  for (int half = 0; forces_.edgeNodes == 3 && half < int(edges_.twin.size()); ++half) {
    const Force own = residual(half / 3, 3 + half % 3);
    const int twin = edges_.twin[std::size_t(half)];
    if (edges_.onBoundary(half)) {
      note(norm(boundary_.givenPart(half, own - prescribed(half, 2))), norm(own) + norm(stressForce(half, 2)));
      setOnBoundary(half, 2, own);
    } else if (half < twin) {
      const Force other = residual(twin / 3, 3 + twin % 3);
      note(norm(own + other + jump(half, 2)), norm(own) + norm(other) + norm(stressForce(half, 2)));
      setInside(half, 2, 0.5 * (own - other));
    }
  }
}

/// The flow through an edge is the traction above the mean of both sides on the cell that is left there: t = - jump/2 +
/// d, on the cell that is entered t = - jump/2 - d. A cell's balance relates the flows through its two edges.
Circulation ElementBalance::circulation(const EdgeFan& fan) const
{
  Circulation problem;
  problem.closed = fan.closed;
  for (const FanCell& at : fan.cells) {
    const Force jumps = jump(at.in, placeOnEdge(at.in, at.corner)) + jump(at.out, placeOnEdge(at.out, at.corner));
    problem.steps.push_back(residual(at.cell, at.corner) + 0.5 * jumps);
    problem.weights.push_back(weight(at.in));
  }
  if (fan.closed)
    return problem;
  const FanCell &first = fan.cells.front(), &last = fan.cells.back();
  problem.weights.push_back(weight(last.out));
  for (const Force n : boundary_.given(first.in))
    problem.atFirst.push_back({n, -dot(n, prescribed(first.in, placeOnEdge(first.in, first.corner)))});
  for (const Force n : boundary_.given(last.out))
    problem.atLast.push_back({n, dot(n, prescribed(last.out, placeOnEdge(last.out, last.corner)))});
  return problem;
}

void ElementBalance::balanceVertex(const EdgeFan& fan)
{
  const Flows flows = leastFlows(circulation(fan));
  double forces = 0.0;
  for (std::size_t k = 0; k < fan.cells.size(); ++k) {
    const FanCell& at = fan.cells[k];
    const int in = placeOnEdge(at.in, at.corner), out = placeOnEdge(at.out, at.corner);
    forces += norm(residual(at.cell, at.corner)) + norm(stressForce(at.in, in)) + norm(stressForce(at.out, out));
    if (edges_.onBoundary(at.in))
      setOnBoundary(at.in, in, -1.0 * flows.flow[k]);
    if (edges_.onBoundary(at.out))
      setOnBoundary(at.out, out, flows.flow[k + 1]);
    else
      setInside(at.out, out, flows.flow[k + 1]);
  }
  note(flows.defect, forces);
}

StressCorrection ElementBalance::correction(int degree) const
{
  const int modes = degree + 1, nodes = forces_.edgeNodes;
  StressCorrection result;
  result.dim = 2;
  result.degree = degree;
  result.loads = forces_.loads;
  result.imbalance = imbalance_;
  result.force = force_;
  result.tractions.reserve(edges_.twin.size() * 2 * std::size_t(modes));
  for (int half = 0; half < int(edges_.twin.size()); ++half)
    for (int k = 0; k < modes; ++k) {
      Force moment;
      for (int i = 0; k < nodes && i < nodes; ++i)
        moment = moment + basis_.values(k, i) * tractions_[std::size_t(index(half, i))];
      if (k >= nodes && edges_.onBoundary(half))
        moment = boundary_.givenPart(half, boundary_.moment(half, k));
      result.tractions.insert(result.tractions.end(), {moment.x, moment.y});
    }
  return result;
}

} // namespace

StressCorrection equilibrateElements(const EdgeMap& edges, const BodyModel& body, const StaticData& data,
                                     const FieldInput& field)
{
  ElementBalance balance(edges, body, data, field);
  balance.balanceMiddles();
  for (int vertex = 0; vertex < body.mesh.numPoints(); ++vertex)
    balance.balanceVertex(fanAround(edges, vertex));
  return balance.correction(data.degree);
}

} // namespace ndframe
