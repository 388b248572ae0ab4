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

using Number = TpetraMap::global_ordinal_type;

/// Of every rank the number of its first node.
std::vector<Number> firstOf(int numOwned, const Teuchos::Comm<int>& comm)
{
  std::vector<int> sizes(std::size_t(comm.getSize()));
  Teuchos::gatherAll(comm, 1, &numOwned, comm.getSize(), sizes.data());
  std::vector<Number> first{0};
  for (const int size : sizes)
    first.push_back(first.back() + size);
  return first;
}

/// What this rank and the owners of its ghosts call the nodes that it holds.
std::vector<Number> numbersOf(const IndexMap& nodes, const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
{
  const std::vector<Number> first = firstOf(nodes.numOwned(), *comm);
  std::vector<Number> own, ghosts, numbers;
  for (int node = 0; node < nodes.size(); ++node)
    (nodes.owns(node) ? own : ghosts).push_back(nodes.global(node));
  const auto unknownTotal = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const TpetraMap owners(unknownTotal, Teuchos::arrayViewFromVector(own), 0, comm);
  std::vector<int> ranks(ghosts.size()), places(ghosts.size());
  owners.getRemoteIndexList(Teuchos::arrayViewFromVector(ghosts), Teuchos::arrayViewFromVector(ranks),
                            Teuchos::arrayViewFromVector(places));
  for (int node = 0; node < nodes.numOwned(); ++node)
    numbers.push_back(first[std::size_t(comm->getRank())] + node);
  for (std::size_t i = 0; i < ghosts.size(); ++i)
    numbers.push_back(first[std::size_t(ranks[i])] + places[i]);
  return numbers;
}

} // namespace

Teuchos::RCP<const TpetraMap> ownedMap(const IndexMap& nodes, int perNode,
                                       const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
{
  const auto unknownTotal = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new TpetraMap(unknownTotal, std::size_t(nodes.numOwned()) * std::size_t(perNode), 0, comm));
}

Teuchos::RCP<const TpetraMap> heldMap(const IndexMap& nodes, int perNode,
                                      const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
{
  if (comm->getSize() == 1)
    return ownedMap(nodes, perNode, comm);
  std::vector<Number> numbers;
  numbers.reserve(std::size_t(nodes.size()) * std::size_t(perNode));
  for (const Number node : numbersOf(nodes, comm))
    for (int i = 0; i < perNode; ++i)
      numbers.push_back(node * perNode + i);
  const auto unknownTotal = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new TpetraMap(unknownTotal, Teuchos::arrayViewFromVector(numbers), 0, comm));
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
