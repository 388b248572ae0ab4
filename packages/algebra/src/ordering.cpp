#include "ordering.hpp"

#include <algorithm>
#include <limits>
#include <mutex>
#include <new>

#include <metis.h>

#include "dominated_vertices.hpp"
#include "mpi_comm.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{

namespace
{

using Indices = std::vector<idx_t>;

/// METIS draws from the random numbers of the whole process, which it seeds at every call: while two threads order at
/// the same time, both get other orders in every run.
std::mutex metisIsBusy;

/// The nodes that have interior dofs, numbered in ascending order.
struct InteriorNodes
{
  std::vector<int> nodes;
  std::vector<int> number; ///< -1 for other nodes
};

/// Rows of the interior nodes' graph, without loops.
struct GraphRows
{
  Indices vertices; ///< the vertex of each row
  Indices degrees;
  Indices neighbours; ///< of all rows, one after the other
};

InteriorNodes findInteriorNodes(const SolverProblem& problem)
{
  const int dim = problem.matrix->dim, numNodes = problem.matrix->numNodes();
  InteriorNodes interior;
  interior.number.assign(std::size_t(numNodes), -1);
  for (int node = 0; node < numNodes; ++node) {
    const auto first = problem.roles.begin() + std::ptrdiff_t(node) * dim;
    if (std::find(first, first + dim, DofRole::Interior) == first + dim)
      continue;
    interior.number[std::size_t(node)] = int(interior.nodes.size());
    interior.nodes.push_back(node);
  }
  return interior;
}

GraphRows ownRows(const BlockMatrix& K, const InteriorNodes& interior)
{
  GraphRows graph;
  graph.neighbours.reserve(K.cols.size());
  for (int r = 0; r < K.numRows(); ++r) {
    const int vertex = interior.number[std::size_t(K.rowNode(r))];
    if (vertex < 0)
      continue;
    const std::size_t before = graph.neighbours.size();
    for (std::int64_t b = K.rowPtr[std::size_t(r)]; b < K.rowPtr[std::size_t(r) + 1]; ++b) {
      const int neighbour = interior.number[std::size_t(K.colNode(b))];
      if (neighbour >= 0 && neighbour != vertex)
        graph.neighbours.push_back(neighbour);
    }
    std::sort(graph.neighbours.begin() + std::ptrdiff_t(before), graph.neighbours.end()); // as on one rank
    graph.vertices.push_back(vertex);
    graph.degrees.push_back(idx_t(graph.neighbours.size() - before));
  }
  return graph;
}

/// The ranks' pieces, one after the other, on rank 0.
Indices gathered(const Indices& piece, const Comm& comm)
{
  const int length = int(piece.size());
  std::vector<int> lengths(std::size_t(comm.size())), starts(std::size_t(comm.size()) + 1, 0);
  MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, mpiComm(comm));
  std::int64_t total = 0;
  for (std::size_t rank = 0; rank < lengths.size(); ++rank) {
    total += lengths[rank];
    starts[rank + 1] = int(total);
  }
  NDFRAME_ASSERT(total <= std::numeric_limits<int>::max(), "the graph is too large for MPI_Gatherv");
  Indices all(std::size_t(comm.rank() == 0 ? total : 0));
  static_assert(sizeof(idx_t) == sizeof(int), "METIS must use 32-bit integers");
  MPI_Gatherv(piece.data(), length, MPI_INT, all.data(), lengths.data(), starts.data(), MPI_INT, 0, mpiComm(comm));
  return all;
}

/// Rank 0 gets the rows of all ranks, the others none.
GraphRows gathered(GraphRows own, const Comm& comm)
{
  if (comm.size() == 1)
    return own;
  return {gathered(own.vertices, comm), gathered(own.degrees, comm), gathered(own.neighbours, comm)};
}

/// METIS's arrays from rows in any order.
NodeGraph sortedByVertex(GraphRows rows, std::vector<int> nodes)
{
  const std::size_t numVertices = nodes.size();
  NDFRAME_ASSERT(rows.vertices.size() == numVertices, "every node must be owned by one rank");
  NodeGraph graph{std::move(nodes), Indices(numVertices + 1, 0), {}, {}};
  for (std::size_t r = 0; r < numVertices; ++r)
    graph.starts[std::size_t(rows.vertices[r]) + 1] = rows.degrees[r];
  for (std::size_t v = 0; v < numVertices; ++v)
    graph.starts[v + 1] += graph.starts[v];
  if (std::is_sorted(rows.vertices.begin(), rows.vertices.end())) {
    graph.neighbours = std::move(rows.neighbours);
    return graph;
  }
  graph.neighbours.resize(rows.neighbours.size());
  auto next = rows.neighbours.begin();
  for (std::size_t r = 0; r < numVertices; ++r) {
    std::copy_n(next, rows.degrees[r], graph.neighbours.begin() + graph.starts[std::size_t(rows.vertices[r])]);
    next += rows.degrees[r];
  }
  return graph;
}

} // namespace

NodeGraph interiorGraph(const SolverProblem& problem, const Comm& comm)
{
  InteriorNodes interior = findInteriorNodes(problem);
  GraphRows rows = gathered(ownRows(*problem.matrix, interior), comm);
  return comm.rank() == 0 ? sortedByVertex(std::move(rows), std::move(interior.nodes)) : NodeGraph{};
}

std::vector<int> nestedDissection(NodeGraph graph)
{
  const std::size_t size = graph.nodes.size();
  Indices vertexAt(size), position(size), options(METIS_NOPTIONS);
  if (size == 0)
    return vertexAt;
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_NUMBERING] = 0;
  idx_t numVertices = idx_t(size);
  const std::lock_guard<std::mutex> alone(metisIsBusy);
  const int status = METIS_NodeND(&numVertices, graph.starts.data(), graph.neighbours.data(),
                                  graph.weights.empty() ? nullptr : graph.weights.data(), options.data(),
                                  vertexAt.data(), position.data());
  if (status == METIS_ERROR_MEMORY)
    throw std::bad_alloc();
  NDFRAME_ASSERT(status == METIS_OK, "METIS_NodeND failed");
  for (int& vertex : vertexAt)
    vertex = graph.nodes[std::size_t(vertex)];
  return vertexAt;
}

std::vector<int> reducedDissection(const NodeGraph& graph)
{
  const DominatedVertices dominated(graph);
  std::vector<int> order = dominated.insertedInto(nestedDissection(dominated.rest(graph)));
  for (int& vertex : order)
    vertex = graph.nodes[std::size_t(vertex)];
  return order;
}

std::vector<int> freeOrder(const SolverProblem& problem, const FreeDofs& free, const std::vector<int>& nodes)
{
  const int dim = problem.matrix->dim;
  std::vector<int> order;
  order.reserve(free.dofs.size());
  for (const int node : nodes)
    for (int dof = node * dim; dof < (node + 1) * dim; ++dof)
      if (problem.roles[std::size_t(dof)] == DofRole::Interior)
        order.push_back(free.number[std::size_t(dof)]);
  for (const int dof : problem.kept)
    order.push_back(free.number[std::size_t(dof)]);
  return order;
}

std::vector<int> eliminationOrder(const SolverProblem& problem, const FreeDofs& free, const Comm& comm, Ledger& ledger)
{
  const auto timer = ledger.time("order");
  const NodeGraph graph = interiorGraph(problem, comm);
  return comm.rank() == 0 ? freeOrder(problem, free, reducedDissection(graph)) : std::vector<int>{};
}

} // namespace ndframe
