#include "joined_gradients.hpp"

#include "belos_cg.hpp"
#include "joined_transfer.hpp"
#include "two_level_cycle.hpp"
#include "vertex_transfer.hpp"

namespace ndframe
{

namespace
{

IndexMap nodesOf(const JoinedBodies& bodies)
{
  std::vector<const IndexMap*> nodes;
  for (const RankProblem* problem : bodies.problems)
    nodes.push_back(&problem->matrix->nodes);
  return stacked(nodes);
}

IndexMap verticesOf(const JoinedBodies& bodies)
{
  std::vector<const IndexMap*> vertices;
  for (const LinearLevel* level : bodies.levels)
    vertices.push_back(&level->matrix.nodes);
  return stacked(vertices);
}

std::unique_ptr<JoinedTransfer> transferOf(const JoinedBodies& bodies, const Comm& comm)
{
  const auto communicator = teuchosComm(comm);
  const int dim = bodies.levels.front()->matrix.dim;
  std::vector<LinearTransfer> transfers;
  for (std::size_t b = 0; b < bodies.problems.size(); ++b)
    transfers.emplace_back(*bodies.problems[b], *bodies.levels[b],
                           ownedMap(bodies.levels[b]->matrix.nodes, dim, communicator));
  return std::make_unique<JoinedTransfer>(std::move(transfers),
                                          KeptPlaces(bodies.kept, nodesOf(bodies), dim, communicator),
                                          KeptPlaces(bodies.keptOnVertices, verticesOf(bodies), dim, communicator));
}

/// What conjugate gradients on either level have in common.
template <class Gradients>
class CycleGradients : public Gradients
{
public:
  CycleGradients(Teuchos::RCP<JoinedOperator> matrix, const JoinedUnknowns& unknowns,
                 std::unique_ptr<FollowingTransfer> transfer, const Teuchos::ParameterList& belos)
      : matrix_(std::move(matrix)), transfer_(transfer.get())
  {
    matrix_->follow(unknowns);
    transfer_->follow(unknowns.rows.unknowns);
    cycle_ = Teuchos::rcp(new TwoLevelCycle(matrix_, std::move(transfer)));
    cg_ = makeBelosCg({matrix_, cycle_}, belos);
  }

  CycleWork work() const override { return workOf(*matrix_, *cycle_); }
  ConjugateGradients::Result solve(const Vector& b, double tolerance, int maxIterations,
                                   const ConjugateGradients::Watch& watch) const override
  {
    return cg_->solve(b, tolerance, maxIterations, watch);
  }
  Vector multiply(const Vector& x) const override
  {
    Vector y(x.size());
    matrix_->multiplyBodies(x.data(), y.data());
    return y;
  }
  Vector sizes(const Vector& x) const override
  {
    Vector y(x.size());
    matrix_->sizesOfBodies(x.data(), y.data());
    return y;
  }
  void follow(const JoinedUnknowns& unknowns) override
  {
    matrix_->follow(unknowns);
    transfer_->follow(unknowns.rows.unknowns);
    cycle_->takeDiagonal();
  }

protected:
  TwoLevelCycle& cycle() { return *cycle_; }
  const TwoLevelCycle& cycle() const { return *cycle_; }
  FollowingTransfer& transfer() { return *transfer_; }
  std::size_t size() const { return matrix_->getDomainMap()->getNodeNumElements(); } ///< of own dofs

private:
  Teuchos::RCP<JoinedOperator> matrix_;
  FollowingTransfer* transfer_; ///< of the cycle
  Teuchos::RCP<TwoLevelCycle> cycle_;
  std::unique_ptr<ConjugateGradients> cg_;
};

KeptPlaces placesOnVertices(const JoinedBodies& bodies, const Comm& comm)
{
  return {bodies.keptOnVertices, verticesOf(bodies), bodies.levels.front()->matrix.dim, teuchosComm(comm)};
}

Teuchos::RCP<JoinedOperator> matrixOnVertices(const JoinedBodies& bodies, const Comm& comm)
{
  std::vector<const RankProblem*> problems;
  for (const LinearLevel* level : bodies.levels)
    problems.push_back(&level->problem);
  return Teuchos::rcp(new JoinedOperator(problems, verticesOf(bodies), bodies.keptOnVertices, comm));
}

class VertexGradients final : public CycleGradients<FollowingGradients>
{
public:
  VertexGradients(const JoinedBodies& bodies, const JoinedUnknowns& unknowns, const Comm& comm,
                  const Teuchos::ParameterList& belos)
      : CycleGradients(matrixOnVertices(bodies, comm), unknowns,
                       std::make_unique<VertexTransfer>(bodies.levels, placesOnVertices(bodies, comm)), belos)
  {}

  void dropCoarse() { cycle().dropCoarse(); }
  void shareCoarse(const TwoLevelCycle& other, const JoinedRows& rows)
  {
    cycle().shareCoarse(other);
    transfer().followOnVertices(rows.kept);
  }
};

class TwoLevelGradients final : public CycleGradients<JoinedGradients>
{
public:
  TwoLevelGradients(const JoinedBodies& bodies, const JoinedUnknowns& unknowns, const Comm& comm,
                    std::shared_ptr<const Preconditioner> coarse, const Teuchos::ParameterList& belos)
      : CycleGradients(Teuchos::rcp(new JoinedOperator(bodies.problems, nodesOf(bodies), bodies.kept, comm)), unknowns,
                       transferOf(bodies, comm), belos),
        bodies_(bodies), comm_(comm), coarse_(std::move(coarse)), belos_(belos),
        joined_(static_cast<JoinedTransfer*>(&transfer()))
  {}

  double largestEigenvalue() const override { return cycle().largestEigenvalue(); }
  void setCoarse(const JoinedRows& rows, const RankProblem& problem, double decoupledDiagonal,
                 const std::function<void()>& isRead) override
  {
    cycle().dropCoarse();
    if (onVertices_)
      onVertices_->dropCoarse();
    const TpetraSystem system(problem, comm_, decoupledDiagonal);
    isRead();
    cycle().setCoarse(system, *coarse_);
    transfer().followOnVertices(rows.kept);
    if (onVertices_)
      onVertices_->shareCoarse(cycle(), rows);
  }

  FollowingGradients& onVertices(const JoinedUnknowns& unknowns) override
  {
    onVertices_ = std::make_unique<VertexGradients>(bodies_, unknowns, comm_, belos_);
    return *onVertices_;
  }
  Vector toVertices(const Vector& x) const override
  {
    Vector c(numVertexDofs());
    joined_->toVertices(x.data(), c.data());
    return c;
  }
  Vector fromVertices(const Vector& c) const override
  {
    Vector x(size());
    joined_->fromVertices(c.data(), x.data());
    return x;
  }

private:
  std::size_t numVertexDofs() const
  {
    std::size_t number = 0;
    for (const LinearLevel* level : bodies_.levels)
      number += std::size_t(level->matrix.numRows()) * std::size_t(level->matrix.dim);
    return number;
  }

  JoinedBodies bodies_;
  Comm comm_;
  std::shared_ptr<const Preconditioner> coarse_;
  Teuchos::ParameterList belos_;
  JoinedTransfer* joined_; ///< of the cycle
  std::unique_ptr<VertexGradients> onVertices_;
};

} // namespace

std::unique_ptr<JoinedGradients> makeJoinedGradients(const JoinedBodies& bodies, const JoinedUnknowns& unknowns,
                                                     const Comm& comm, std::shared_ptr<const Preconditioner> coarse,
                                                     const Teuchos::ParameterList& belos)
{
  return std::make_unique<TwoLevelGradients>(bodies, unknowns, comm, std::move(coarse), belos);
}

} // namespace ndframe
