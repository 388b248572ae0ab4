#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <MueLu_Hierarchy.hpp>
#include <MueLu_MasterList.hpp>
#include <MueLu_TpetraOperator.hpp>
#include <MueLu_Utilities.hpp>
#include <Tpetra_Distributor.hpp>

#include "preconditioners.hpp"
#include "tpetra_system.hpp"

namespace ndframe
{

namespace
{

using Hierarchy =
    MueLu::Hierarchy<double, TpetraMap::local_ordinal_type, TpetraMap::global_ordinal_type, TpetraMap::node_type>;
using Utilities =
    MueLu::Utilities<double, TpetraMap::local_ordinal_type, TpetraMap::global_ordinal_type, TpetraMap::node_type>;
using XpetraMatrix =
    Xpetra::Matrix<double, TpetraMap::local_ordinal_type, TpetraMap::global_ordinal_type, TpetraMap::node_type>;

/// The same motions in another basis. MueLu refuses a mode that vanishes on an aggregate, as a rotation does on a few
/// nodes of its axis; a mode that is a sum of several does so nowhere in particular.
Teuchos::RCP<TpetraVectors> mixed(const TpetraVectors& modes)
{
  const auto result = Teuchos::rcp(new TpetraVectors(modes, Teuchos::Copy));
  for (std::size_t m = 1; m < modes.getNumVectors(); ++m)
    for (std::size_t other = 0; other < m; ++other)
      result->getVectorNonConst(m)->update(0.37 / double(m + other), *modes.getVector(other), 1.0);
  return result;
}

constexpr int smootherDegree = 2, coarseDegree = 20; ///< of Chebyshev's polynomials

/// What a rank sends in one product with a matrix of a level.
Traffic trafficOf(Hierarchy& hierarchy, int level, const char* matrix)
{
  const auto values = hierarchy.GetLevel(level);
  if (!values->IsAvailable(matrix))
    return {};
  const auto import =
      Utilities::Op2TpetraCrs(values->template Get<Teuchos::RCP<XpetraMatrix>>(matrix))->getGraph()->getImporter();
  if (import.is_null())
    return {};
  return {std::int64_t(import->getDistributor().getNumSends()),
          std::int64_t(import->getNumExportIDs()) * std::int64_t(sizeof(double))};
}

/// What a rank sends in a cycle: a level takes the residual and seven products in its smoothers of degree 2, as counted
/// by interposing MPI_Isend (MueLu 13.2); the coarsest level is smoothed only, from zero.
Traffic trafficOf(Hierarchy& hierarchy)
{
  Traffic sum;
  const int levels = hierarchy.GetNumLevels();
  for (int level = 0; level < levels; ++level) {
    const Traffic product = trafficOf(hierarchy, level, "A");
    const int products = level + 1 < levels ? 8 : coarseDegree - 1;
    sum += {products * product.messages, products * product.bytes};
    sum += trafficOf(hierarchy, level, "P");
    sum += trafficOf(hierarchy, level, "R");
  }
  return sum;
}

/// Smoothed aggregation that keeps the rigid motions, with Chebyshev smoothing.
///
/// The coarsest problem is solved by MueLu's direct solver on one rank. That solver (Amesos2 KLU2) gives wrong answers
/// on several ranks; there the coarsest level is made small and smoothed instead.
class MueLuPreconditioner final : public Preconditioner
{
public:
  explicit MueLuPreconditioner(const Teuchos::ParameterList& list) : list_(list) {}

  std::shared_ptr<PreconditionerHandle> build(const TpetraSystem& system) const override
  {
    Teuchos::ParameterList list = withDefaults(system.isParallel);
    list.set("number of equations", system.dim);
    Teuchos::ParameterList& data = list.sublist("user data");
    if (!system.modes.is_null())
      data.set("Nullspace", mixed(*system.modes));
    if (!system.coordinates.is_null())
      data.set("Coordinates", system.coordinates);
    const Teuchos::RCP<TpetraOperator> matrix = system.matrix;
    const auto cycle = MueLu::CreateTpetraPreconditioner(matrix, list);
    return std::make_shared<PreconditionerHandle>(PreconditionerHandle{cycle, trafficOf(*cycle->GetHierarchy())});
  }

  std::string name() const override { return "MueLu"; }

private:
  /// The user's choice of a smoother or coarse solver comes with parameters of its own.
  Teuchos::ParameterList withDefaults(bool isParallel) const
  {
    Teuchos::ParameterList list;
    list.set("verbosity", "none");
    list.set("multigrid algorithm", "sa");
    list.set("sa: eigenvalue estimate num iterations", powerSteps); // the smoother takes this estimate, too
    if (!list_.isParameter("smoother: type")) {
      list.set("smoother: type", "CHEBYSHEV");
      list.sublist("smoother: params").set("chebyshev: degree", smootherDegree);
      list.sublist("smoother: params").set("chebyshev: boost factor", boost);
    }
    if (isParallel && !list_.isParameter("coarse: type")) {
      list.set("coarse: max size", 200);
      list.set("coarse: type", "CHEBYSHEV");
      Teuchos::ParameterList& params = list.sublist("coarse: params");
      params.set("chebyshev: degree", coarseDegree);
      params.set("chebyshev: ratio eigenvalue", 300.0);
      params.set("chebyshev: eigenvalue max iterations", 2 * powerSteps);
      params.set("chebyshev: boost factor", boost);
    }
    list.setParameters(list_);
    return list;
  }

  /// An estimate of the largest eigenvalue that is 15 % too low makes Chebyshev's polynomial indefinite. MueLu's ten
  /// steps from a random start do not see what belongs to a few small cells, and a larger margin costs nothing.
  static constexpr int powerSteps = 30;
  static constexpr double boost = 1.5;
  Teuchos::ParameterList list_;
};

} // namespace

const Teuchos::ParameterList& validMueLuList()
{
  static const Teuchos::RCP<const Teuchos::ParameterList> valid = MueLu::MasterList::List();
  return *valid;
}

std::unique_ptr<Preconditioner> makeMueLu(const Teuchos::ParameterList& list)
{
  return std::make_unique<MueLuPreconditioner>(list);
}

} // namespace ndframe
