#include "feti_set.hpp"

#include <algorithm>
#include <limits>

#include "coarse_problem.hpp"

namespace ndframe
{
namespace
{

constexpr double diagonalShare = 0.1; ///< of the diagonal in Q: without it G Q G^T may lose rank
constexpr double spring = 1e-8;       ///< on motions that rows leave free, relative to the coarse problem's diagonal
constexpr int refinements = 2;        ///< after which springs of 1e-8 have an effect of 1e-24
constexpr double unbalanced = 1e-9;   ///< work that no forces can do, relative: round-off
constexpr double elimination = 1e-10; ///< added to what open entries hold, relative: they may not hold the body

} // namespace

FetiSet::FetiSet(const Network& network, const NetworkBodies& bodies, const std::vector<char>& closed,
                 const FetiSet* before)
    : network_(network), bodies_(bodies), closed_(closed)
{
  rows_ = ClosedRows(network.jump, tightestFirst(network, closed), network.bound, network.size()).independentRows();
  std::vector<SparseRow> B;
  for (const int row : rows_)
    B.push_back(network.jump[std::size_t(row)]);
  weighted_ = averagesOf(B, bodies.softness());
  spreadUsers_ = transposed(weighted_.rows, network.size());
  users_ = transposed(B, network.size());
  condenseBodies(before);
  factorCoarse();
}

/// Where a body has open entries: the factor of its stiffness on them.
void FetiSet::condenseBodies(const FetiSet* before)
{
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    OpenPart part;
    for (int k = network_.offsets[b]; k < network_.offsets[b + 1]; ++k)
      if (users_[std::size_t(k)].empty())
        part.entries.push_back(k - network_.offsets[b]);
    if (before != nullptr && before->open_[b].entries == part.entries)
      part.factor = before->open_[b].factor;
    else if (!part.entries.empty())
      part.factor = std::make_shared<DenseCholesky>(stiffnessOn(b, part.entries));
    open_.push_back(std::move(part));
  }
}

DenseMatrix FetiSet::stiffnessOn(std::size_t body, const std::vector<int>& entries) const
{
  const DenseMatrix& S = *network_.bodies[body]->S->dense();
  DenseMatrix own(int(entries.size()), int(entries.size()));
  for (int j = 0; j < own.cols(); ++j) {
    for (int i = 0; i < own.rows(); ++i)
      own(i, j) = S(entries[std::size_t(i)], entries[std::size_t(j)]);
    own(j, j) +=
        elimination * bodies_.weight()[std::size_t(network_.offsets[body]) + std::size_t(entries[std::size_t(j)])];
  }
  return own;
}

/// Q times a vector of few rows, in the time that these take. Both sums are zero before and after.
SparseRow FetiSet::scaled(const SparseRow& openings, SparseSum& entries, SparseSum& rows) const
{
  for (const auto& [i, opening] : openings) {
    entries.add(weighted_.rows[std::size_t(i)], opening);
    rows.add(i, diagonalShare / weighted_.gramDiagonal[std::size_t(i)] * opening);
  }
  bodies_.bodyByBody(
      entries.take(), [&](std::size_t body, const Vector& own) { return stiffOnClosed(body, own); },
      [&](std::size_t entry, double force) { rows.add(spreadUsers_[entry], force); });
  return rows.take();
}

/// G Q G^T, whose entries are those of bodies near each other.
void FetiSet::factorCoarse()
{
  if (bodies_.numMotions() == 0)
    return;
  G_ = bodies_.motionColumns(users_, int(rows_.size()));
  SparseSum entries(network_.size()), rows(G_.rows());
  const SymmetricEntries coarse = coarseEntries(
      G_, [&](const SparseRow& openings) { return scaled(openings, entries, rows); }, QG_);
  try {
    coarse_ = std::make_unique<SparseCholesky>(coarse);
  } catch (const NotPositiveDefinite&) {
    isLoose_ = true;
    holdLoosely(coarse);
  }
  projects_ = true;
}

/// Springs that hold what the rows leave free, soft enough for a few steps of refinement to take them out again.
void FetiSet::holdLoosely(SymmetricEntries coarse)
{
  springs_.assign(std::size_t(coarse.size), 0.0);
  for (std::size_t e = 0; e < coarse.values.size(); ++e)
    if (coarse.rows[e] == coarse.columns[e])
      springs_[std::size_t(coarse.rows[e])] += spring * coarse.values[e];
  const double least = spring * std::max(largestEntry(springs_), std::numeric_limits<double>::min());
  for (std::size_t j = 0; j < springs_.size(); ++j) {
    springs_[j] = std::max(springs_[j], least);
    coarse.add(int(j), int(j), springs_[j]);
  }
  try {
    coarse_ = std::make_unique<SparseCholesky>(coarse);
  } catch (const NotPositiveDefinite&) { // hardly held, and yet not free
    coarse_ = nullptr;
  }
}

/// (G Q G^T)^-1 x, for an x that forces on the rows can do.
Vector FetiSet::solveCoarse(const Vector& x) const
{
  Vector a = coarse_->solve(x);
  for (int step = 0; isLoose_ && step < refinements; ++step) {
    Vector rest = x;
    rest = difference(std::move(rest), G_.transposedTimes(QG_.times(a)));
    const Vector change = coarse_->solve(rest);
    for (std::size_t j = 0; j < a.size(); ++j)
      a[j] += change[j];
  }
  return a;
}

bool FetiSet::canBalance(const Vector& x) const
{
  if (!isLoose_)
    return true;
  if (coarse_ == nullptr)
    return false;
  Vector rest = x;
  rest = difference(std::move(rest), G_.transposedTimes(balancing(x)));
  return largestEntry(rest) <= unbalanced * largestEntry(x);
}

Vector FetiSet::amplitudes(const Vector& w, const Vector& before) const
{
  Vector right = QG_.transposedTimes(w);
  if (!isLoose_)
    return coarse_->solve(right);
  for (std::size_t j = 0; j < right.size(); ++j)
    right[j] += springs_[j] * before[j];
  Vector a = coarse_->solve(right), rest = w;
  rest = difference(std::move(rest), G_.times(a));
  const Vector change = solveCoarse(QG_.transposedTimes(rest)); // without what the springs took
  for (std::size_t j = 0; j < a.size(); ++j)
    a[j] += change[j];
  return a;
}

Vector FetiSet::jump(const Vector& v) const
{
  Vector values;
  for (const int row : rows_) {
    double sum = 0.0;
    for (const auto& [entry, value] : network_.jump[std::size_t(row)])
      sum += value * v[std::size_t(entry)];
    values.push_back(sum);
  }
  return values;
}

Vector FetiSet::pushed(const Vector& r) const
{
  Vector f(std::size_t(network_.size()), 0.0);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (const auto& [entry, value] : network_.jump[std::size_t(rows_[i])])
      f[std::size_t(entry)] += value * r[i];
  return f;
}

Vector FetiSet::preconditioned(const Vector& w) const
{
  Vector v(std::size_t(network_.size()), 0.0), r;
  for (std::size_t i = 0; i < w.size(); ++i)
    for (const auto& [entry, share] : weighted_.rows[i])
      v[std::size_t(entry)] += share * w[i];
  const Vector f = bodies_.bodyByBody(v, [&](std::size_t b, const Vector& own) { return stiffOnClosed(b, own); });
  for (const SparseRow& row : weighted_.rows) {
    r.push_back(0.0);
    for (const auto& [entry, share] : row)
      r.back() += share * f[std::size_t(entry)];
  }
  return r;
}

Vector FetiSet::projected(Vector r) const
{
  if (projects())
    r = difference(r, balancing(work(r)));
  return r;
}

Vector FetiSet::projectedTransposed(Vector w) const
{
  if (projects())
    w = difference(w, G_.times(solveCoarse(QG_.transposedTimes(w))));
  return w;
}

/// S with the open entries eliminated; v is zero there.
Vector FetiSet::stiffOnClosed(std::size_t body, const Vector& v) const
{
  const SymmetricOperator& S = *network_.bodies[body]->S;
  Vector f = S.apply(v);
  const std::vector<int>& open = open_[body].entries;
  if (open.empty())
    return f;
  Vector onOpen, answer(v.size(), 0.0);
  for (const int k : open)
    onOpen.push_back(f[std::size_t(k)]);
  onOpen = open_[body].factor->solve(std::move(onOpen));
  for (std::size_t i = 0; i < onOpen.size(); ++i)
    answer[std::size_t(open[i])] = onOpen[i];
  f = difference(std::move(f), S.apply(answer));
  return f;
}

} // namespace ndframe
