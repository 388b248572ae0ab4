#include "feti_set.hpp"

namespace ndframe
{
namespace
{

constexpr double diagonalShare = 0.1; ///< of the diagonal in Q: without it G Q G^T may lose rank
constexpr double elimination = 1e-10; ///< added to what open entries hold, relative: they may not hold the body

void subtract(Vector& a, const Vector& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] -= b[i];
}

} // namespace

FetiSet::FetiSet(const Network& network, const FetiBodies& bodies, const std::vector<char>& closed)
    : network_(network), bodies_(bodies), closed_(closed)
{
  std::vector<int> chosen;
  for (std::size_t i = 0; i < closed.size(); ++i)
    if (closed[i])
      chosen.push_back(int(i));
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](int a, int b) { return network.bound[std::size_t(a)] < network.bound[std::size_t(b)]; });
  rows_ = ClosedRows(network.jump, chosen, network.bound, network.size()).independentRows();
  weighRows();
  condenseBodies();
  factorCoarse();
}

/// B D^-1 B^T: blocks of the rows that share a node.
void FetiSet::weighRows()
{
  std::vector<SparseRow> users(std::size_t(network_.size()));
  for (std::size_t i = 0; i < rows_.size(); ++i)
    for (const auto& [entry, value] : network_.jump[std::size_t(rows_[i])])
      users[std::size_t(entry)].emplace_back(int(i), value);
  SymmetricEntries gram;
  gram.size = int(rows_.size());
  gramDiagonal_.assign(rows_.size(), 0.0);
  touched_.assign(users.size(), 0);
  for (std::size_t entry = 0; entry < users.size(); ++entry)
    for (const auto& [i, first] : users[entry])
      for (const auto& [j, second] : users[entry]) {
        const double value = first * second / bodies_.weight()[entry];
        touched_[entry] = 1;
        if (i == j)
          gramDiagonal_[std::size_t(i)] += value;
        if (i <= j)
          gram.add(i, j, value);
      }
  gram_ = std::make_unique<SparseCholesky>(gram);
}

/// Where a body has open entries: the factor of its stiffness on them.
void FetiSet::condenseBodies()
{
  for (std::size_t b = 0; b < network_.bodies.size(); ++b) {
    std::vector<int> open;
    for (int k = network_.offsets[b]; k < network_.offsets[b + 1]; ++k)
      if (!touched_[std::size_t(k)])
        open.push_back(k - network_.offsets[b]);
    const DenseMatrix& S = *network_.bodies[b]->S->dense();
    DenseMatrix own(int(open.size()), int(open.size()));
    for (int j = 0; j < own.cols(); ++j) {
      for (int i = 0; i < own.rows(); ++i)
        own(i, j) = S(open[std::size_t(i)], open[std::size_t(j)]);
      own(j, j) += elimination * bodies_.weight()[std::size_t(network_.offsets[b] + open[std::size_t(j)])];
    }
    openFactor_.push_back(open.empty() ? nullptr : std::make_unique<DenseCholesky>(std::move(own)));
    open_.push_back(std::move(open));
  }
}

/// G Q G^T; no factor where some motion is left free.
void FetiSet::factorCoarse()
{
  const int n = bodies_.numMotions();
  if (n == 0)
    return;
  SymmetricEntries coarse;
  coarse.size = n;
  G_ = QG_ = SparseColumns(int(rows_.size()), n);
  for (int j = 0; j < n; ++j) {
    Vector unit(std::size_t(n), 0.0);
    unit[std::size_t(j)] = 1.0;
    const Vector column = jump(bodies_.moved(unit)), answer = scaled(column);
    G_.setColumn(j, column);
    QG_.setColumn(j, answer);
    const Vector products = G_.transposedTimes(answer);
    for (int i = 0; i <= j; ++i)
      if (i == j || products[std::size_t(i)] != 0.0)
        coarse.add(i, j, products[std::size_t(i)]);
  }
  try {
    coarse_ = std::make_unique<SparseCholesky>(coarse);
  } catch (const NotPositiveDefinite&) {
    coarse_ = nullptr;
  }
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
  const Vector& D = bodies_.weight();
  Vector v = pushed(gram_->solve(w));
  for (std::size_t k = 0; k < v.size(); ++k)
    v[k] /= D[k];
  Vector f = bodies_.bodyByBody(v, [&](std::size_t b, const Vector& own) { return stiffOnClosed(b, own); });
  for (std::size_t k = 0; k < f.size(); ++k)
    f[k] /= D[k];
  return gram_->solve(jump(f));
}

/// Q w.
Vector FetiSet::scaled(const Vector& w) const
{
  Vector r = preconditioned(w);
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] += diagonalShare / gramDiagonal_[i] * w[i];
  return r;
}

Vector FetiSet::projected(Vector r) const
{
  if (projects())
    subtract(r, balancing(work(r)));
  return r;
}

Vector FetiSet::projectedTransposed(Vector w) const
{
  if (projects())
    subtract(w, G_.times(amplitudes(w)));
  return w;
}

/// S with the open entries eliminated; v is zero there.
Vector FetiSet::stiffOnClosed(std::size_t body, const Vector& v) const
{
  const SymmetricOperator& S = *network_.bodies[body]->S;
  Vector f = S.apply(v);
  if (open_[body].empty())
    return f;
  Vector onOpen, answer(v.size(), 0.0);
  for (const int k : open_[body])
    onOpen.push_back(f[std::size_t(k)]);
  onOpen = openFactor_[body]->solve(std::move(onOpen));
  for (std::size_t i = 0; i < onOpen.size(); ++i)
    answer[std::size_t(open_[body][i])] = onOpen[i];
  subtract(f, S.apply(answer));
  return f;
}

} // namespace ndframe
