#include "joined_gradients.hpp"

#include "belos_cg.hpp"
#include "joined_transfer.hpp"
#include "two_level_cycle.hpp"

namespace ndframe
{

namespace
{

IndexMap nodesOf(const JoinedBodies& bodies)
{
  std::vector<const IndexMap*> nodes;
  for (const SolverProblem* problem : bodies.problems)
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

class TwoLevelGradients final : public JoinedGradients
{
public:
  TwoLevelGradients(const JoinedBodies& bodies, const JoinedUnknowns& unknowns, const Comm& comm,
                    std::shared_ptr<const Preconditioner> coarse, const Teuchos::ParameterList& belos)
      : comm_(comm), coarse_(std::move(coarse)),
        matrix_(Teuchos::rcp(new JoinedOperator(bodies.problems, nodesOf(bodies), bodies.kept, comm)))
  {
    matrix_->follow(unknowns);
    auto transfer = transferOf(bodies, comm);
    transfer_ = transfer.get();
    transfer_->follow(unknowns.rows.unknowns);
    cycle_ = Teuchos::rcp(new TwoLevelCycle(matrix_, std::move(transfer)));
    cg_ = makeBelosCg({matrix_, cycle_}, belos);
  }

  CycleWork work() const override { return workOf(*matrix_, *cycle_); }
  Result solve(const Vector& b, double tolerance, int maxIterations, const Watch& watch) const override
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
  double largestEigenvalue() const override { return cycle_->largestEigenvalue(); }
  void follow(const JoinedUnknowns& unknowns) override
  {
    matrix_->follow(unknowns);
    transfer_->follow(unknowns.rows.unknowns);
    cycle_->takeDiagonal();
  }
  void setCoarse(const JoinedRows& rows, const SolverProblem& problem, double decoupledDiagonal,
                 const std::function<void()>& isRead) override
  {
    cycle_->dropCoarse();
    const TpetraSystem system(problem, comm_, decoupledDiagonal);
    isRead();
    cycle_->setCoarse(system, *coarse_);
    transfer_->followOnVertices(rows.kept);
  }

private:
  Comm comm_;
  std::shared_ptr<const Preconditioner> coarse_;
  Teuchos::RCP<JoinedOperator> matrix_;
  JoinedTransfer* transfer_; ///< of the cycle
  Teuchos::RCP<TwoLevelCycle> cycle_;
  std::unique_ptr<ConjugateGradients> cg_;
};

} // namespace

std::unique_ptr<JoinedGradients> makeJoinedGradients(const JoinedBodies& bodies, const JoinedUnknowns& unknowns,
                                                     const Comm& comm, std::shared_ptr<const Preconditioner> coarse,
                                                     const Teuchos::ParameterList& belos)
{
  return std::make_unique<TwoLevelGradients>(bodies, unknowns, comm, std::move(coarse), belos);
}

} // namespace ndframe
