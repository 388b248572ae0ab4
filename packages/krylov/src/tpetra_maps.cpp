#include "tpetra_maps.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Distributor.hpp>

namespace ndframe
{

Teuchos::RCP<const Teuchos::Comm<int>> teuchosComm(const Comm& comm)
{
  // On one process too: Ifpack2 and MueLu take Teuchos's serial communicator for one of MPI.
  return Teuchos::rcp(new Teuchos::MpiComm<int>(comm.size() > 1 ? MPI_Comm_f2c(comm.communicator()) : MPI_COMM_SELF));
}

Teuchos::RCP<const TpetraMap> mapOf(const std::vector<int>& nodes, int perNode,
                                    const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
{
  using Global = TpetraMap::global_ordinal_type;
  std::vector<Global> numbers;
  numbers.reserve(nodes.size() * std::size_t(perNode));
  for (const int node : nodes)
    for (int i = 0; i < perNode; ++i)
      numbers.push_back(Global(node) * perNode + i);
  const auto unknownTotal = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new TpetraMap(unknownTotal, Teuchos::arrayViewFromVector(numbers), 0, comm));
}

LocalNodes::LocalNodes(const std::vector<int>& own, int numNodes) : nodes(own), local(std::size_t(numNodes), -1)
{
  for (std::size_t i = 0; i < nodes.size(); ++i)
    local[std::size_t(nodes[i])] = int(i);
}

int LocalNodes::number(int node)
{
  int& here = local[std::size_t(node)];
  if (here < 0) {
    here = int(nodes.size());
    nodes.push_back(node);
  }
  return here;
}

Halo::Halo(const Teuchos::RCP<const TpetraMap>& own, const Teuchos::RCP<const TpetraMap>& needed) : import_(own, needed)
{
  const auto traffic = [](std::size_t messages, std::size_t values) {
    return Traffic{std::int64_t(messages), std::int64_t(values) * std::int64_t(sizeof(double))};
  };
  fetch_ = traffic(import_.getDistributor().getNumSends(), import_.getNumExportIDs());
  add_ = traffic(import_.getDistributor().getNumReceives(), import_.getNumRemoteIDs());
}

void Halo::fetch(const TpetraVectors& own, TpetraVectors& needed) const
{
  needed.doImport(own, import_, Tpetra::INSERT);
  traffic_ += fetch_;
}

void Halo::add(const TpetraVectors& needed, TpetraVectors& own) const
{
  own.doExport(needed, import_, Tpetra::ADD);
  traffic_ += add_;
}

LocalNodes columnNodes(const BlockMatrix& K)
{
  LocalNodes columns(K.rows, K.numNodes);
  for (const int node : K.cols)
    columns.number(node);
  return columns;
}

} // namespace ndframe
