#include "cholmod_factor.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/base/memory.hpp"
#include "serial_openmp.hpp"

namespace ndframe
{

namespace
{

/// A pivot below this times its diagonal entry is round-off. Pivots of regular bodies shrink with their slenderness
/// (length over height)^-3 only; those of singular ones were measured up to 5e-13 with 250 000 dofs.
constexpr double smallestPivot = 1e-12;

constexpr double small = 4e6;    ///< bytes
constexpr double longWork = 2e9; ///< operations, which take a second or so; how far they are is told

/// In bytes: the factor, and T and S of the interface's Schur complement.
double neededMemory(const cholmod_factor& factor, int numKept)
{
  return 8.0 * double(factor.xsize) + 16.0 * double(numKept) * numKept;
}

[[noreturn]] void failForMemory(const cholmod_common& common, int numKept, const std::string& more = {})
{
  std::string size;
  if (common.lnz > 0) // negative before the analysis has counted it
    size = fmt::format(": it takes {:.1f} GB, {:.1f} GB of it for the {} nodes on the interface", 8e-9 * common.lnz,
                       4e-9 * double(numKept) * numKept, numKept);
  throw InputError(fmt::format("The Cholesky factor does not fit into memory{}{}; use Multigrid as linear solver or a "
                               "coarser mesh.",
                               size, more));
}

[[noreturn]] void failCholmod(const cholmod_common& common, int numKept)
{
  if (common.status != CHOLMOD_OUT_OF_MEMORY && common.status != CHOLMOD_TOO_LARGE)
    throw InternalError(fmt::format("CHOLMOD failed with status {}", common.status));
  failForMemory(common, numKept);
}

} // namespace

void startCholmod(cholmod_common& common)
{
  cholmod_start(&common);
  common.print = 0;
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
}

cholmod_sparse viewOf(UpperTriangle& A)
{
  cholmod_sparse view{};
  view.nrow = view.ncol = std::size_t(A.size());
  view.nzmax = A.rows.size();
  view.p = A.colPtr.data();
  view.i = A.rows.data();
  view.x = A.values.data();
  view.stype = 1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = view.packed = 1;
  return view;
}

cholmod_dense viewOf(DenseMatrix& X)
{
  cholmod_dense view{};
  view.nrow = view.d = std::size_t(X.rows());
  view.ncol = std::size_t(X.cols());
  view.nzmax = view.nrow * view.ncol;
  view.x = X.data();
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  return view;
}

CholmodFactor::CholmodFactor(UpperTriangle A, std::vector<int> order, int numKept, const FactorProgress::Tell& tell)
    : numKept_(numKept)
{
  startCholmod(common_);
  try {
    cholmod_sparse view = viewOf(A);
    analyse(view, std::move(order));
    numNonzeros_ = std::int64_t(common_.lnz);
    // Else it would take what there is until the system ends some process. To ask takes longer than a small factor.
    if (const double needed = neededMemory(*factor_, numKept_); needed > small)
      if (const MemoryLeft left = memoryLeft(); needed > double(left.bytes))
        failForMemory(common_, numKept_, ", and " + left.text() + " is left");
    std::optional<FactorProgress> progress;
    std::function<void()> count;
    if (tell && common_.fl > longWork) {
      progress.emplace(*factor_, tell);
      count = [&] { progress->enterRegion(); };
    }
    const SerialOpenMp serial(count);
    cholmod_factorize(&view, factor_, &common_);
    if (common_.status < CHOLMOD_OK)
      failCholmod(common_, numKept_);
    if (common_.status == CHOLMOD_NOT_POSDEF)
      throw BadPivot{this->order(int(factor_->minor))};
    checkPivots(A);
    findTrailingColumns();
  } catch (...) {
    cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
    throw;
  }
}

CholmodFactor::~CholmodFactor()
{
  cholmod_free_factor(&factor_, &common_);
  cholmod_finish(&common_);
}

/// CHOLMOD postorders the elimination tree, without which it finds no supernodes. Where interior dofs fall into several
/// parts, a part that touches no early kept dof may be moved behind it. Then the interior keeps the postorder, the kept
/// dofs are put back to the end, and CHOLMOD takes this order as it is.
void CholmodFactor::analyse(cholmod_sparse& view, std::vector<int> order)
{
  factor_ = cholmod_analyze_p(&view, order.data(), nullptr, 0, &common_);
  if (common_.status < CHOLMOD_OK)
    failCholmod(common_, numKept_);
  if (keptAreLast(order))
    return;
  std::vector<char> isKept(order.size(), 0);
  for (auto kept = order.end() - numKept_; kept != order.end(); ++kept)
    isKept[std::size_t(*kept)] = 1;
  const int* postorder = static_cast<const int*>(factor_->Perm);
  std::copy_if(postorder, postorder + size(), order.begin(), [&](int column) { return !isKept[std::size_t(column)]; });
  cholmod_free_factor(&factor_, &common_);
  common_.postorder = 0;
  factor_ = cholmod_analyze_p(&view, order.data(), nullptr, 0, &common_);
  if (common_.status < CHOLMOD_OK)
    failCholmod(common_, numKept_);
  NDFRAME_ASSERT(keptAreLast(order), "CHOLMOD moved the kept dofs although postordering is off");
}

bool CholmodFactor::keptAreLast(const std::vector<int>& order) const
{
  const int* result = static_cast<const int*>(factor_->Perm);
  return std::equal(order.end() - numKept_, order.end(), result + (size() - numKept_));
}

template <class Visit>
void CholmodFactor::forEachColumn(int firstColumn, Visit visit) const
{
  const auto* super = static_cast<const int*>(factor_->super);
  const auto* rowStart = static_cast<const int*>(factor_->pi);
  const auto* entryStart = static_cast<const int*>(factor_->px);
  const auto* rows = static_cast<const int*>(factor_->s);
  const auto* entries = static_cast<const double*>(factor_->x);
  for (std::size_t s = 0; s < factor_->nsuper; ++s) {
    const int numRows = rowStart[s + 1] - rowStart[s];
    for (int column = std::max(super[s], firstColumn); column < super[s + 1]; ++column) {
      const int local = column - super[s];
      const double* first = entries + entryStart[s] + std::ptrdiff_t(local) * numRows + local;
      visit(column, rows + rowStart[s] + local, first, numRows - local);
    }
  }
}

void CholmodFactor::checkPivots(const UpperTriangle& A) const
{
  forEachColumn(0, [&](int column, const int*, const double* entries, int) {
    const double pivot = entries[0] * entries[0];
    if (!(pivot > smallestPivot * A.diagonal(order(column))))
      throw BadPivot{order(column)};
  });
}

void CholmodFactor::solveInPlace(Sweep sweep, DenseMatrix& X) const
{
  NDFRAME_ASSERT(X.rows() == size(), "shapes do not match");
  if (X.rows() == 0 || X.cols() == 0)
    return;
  cholmod_dense x = viewOf(X);
  DenseMatrix workspace(X.cols(), std::max(1, int(factor_->maxesize)));
  cholmod_dense e = viewOf(workspace);
  const int done = sweep(factor_, &x, &e, &common_);
  NDFRAME_ASSERT(done != 0, "CHOLMOD refused a solve");
}

void CholmodFactor::forward(DenseMatrix& X) const
{
  solveInPlace(cholmod_super_lsolve, X);
}

void CholmodFactor::backward(DenseMatrix& X) const
{
  solveInPlace(cholmod_super_ltsolve, X);
}

void CholmodFactor::findTrailingColumns()
{
  forEachColumn(size() - numKept_, [&](int, const int* rows, const double* entries, int count) {
    trailing_.push_back({rows, entries, count});
  });
}

DenseMatrix CholmodFactor::trailingBlock() const
{
  DenseMatrix T(numKept_, numKept_);
  const int first = size() - numKept_;
  for (int j = 0; j < numKept_; ++j) {
    const TrailingColumn& column = trailing_[std::size_t(j)];
    for (int k = 0; k < column.count; ++k)
      T(column.rows[k] - first, j) = column.entries[k];
  }
  return T;
}

Vector CholmodFactor::trailingTransposedTimes(const double* x) const
{
  Vector y;
  y.reserve(trailing_.size());
  const int first = size() - numKept_;
  for (const TrailingColumn& column : trailing_) {
    double sum = 0.0;
    for (int k = 0; k < column.count; ++k)
      sum += column.entries[k] * x[column.rows[k] - first];
    y.push_back(sum);
  }
  return y;
}

Vector CholmodFactor::trailingTimes(const double* y) const
{
  Vector x(trailing_.size(), 0.0);
  const int first = size() - numKept_;
  for (const TrailingColumn& column : trailing_) {
    for (int k = 0; k < column.count; ++k)
      x[std::size_t(column.rows[k] - first)] += column.entries[k] * *y;
    ++y;
  }
  return x;
}

Vector CholmodFactor::trailingSolve(Vector b) const
{
  const int first = size() - numKept_;
  const auto at = [first](const TrailingColumn& column, int k) { return std::size_t(column.rows[k] - first); };
  for (const TrailingColumn& column : trailing_) {
    const double y = b[at(column, 0)] /= column.entries[0];
    for (int k = 1; k < column.count; ++k)
      b[at(column, k)] -= column.entries[k] * y;
  }
  for (auto column = trailing_.rbegin(); column != trailing_.rend(); ++column) {
    double x = b[at(*column, 0)];
    for (int k = 1; k < column->count; ++k)
      x -= column->entries[k] * b[at(*column, k)];
    b[at(*column, 0)] = x / column->entries[0];
  }
  return b;
}

} // namespace ndframe
