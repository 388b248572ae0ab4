#include "tpetra_system.hpp"

#include <algorithm>

#include "tpetra_maps.hpp"

namespace ndframe
{

namespace
{

using Local = TpetraMap::local_ordinal_type;

struct LocalRows
{
  std::vector<std::size_t> starts = {0};
  std::vector<Local> cols;
  std::vector<double> values;
};

/// Appends row `component` of block row r, restricted to interior columns. The local columns ascend, as they do in K (a
/// Tpetra matrix with unsorted rows gives wrong results on several ranks).
void appendRow(const RankProblem& problem, std::size_t r, int component, LocalRows& rows)
{
  const BlockMatrix& K = *problem.matrix;
  for (std::int64_t b = K.rowPtr[r]; b < K.rowPtr[r + 1]; ++b) {
    const int node = K.cols[std::size_t(b)];
    for (int j = 0; j < K.dim; ++j)
      if (problem.role(node, j) == DofRole::Interior) {
        rows.cols.push_back(node * K.dim + j);
        rows.values.push_back(
            K.values[(std::size_t(b) * std::size_t(K.dim) + std::size_t(component)) * std::size_t(K.dim) +
                     std::size_t(j)]);
      }
  }
}

LocalRows interiorRows(const RankProblem& problem, double decoupledDiagonal)
{
  const BlockMatrix& K = *problem.matrix;
  LocalRows rows;
  for (int r = 0; r < K.numRows(); ++r)
    for (int i = 0; i < K.dim; ++i) {
      if (problem.role(r, i) == DofRole::Interior)
        appendRow(problem, std::size_t(r), i, rows);
      else {
        rows.cols.push_back(Local(r) * K.dim + i);
        rows.values.push_back(decoupledDiagonal);
      }
      rows.starts.push_back(rows.cols.size());
    }
  return rows;
}

// NOLINTBEGIN(clang-analyzer-cplusplus.NewDeleteLeaks): the analyzer does not follow the counts of Kokkos views
template <class View, class Values>
View copyOf(const Values& values)
{
  typename View::non_const_type view("ndframe", values.size());
  const auto host = Kokkos::create_mirror_view(view);
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

Teuchos::RCP<TpetraMatrix> makeMatrix(const RankProblem& problem, double decoupledDiagonal,
                                      const Teuchos::RCP<const TpetraMap>& dofMap)
{
  const BlockMatrix& K = *problem.matrix;
  const LocalRows rows = interiorRows(problem, decoupledDiagonal);
  using Graph = TpetraMatrix::local_graph_device_type;
  const auto matrix =
      Teuchos::rcp(new TpetraMatrix(dofMap, heldMap(K.nodes, K.dim, dofMap->getComm()),
                                    copyOf<Graph::row_map_type>(rows.starts), copyOf<Graph::entries_type>(rows.cols),
                                    copyOf<TpetraMatrix::local_matrix_device_type::values_type>(rows.values)));
  matrix->expertStaticFillComplete(dofMap, dofMap);
  return matrix;
}
// NOLINTEND(clang-analyzer-cplusplus.NewDeleteLeaks)

Teuchos::RCP<TpetraVectors> makeModes(const RankProblem& problem, const Teuchos::RCP<const TpetraMap>& dofMap)
{
  const DenseMatrix& given = problem.nearNullSpace;
  if (given.cols() == 0)
    return Teuchos::null;
  const auto modes = Teuchos::rcp(new TpetraVectors(dofMap, std::size_t(given.cols())));
  for (int m = 0; m < given.cols(); ++m)
    for (Local i = 0; i < Local(dofMap->getNodeNumElements()); ++i)
      modes->replaceLocalValue(i, std::size_t(m), given(i, m));
  return modes;
}

Teuchos::RCP<TpetraVectors> makeCoordinates(const RankProblem& problem,
                                            const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
{
  const BlockMatrix& K = *problem.matrix;
  const int has = problem.nodePoints.empty() ? 0 : 1;
  int any = 0; // a rank may have no nodes
  Teuchos::reduceAll(*comm, Teuchos::REDUCE_MAX, 1, &has, &any);
  if (any == 0)
    return Teuchos::null;
  const auto points = Teuchos::rcp(new TpetraVectors(ownedMap(K.nodes, 1, comm), std::size_t(K.dim)));
  for (int r = 0; r < K.numRows(); ++r)
    for (int i = 0; i < K.dim; ++i)
      points->replaceLocalValue(Local(r), std::size_t(i),
                                problem.nodePoints[std::size_t(r) * std::size_t(K.dim) + std::size_t(i)]);
  return points;
}

} // namespace

TpetraSystem::TpetraSystem(const RankProblem& problem, const Comm& comm, double decoupledDiagonal)
    : dim(problem.matrix->dim), isParallel(comm.size() > 1)
{
  const auto communicator = teuchosComm(comm);
  dofMap = ownedMap(problem.matrix->nodes, dim, communicator);
  matrix = makeMatrix(problem, decoupledDiagonal, dofMap);
  modes = makeModes(problem, dofMap);
  coordinates = makeCoordinates(problem, communicator);
}

} // namespace ndframe
