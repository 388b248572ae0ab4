#include "rank_problem.hpp"

#include <algorithm>

#include "ndframe/algebra/shared_values.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

using Global = IndexMap::Global;

/// Axes of nodes that have some, by numbers of all nodes.
const double* axesOf(const EdgeNodes& nodes, int node, int dim)
{
  const auto found = std::lower_bound(nodes.turned.begin(), nodes.turned.end(), node);
  return found == nodes.turned.end() || *found != node ? nullptr
                                                       : nodes.axes.data() + (found - nodes.turned.begin()) * dim * dim;
}

void takeEdges(const EdgeNodes& edges, RankProblem& problem)
{
  const BlockMatrix& K = *problem.matrix;
  std::vector<char> isNear(std::size_t(K.nodes.size()), 0);
  problem.ends.reserve(std::size_t(K.numRows()));
  for (int r = 0; r < K.numRows(); ++r) {
    const auto& [a, b] = edges.ends[std::size_t(K.rowNode(r))];
    problem.ends.push_back({K.nodes.local(a), K.nodes.local(b)});
    isNear[std::size_t(r)] = 1;
    for (const int end : problem.ends.back()) {
      NDFRAME_ASSERT(end >= 0, "an end of an edge is no column of its middle's row");
      isNear[std::size_t(end)] = 1;
    }
  }
  for (int node = 0; node < K.nodes.size() && !edges.turned.empty(); ++node)
    if (const double* axes = isNear[std::size_t(node)] ? axesOf(edges, int(K.nodes.global(node)), K.dim) : nullptr) {
      problem.turned.push_back(node);
      problem.axes.insert(problem.axes.end(), axes, axes + std::ptrdiff_t(K.dim) * K.dim);
    }
  for (const Global dof : problem.kept) {
    const auto& [a, b] = edges.ends[std::size_t(dof / K.dim)];
    problem.keptEnds.push_back({a, b});
  }
}

/// Own vertices among own nodes.
std::vector<int> ownVertices(const RankProblem& problem)
{
  std::vector<int> rows;
  for (int r = 0; r < problem.matrix->numRows(); ++r)
    if (problem.isVertex(r))
      rows.push_back(r);
  return rows;
}

/// Values at the vertices of all ranks from those of each, zero elsewhere. Collective.
Vector atVertices(const RankProblem& problem, const double* own, const Comm& comm)
{
  const BlockMatrix& K = *problem.matrix;
  Vector all(std::size_t(K.numDofs()), 0.0);
  for (const int r : ownVertices(problem)) {
    std::copy_n(own, K.dim, all.begin() + std::ptrdiff_t(K.rowNode(r)) * K.dim);
    own += K.dim;
  }
  comm.sum(all);
  return all;
}

/// Fills in the middles of edges. edges: without turned nodes where the values are coordinates.
void interpolate(const EdgeNodes& edges, int dim, Vector& values)
{
  const auto entry = [dim](const double* axes, int i, int k) { return axes ? axes[i * dim + k] : double(i == k); };
  for (std::size_t node = 0; node < edges.ends.size(); ++node) {
    if (edges.ends[node][0] == edges.ends[node][1])
      continue;
    const double* middle = axesOf(edges, int(node), dim);
    double* const value = values.data() + std::ptrdiff_t(node) * dim;
    std::fill_n(value, dim, 0.0);
    for (const int end : edges.ends[node]) {
      const double *axes = axesOf(edges, end, dim), *given = values.data() + std::ptrdiff_t(end) * dim;
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j) {
          double cosine = 0.0;
          for (int k = 0; k < dim; ++k)
            cosine += entry(middle, i, k) * entry(axes, j, k);
          value[i] += 0.5 * cosine * given[j];
        }
    }
  }
}

std::vector<DofRole> rolesOfAll(const RankProblem& problem, const Comm& comm)
{
  const BlockMatrix& K = *problem.matrix;
  Vector all(std::size_t(K.numDofs()), 0.0);
  for (int r = 0; r < K.numRows(); ++r)
    for (int i = 0; i < K.dim; ++i)
      all[std::size_t(K.rowNode(r)) * std::size_t(K.dim) + std::size_t(i)] = double(problem.role(r, i));
  comm.sum(all);
  std::vector<DofRole> roles;
  for (const double role : all)
    roles.push_back(DofRole(int(role)));
  return roles;
}

EdgeNodes edgesOfAll(const RankProblem& problem, const Comm& comm)
{
  const BlockMatrix& K = *problem.matrix;
  const int size = K.dim * K.dim;
  EdgeNodes edges;
  Vector ends(2 * std::size_t(K.numNodes()), 0.0), own;
  for (int r = 0; r < K.numRows(); ++r)
    for (std::size_t e = 0; e < 2; ++e)
      ends[2 * std::size_t(K.rowNode(r)) + e] = double(K.nodes.global(problem.ends[std::size_t(r)][e]));
  comm.sum(ends);
  for (std::size_t node = 0; 2 * node < ends.size(); ++node)
    edges.ends.push_back({int(ends[2 * node]), int(ends[2 * node + 1])});
  for (std::size_t t = 0; t < problem.turned.size(); ++t)
    if (K.nodes.owns(problem.turned[t])) {
      own.push_back(double(K.nodes.global(problem.turned[t])));
      own.insert(own.end(), problem.axes.begin() + std::ptrdiff_t(t) * size,
                 problem.axes.begin() + std::ptrdiff_t(t + 1) * size);
    }
  const Vector all = gatheredFrom(own, comm);
  std::vector<std::pair<int, const double*>> turned;
  for (std::size_t t = 0; t < all.size(); t += std::size_t(size) + 1)
    turned.emplace_back(int(all[t]), all.data() + t + 1);
  std::sort(turned.begin(), turned.end());
  for (const auto& [node, axes] : turned) {
    edges.turned.push_back(node);
    edges.axes.insert(edges.axes.end(), axes, axes + size);
  }
  return edges;
}

} // namespace

RankProblem heldPart(const SolverProblem& given, bool hasEdges)
{
  RankProblem problem;
  const BlockMatrix& K = *(problem.matrix = given.matrix);
  const auto dim = std::size_t(K.dim);
  problem.roles.reserve(std::size_t(K.nodes.size()) * dim);
  for (int node = 0; node < K.nodes.size(); ++node) {
    const auto first = given.roles.begin() + std::ptrdiff_t(K.nodes.global(node)) * K.dim;
    problem.roles.insert(problem.roles.end(), first, first + K.dim);
  }
  problem.kept.assign(given.kept.begin(), given.kept.end());
  problem.outline = given.outline;
  if (hasEdges)
    takeEdges(given.edgeNodes, problem);
  const std::vector<int> vertices = ownVertices(problem);
  const int modes = given.nearNullSpace.cols();
  problem.nearNullSpace = DenseMatrix(modes == 0 ? 0 : int(vertices.size() * dim), modes);
  for (int m = 0; m < modes; ++m)
    for (std::size_t v = 0; v < vertices.size(); ++v)
      std::copy_n(given.nearNullSpace.col(m) + std::ptrdiff_t(K.rowNode(vertices[v])) * K.dim, K.dim,
                  problem.nearNullSpace.col(m) + v * dim);
  for (std::size_t v = 0; v < vertices.size() && !given.nodePoints.empty(); ++v) {
    const auto first = given.nodePoints.begin() + std::ptrdiff_t(K.rowNode(vertices[v])) * K.dim;
    problem.nodePoints.insert(problem.nodePoints.end(), first, first + K.dim);
  }
  return problem;
}

RankProblem withKeptDofsAs(DofRole role, RankProblem problem)
{
  for (const RankProblem::Global kept : problem.kept)
    if (const int dof = problem.held(kept); dof >= 0)
      problem.roles[std::size_t(dof)] = role;
  return problem;
}

SolverProblem onAllRanks(const RankProblem& given, const Comm& comm)
{
  const BlockMatrix& K = *given.matrix;
  SolverProblem problem;
  problem.matrix = &K;
  problem.roles = rolesOfAll(given, comm);
  for (const Global dof : given.kept)
    problem.kept.push_back(int(dof));
  problem.outline = given.outline;
  Vector has{double(!given.ends.empty()), double(!given.nodePoints.empty())}; // a rank may have no nodes
  takeLargest(has, comm);
  if (has[0] > 0.0)
    problem.edgeNodes = edgesOfAll(given, comm);
  const int modes = given.nearNullSpace.cols();
  problem.nearNullSpace = DenseMatrix(modes == 0 ? 0 : K.numDofs(), modes);
  for (int m = 0; m < modes; ++m) {
    Vector mode = atVertices(given, given.nearNullSpace.col(m), comm);
    interpolate(problem.edgeNodes, K.dim, mode);
    std::copy(mode.begin(), mode.end(), problem.nearNullSpace.col(m));
  }
  if (has[1] > 0.0) {
    problem.nodePoints = atVertices(given, given.nodePoints.data(), comm);
    interpolate({problem.edgeNodes.ends, {}, {}}, K.dim, problem.nodePoints);
  }
  return problem;
}

} // namespace ndframe
