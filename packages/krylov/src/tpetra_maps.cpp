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

namespace
{

Teuchos::RCP<const TpetraMap> firstOf(const IndexMap& nodes, int count, int perNode,
                                      const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
{
  std::vector<TpetraMap::global_ordinal_type> numbers;
  numbers.reserve(std::size_t(count) * std::size_t(perNode));
  for (int node = 0; node < count; ++node)
    for (int i = 0; i < perNode; ++i)
      numbers.push_back(nodes.global(node) * perNode + i);
  const auto unknownTotal = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new TpetraMap(unknownTotal, Teuchos::arrayViewFromVector(numbers), 0, comm));
}

} // namespace

Teuchos::RCP<const TpetraMap> ownedMap(const IndexMap& nodes, int perNode,
                                       const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
{
  return firstOf(nodes, nodes.numOwned(), perNode, comm);
}

Teuchos::RCP<const TpetraMap> heldMap(const IndexMap& nodes, int perNode,
                                      const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
{
  return firstOf(nodes, nodes.size(), perNode, comm);
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

} // namespace ndframe
