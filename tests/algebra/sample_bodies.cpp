#include "algebra/sample_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "ndframe/base/deck.hpp"
#include "ndframe/iterative/linear_solvers.hpp"

namespace ndframe::test
{

namespace
{

using Blocks = std::map<std::pair<int, int>, std::vector<double>>;

/// Numbers a grid of (cells + 1) points per direction, the first direction fastest.
struct Grid
{
  std::vector<int> cells;

  int dim() const { return int(cells.size()); }
  int numNodes() const
  {
    int n = 1;
    for (const int c : cells)
      n *= c + 1;
    return n;
  }
  int node(const std::vector<int>& index) const
  {
    int number = 0;
    for (int i = dim() - 1; i >= 0; --i)
      number = number * (cells[std::size_t(i)] + 1) + index[std::size_t(i)];
    return number;
  }
  std::vector<int> index(int node) const
  {
    std::vector<int> result;
    for (const int c : cells) {
      result.push_back(node % (c + 1));
      node /= c + 1;
    }
    return result;
  }
  /// Nodes of the cell whose first corner has this index; empty at the far end of the grid.
  std::vector<int> cellNodes(const std::vector<int>& first) const
  {
    for (int i = 0; i < dim(); ++i)
      if (first[std::size_t(i)] == cells[std::size_t(i)])
        return {};
    std::vector<int> nodes;
    for (int corner = 0; corner < (1 << dim()); ++corner) {
      std::vector<int> at = first;
      for (int i = 0; i < dim(); ++i)
        at[std::size_t(i)] += (corner >> i) & 1;
      nodes.push_back(node(at));
    }
    return nodes;
  }
};

void addBar(int a, int b, double stiffness, const std::vector<double>& points, int dim, Blocks& blocks)
{
  std::vector<double> d;
  double length2 = 0.0;
  for (int i = 0; i < dim; ++i) {
    d.push_back(points[std::size_t(b * dim + i)] - points[std::size_t(a * dim + i)]);
    length2 += d.back() * d.back();
  }
  const std::pair<int, int> ends[] = {{a, a}, {a, b}, {b, a}, {b, b}};
  for (const auto& end : ends) {
    auto& block = blocks[end];
    block.resize(std::size_t(dim * dim), 0.0);
    const double sign = end.first == end.second ? 1.0 : -1.0;
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < dim; ++j)
        block[std::size_t(i * dim + j)] += sign * stiffness * d[std::size_t(i)] * d[std::size_t(j)] / length2;
  }
}

BlockMatrix ownRows(const Blocks& blocks, int dim, int numNodes, const Comm& comm)
{
  std::vector<int> rows, cols;
  std::vector<double> values;
  std::vector<std::int64_t> rowPtr{0};
  for (int node = 0; node < numNodes; ++node) {
    if ((node / 3) % comm.size() != comm.rank())
      continue;
    rows.push_back(node);
    for (auto block = blocks.lower_bound({node, 0}); block != blocks.end() && block->first.first == node; ++block) {
      cols.push_back(block->first.second);
      values.insert(values.end(), block->second.begin(), block->second.end());
    }
    rowPtr.push_back(std::int64_t(cols.size()));
  }
  return withOwnColumns(dim, numNodes, rows, std::move(rowPtr), std::move(cols), std::move(values));
}

DenseMatrix rigidMotionsOf(const std::vector<double>& points, int dim)
{
  const int numNodes = int(points.size()) / dim;
  DenseMatrix modes(dim * numNodes, dim * (dim + 1) / 2);
  for (int node = 0; node < numNodes; ++node) {
    int mode = 0;
    for (; mode < dim; ++mode)
      modes(node * dim + mode, mode) = 1.0;
    for (int i = 0; i < dim; ++i)
      for (int j = i + 1; j < dim; ++j, ++mode) {
        modes(node * dim + i, mode) = -points[std::size_t(node * dim + j)];
        modes(node * dim + j, mode) = points[std::size_t(node * dim + i)];
      }
  }
  return modes;
}

DeckList solverDeck(const std::string& type, const std::string& xml)
{
  return parseDeck("<ParameterList>\n<Parameter name=\"Type\" type=\"string\" value=\"" + type + "\"/>\n" + xml +
                       "\n</ParameterList>",
                   "deck");
}

Registry<LinearSolver> solvers()
{
  Registry<LinearSolver> registry("linear solver", "Automatic");
  registerLinearSolvers(registry);
  return registry;
}

Params solverParams(const std::string& type, const std::string& xml)
{
  ListSpec spec;
  spec.name = "Linear Solver";
  spec.choices = solvers().choices();
  Diagnostics diagnostics;
  const Params params = validate(solverDeck(type, xml), spec, diagnostics);
  diagnostics.throwIfAny();
  return params;
}

} // namespace

SampleBody trussBody(std::vector<int> cells, const Comm& comm, double stiffness, double length)
{
  const Grid grid{cells};
  const int dim = grid.dim();
  SampleBody body;
  body.cells = std::move(cells);
  for (int node = 0; node < grid.numNodes(); ++node)
    for (const int i : grid.index(node))
      body.points.push_back(length * i);
  std::mt19937 random(7);
  Blocks blocks;
  for (int first = 0; first < grid.numNodes(); ++first) {
    const std::vector<int> nodes = grid.cellNodes(grid.index(first));
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t b = a + 1; b < nodes.size(); ++b)
        addBar(nodes[a], nodes[b], stiffness * (1.0 + double(random() % 1000) / 1000.0), body.points, dim, blocks);
  }
  body.matrix = ownRows(blocks, dim, grid.numNodes(), comm);
  body.rigidMotions = rigidMotionsOf(body.points, dim);
  return body;
}

SolverProblem SampleBody::problemWithoutKept(Support support) const
{
  const Grid grid{cells};
  const int dim = matrix.dim;
  std::vector<int> fixed;
  for (int node = 0; node < matrix.numNodes(); ++node) {
    const std::vector<int> index = grid.index(node);
    if (support == Support::Guide && index.front() == 0)
      for (int i = 0; i < dim - 1; ++i)
        fixed.push_back(node * dim + i);
    if (support == Support::Clamp && index.back() == 0)
      for (int i = 0; i < dim; ++i)
        fixed.push_back(node * dim + i);
  }
  SolverProblem problem = problemWith(matrix, {}, fixed);
  problem.nearNullSpace = rigidMotions;
  problem.nodePoints = points;
  problem.edgeNodes = edgeNodes();
  return problem;
}

EdgeNodes SampleBody::edgeNodes() const
{
  EdgeNodes result;
  if (std::any_of(cells.begin(), cells.end(), [](int c) { return c % 2 != 0; }))
    return result;
  const Grid grid{cells};
  for (int node = 0; node < grid.numNodes(); ++node) {
    std::vector<int> before = grid.index(node), after = before;
    for (std::size_t i = 0; i < before.size(); ++i) {
      after[i] += before[i] % 2;
      before[i] -= before[i] % 2;
    }
    result.ends.push_back({grid.node(before), grid.node(after)});
  }
  return result;
}

SolverProblem SampleBody::problem(Support support) const
{
  const Grid grid{cells};
  SolverProblem problem = problemWithoutKept(support);
  const int firstKept = support == Support::None ? 0 : matrix.dim - 1;
  for (int node = matrix.numNodes() - 1; node >= 0; --node)
    for (int i = firstKept; i < matrix.dim && grid.index(node).back() == cells.back(); ++i) {
      const int dof = node * matrix.dim + i;
      problem.roles[std::size_t(dof)] = DofRole::Kept;
      problem.kept.push_back(dof);
    }
  return problem;
}

void turnNodes(SampleBody& body, SolverProblem& problem, const std::vector<int>& chosen)
{
  const int dim = body.matrix.dim;
  DenseMatrix Q(body.matrix.numDofs(), dim); // of all nodes, one above the other
  for (int node = 0; node < body.matrix.numNodes(); ++node) {
    const bool isTurned = std::find(chosen.begin(), chosen.end(), node) != chosen.end();
    const double angle = isTurned ? 0.3 + 0.1 * node : 0.0;
    for (int i = 0; i < dim; ++i)
      Q(node * dim + i, i) = i < 2 ? std::cos(angle) : 1.0;
    Q(node * dim, 1) = std::sin(angle);
    Q(node * dim + 1, 0) = -std::sin(angle);
    if (isTurned) {
      problem.edgeNodes.turned.push_back(node);
      for (int i = 0; i < dim; ++i)
        for (int j = 0; j < dim; ++j)
          problem.edgeNodes.axes.push_back(Q(node * dim + i, j));
    }
  }
  const auto turned = [&](const double* values, int node, int columns, int stride) {
    DenseMatrix axes(dim, dim), block(dim, columns);
    for (int i = 0; i < dim; ++i)
      for (int j = 0; j < std::max(dim, columns); ++j) {
        if (j < dim)
          axes(i, j) = Q(node * dim + i, j);
        if (j < columns)
          block(i, j) = values[i * stride + j];
      }
    return multiply(axes, block);
  };
  BlockMatrix& K = body.matrix;
  for (std::size_t r = 0; r < std::size_t(K.numRows()); ++r)
    for (auto b = K.rowPtr[r]; b < K.rowPtr[r + 1]; ++b) {
      double* const values = K.values.data() + b * dim * dim;
      const DenseMatrix rows =
          turned(values, K.rowNode(int(r)), dim, dim); // Q_i K_ij, column-major: its transpose row-major
      const DenseMatrix both = turned(rows.data(), K.colNode(b), dim, dim); // Q_j (Q_i K_ij)^T
      std::copy_n(both.data(), dim * dim, values);                          // column-major: (Q_i K_ij Q_j^T) row-major
    }
  for (int node = 0; node < K.numNodes(); ++node)
    for (int m = 0; m < problem.nearNullSpace.cols(); ++m) {
      const DenseMatrix motion = turned(problem.nearNullSpace.col(m) + node * dim, node, 1, 1);
      std::copy_n(motion.data(), dim, problem.nearNullSpace.col(m) + node * dim);
    }
}

SolverProblem problemWith(const BlockMatrix& matrix, const std::vector<int>& kept, const std::vector<int>& fixed)
{
  SolverProblem problem;
  problem.matrix = &matrix;
  problem.roles.assign(std::size_t(matrix.numDofs()), DofRole::Interior);
  for (const int dof : fixed)
    problem.roles[std::size_t(dof)] = DofRole::Fixed;
  for (const int dof : kept)
    problem.roles[std::size_t(dof)] = DofRole::Kept;
  problem.kept = kept;
  return problem;
}

std::unique_ptr<LinearSolver> makeSolver(const std::string& type, const std::string& xml)
{
  return solvers().build(solverParams(type, xml));
}

std::string complaint(const std::string& type, const std::string& xml)
{
  try {
    solverParams(type, xml);
    return "no complaint";
  } catch (const InputError& error) {
    return error.what();
  }
}

DenseReference::DenseReference(const SolverProblem& problem) : kept_(problem.kept)
{
  const BlockMatrix& K = *problem.matrix;
  full = DenseMatrix(K.numDofs(), K.numDofs());
  for (std::size_t r = 0; r < std::size_t(K.numRows()); ++r)
    for (std::int64_t b = K.rowPtr[r]; b < K.rowPtr[r + 1]; ++b)
      for (int i = 0; i < K.dim; ++i)
        for (int j = 0; j < K.dim; ++j)
          full(K.rowNode(int(r)) * K.dim + i, K.colNode(b) * K.dim + j) =
              K.values[std::size_t((b * K.dim + i) * K.dim + j)];
  for (std::size_t dof = 0; dof < problem.roles.size(); ++dof)
    if (problem.roles[dof] == DofRole::Interior)
      interior_.push_back(int(dof));
  DenseMatrix inner(int(interior_.size()), int(interior_.size()));
  for (int j = 0; j < inner.cols(); ++j)
    for (int i = 0; i < inner.rows(); ++i)
      inner(i, j) = full(interior_[std::size_t(i)], interior_[std::size_t(j)]);
  factor_ = std::make_unique<DenseCholesky>(inner);
  schur = DenseMatrix(int(kept_.size()), int(kept_.size()));
  for (int j = 0; j < schur.cols(); ++j) {
    const Vector column = reduce(full.column(kept_[std::size_t(j)]));
    std::copy(column.begin(), column.end(), schur.col(j));
  }
}

Vector DenseReference::interiorSolve(Vector rhs) const
{
  Vector restricted;
  for (const int dof : interior_)
    restricted.push_back(rhs[std::size_t(dof)]);
  restricted = factor_->solve(restricted);
  Vector u(rhs.size(), 0.0);
  for (std::size_t i = 0; i < interior_.size(); ++i)
    u[std::size_t(interior_[i])] = restricted[i];
  return u;
}

Vector DenseReference::expand(const Vector& load, const Vector& kept) const
{
  Vector boundary(load.size(), 0.0);
  for (std::size_t c = 0; c < kept_.size(); ++c)
    boundary[std::size_t(kept_[c])] = kept[c];
  Vector rhs = multiply(full, boundary);
  for (std::size_t i = 0; i < rhs.size(); ++i)
    rhs[i] = load[i] - rhs[i];
  Vector u = interiorSolve(rhs);
  for (std::size_t c = 0; c < kept_.size(); ++c)
    u[std::size_t(kept_[c])] = kept[c];
  return u;
}

Vector DenseReference::reduce(const Vector& load) const
{
  const Vector force = multiply(full, interiorSolve(load));
  Vector g;
  for (const int dof : kept_)
    g.push_back(load[std::size_t(dof)] - force[std::size_t(dof)]);
  return g;
}

Vector randomVector(std::size_t size, unsigned seed)
{
  std::mt19937 random(seed);
  Vector values(size);
  for (double& value : values)
    value = double(random() % 20001) / 10000.0 - 1.0;
  return values;
}

double relativeDifference(const Vector& a, const Vector& b)
{
  Vector difference = a;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference[i] -= b[i];
  return norm(difference) / norm(b);
}

double relativeDifference(const DenseMatrix& a, const DenseMatrix& b)
{
  const auto size = std::size_t(a.rows()) * std::size_t(a.cols());
  return relativeDifference(Vector(a.data(), a.data() + size), Vector(b.data(), b.data() + size));
}

} // namespace ndframe::test
