#include "ndframe/equilibrium/star_balance.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/assembly/rigid_modes.hpp"

namespace ndframe
{
namespace
{

double starSize(const Mesh& mesh, const Star& star)
{
  double largest = 0.0;
  const double* a = mesh.point(star.vertex);
  for (const StarCell& cell : star.cells)
    for (int v = 0; v <= mesh.dim; ++v) {
      const double* b = mesh.point(cell.sorted.vertices[std::size_t(v)]);
      double squares = 0.0;
      for (int i = 0; i < mesh.dim; ++i)
        squares += (b[i] - a[i]) * (b[i] - a[i]);
      largest = std::max(largest, squares);
    }
  return std::sqrt(largest);
}

bool isZero(const double* values, int count)
{
  return std::all_of(values, values + count, [](double value) { return value == 0.0; });
}

} // namespace

StarBalance::StarBalance(const StarBody& body, Star star, const std::vector<ReleasedFacet>& released)
    : body_(&body), star_(std::move(star)), tree_(spanningTree(star_))
{
  splitSpokes();
  for (const GroundTraction& reaction : reactions(body, star_))
    (reaction.carriesWrench(body.dim()) ? ground_ : held_).push_back(reaction);
  const auto chosen = releasedTractions(body, star_, released);
  ground_.insert(ground_.end(), chosen.begin(), chosen.end());
  numReleased_ = int(chosen.size());
  for (int s = 0; s < int(star_.spokes.size()); ++s)
    if (!star_.spokes[std::size_t(s)].onBoundary() && tree_.used[std::size_t(s)] == 0)
      chords_.push_back(s);
  eliminateReactions();
  numberUnknowns();
}

void StarBalance::splitSpokes()
{
  const Mesh& mesh = body_->model().mesh;
  const double* a = mesh.point(star_.vertex);
  const double size = starSize(mesh, star_);
  for (const Spoke& spoke : star_.spokes) {
    const SortedCell& cell = star_.cells[std::size_t(spoke.cell[0])].sorted;
    const Vector arms = momentArms(body_->facetMeans(), corners(mesh, cell, spoke.facet[0]), a, mesh.dim);
    splits_.push_back(splitFacet(mesh.dim, arms, body_->facetModes(), size));
  }
  for (const StarCell& cell : star_.cells) {
    const Vector arms = momentArms(body_->cellMeans(), corners(mesh, cell.sorted, -1), a, mesh.dim);
    loadMaps_.push_back(wrenchMap(mesh.dim, arms, body_->loadModes(), size));
  }
}

Vector StarBalance::wrench(const GroundTraction& traction) const
{
  Vector moments(std::size_t(body_->facetData()), 0.0);
  traction.addTo(moments.data(), body_->dim(), 1.0);
  return multiply(splits_[std::size_t(traction.spoke)].map, moments);
}

/// The ground must take the sum of all cells' wrenches: it determines as many reactions as it has rank, the first ones
/// found; rows without a pivot are conditions on the released tractions and on the data.
void StarBalance::eliminateReactions()
{
  const int w = wrenchSize(body_->dim()), columns = int(ground_.size());
  DenseMatrix rows(w, columns + w);
  for (int j = 0; j < columns; ++j) {
    const Vector column = wrench(ground_[std::size_t(j)]);
    std::copy(column.begin(), column.end(), rows.col(j));
  }
  for (int i = 0; i < w; ++i)
    rows(i, columns + i) = 1.0;
  reduction_ = reduceRows(std::move(rows), columns - numReleased_, rigidTolerance);
  for (int flow = 0; flow < numFlows(); ++flow) {
    const int ground = flow - groundFlow(0);
    const bool dependent = ground >= 0 && std::count(reduction_.pivot.begin(), reduction_.pivot.end(), ground) > 0;
    columnOfFlow_.push_back(dependent ? -1 : numFree_);
    numFree_ += dependent ? 0 : 1;
  }
  numFree_ -= numReleased_;
}

DenseMatrix StarBalance::conditions() const
{
  const int first = int(ground_.size()) - numReleased_;
  DenseMatrix rows(wrenchSize(body_->dim()) - reduction_.rank(), numReleased_);
  int next = 0;
  for (std::size_t row = 0; row < reduction_.pivot.size(); ++row) {
    if (reduction_.pivot[row] >= 0)
      continue;
    for (int j = 0; j < numReleased_; ++j)
      rows(next, j) = reduction_.matrix(int(row), first + j);
    ++next;
  }
  return rows;
}

/// Per tree spoke the wrench that each flow, set to one, sends through it.
std::vector<DenseMatrix> StarBalance::unitFlows() const
{
  const int w = wrenchSize(body_->dim());
  std::vector<DenseMatrix> needed(star_.cells.size(), DenseMatrix(w, numFlows()));
  for (std::size_t k = 0; k < chords_.size(); ++k) {
    const Spoke& spoke = star_.spokes[std::size_t(chords_[k])];
    for (int i = 0; i < w; ++i) {
      needed[std::size_t(spoke.cell[0])](i, int(k) * w + i) -= 1.0;
      needed[std::size_t(spoke.cell[1])](i, int(k) * w + i) += 1.0;
    }
  }
  for (std::size_t j = 0; j < ground_.size(); ++j) {
    const Vector given = wrench(ground_[j]);
    for (int i = 0; i < w; ++i)
      needed[std::size_t(star_.spokes[std::size_t(ground_[j].spoke)].cell[0])](i, groundFlow(j)) -=
          given[std::size_t(i)];
  }
  return carryAlongTree(star_, tree_, needed);
}

/// Adds the traction that goes with a flow to the columns of what the flow depends on.
void StarBalance::addFlow(int flow, const double* traction, DenseMatrix& columns) const
{
  const auto addTo = [&](int column, double factor) {
    for (int i = 0; i < columns.rows(); ++i)
      columns(i, column) += factor * traction[i];
  };
  if (columnOfFlow_[std::size_t(flow)] >= 0)
    return addTo(columnOfFlow_[std::size_t(flow)], 1.0);
  const auto& pivot = reduction_.pivot;
  const int row = int(std::find(pivot.begin(), pivot.end(), flow - groundFlow(0)) - pivot.begin());
  for (std::size_t j = 0; j < ground_.size(); ++j)
    if (const int column = columnOfFlow_[std::size_t(groundFlow(j))]; column >= 0)
      addTo(column, -reduction_.matrix(row, int(j)));
}

/// Columns of the free flows and the released tractions.
DenseMatrix StarBalance::flowColumns(int spoke, const DenseMatrix& flows) const
{
  const int w = wrenchSize(body_->dim());
  const FacetSplit& split = splits_[std::size_t(spoke)];
  DenseMatrix columns(body_->facetData(), numFree_ + numReleased_);
  const DenseMatrix carried = multiply(split.carrier, flows);
  for (int flow = 0; flow < carried.cols(); ++flow)
    if (!isZero(carried.col(flow), carried.rows()))
      addFlow(flow, carried.col(flow), columns);
  for (std::size_t k = 0; k < chords_.size(); ++k)
    for (int i = 0; i < w && chords_[k] == spoke; ++i)
      addFlow(int(k) * w + i, split.carrier.col(i), columns);
  for (std::size_t j = 0; j < ground_.size(); ++j)
    if (ground_[j].spoke == spoke) {
      Vector traction(std::size_t(body_->facetData()), 0.0);
      ground_[j].addTo(traction.data(), body_->dim(), 1.0);
      addFlow(groundFlow(j), traction.data(), columns);
    }
  return columns;
}

/// Columns of the unknowns that this spoke has alone.
DenseMatrix StarBalance::ownColumns(int spoke) const
{
  if (!star_.spokes[std::size_t(spoke)].onBoundary())
    return splits_[std::size_t(spoke)].modes;
  std::vector<GroundTraction> own;
  std::copy_if(held_.begin(), held_.end(), std::back_inserter(own),
               [spoke](const GroundTraction& traction) { return traction.spoke == spoke; });
  DenseMatrix columns(body_->facetData(), int(own.size()));
  for (std::size_t j = 0; j < own.size(); ++j)
    own[j].addTo(columns.col(int(j)), body_->dim(), 1.0);
  return columns;
}

void StarBalance::numberUnknowns()
{
  const std::vector<DenseMatrix> flows = unitFlows();
  std::vector<DenseMatrix> own;
  numUnknowns_ = numFree_ + numReleased_;
  for (int s = 0; s < int(star_.spokes.size()); ++s) {
    own.push_back(ownColumns(s));
    numUnknowns_ += own.back().cols();
  }
  int next = numFree_;
  for (int s = 0; s < int(star_.spokes.size()); ++s) {
    const DenseMatrix shared = flowColumns(s, flows[std::size_t(s)]);
    SpokeColumns spoke;
    std::vector<const double*> columns;
    for (int j = 0; j < shared.cols(); ++j)
      if (!isZero(shared.col(j), shared.rows())) {
        spoke.unknowns.push_back(j < numFree_ ? j : numUnknowns_ - numReleased_ + j - numFree_);
        columns.push_back(shared.col(j));
      }
    for (int j = 0; j < own[std::size_t(s)].cols(); ++j) {
      spoke.unknowns.push_back(next++);
      columns.push_back(own[std::size_t(s)].col(j));
    }
    spoke.columns = DenseMatrix(body_->facetData(), int(columns.size()));
    for (std::size_t j = 0; j < columns.size(); ++j)
      std::copy_n(columns[j], body_->facetData(), spoke.columns.col(int(j)));
    spokes_.push_back(std::move(spoke));
  }
}

/// The wrench that a cell's loads have and its tractions lack, per field.
DenseMatrix StarBalance::imbalance(int cell, const StarFields& x) const
{
  const int data = body_->reference().data(), facetData = body_->facetData(), begin = cell * data;
  DenseMatrix sum(wrenchSize(body_->dim()), x.cols());
  const auto add = [&](const DenseMatrix& map, int first, double factor) {
    for (int field = 0; field < x.cols(); ++field)
      for (int j = 0; j < map.cols(); ++j)
        for (int i = 0; i < map.rows(); ++i)
          sum(i, field) += factor * map(i, j) * x(first + j, field);
  };
  add(loadMaps_[std::size_t(cell)], begin + body_->reference().tractions, 1.0);
  for (std::size_t s = 0; s < splits_.size(); ++s)
    for (std::size_t side = 0; side < 2; ++side)
      if (star_.spokes[s].cell[side] == cell)
        add(splits_[s].map, begin + star_.spokes[s].facet[side] * facetData, -1.0);
  return sum;
}

/// Lets the dependent reactions take the wrench of the whole star.
void StarBalance::addReactions(StarFields& x, std::vector<DenseMatrix>& needed) const
{
  const int w = wrenchSize(body_->dim()), data = body_->reference().data(), columns = int(ground_.size());
  DenseMatrix total(w, x.cols());
  for (const DenseMatrix& cell : needed)
    for (int field = 0; field < x.cols(); ++field)
      for (int i = 0; i < w; ++i)
        total(i, field) += cell(i, field);
  for (std::size_t row = 0; row < reduction_.pivot.size(); ++row) {
    if (reduction_.pivot[row] < 0)
      continue;
    const GroundTraction& reaction = ground_[std::size_t(reduction_.pivot[row])];
    const Spoke& spoke = star_.spokes[std::size_t(reaction.spoke)];
    const Vector unit = wrench(reaction);
    for (int field = 0; field < x.cols(); ++field) {
      double amount = 0.0;
      for (int i = 0; i < w; ++i)
        amount += reduction_.matrix(int(row), columns + i) * total(i, field);
      reaction.addTo(x.col(field) + std::ptrdiff_t(spoke.cell[0]) * data +
                         std::ptrdiff_t(spoke.facet[0]) * body_->facetData(),
                     body_->dim(), amount);
      for (int i = 0; i < w; ++i)
        needed[std::size_t(spoke.cell[0])](i, field) -= amount * unit[std::size_t(i)];
    }
  }
}

Vector StarBalance::balance(StarFields& x) const
{
  const int data = body_->reference().data(), facetData = body_->facetData();
  std::vector<DenseMatrix> needed;
  for (int cell = 0; cell < int(star_.cells.size()); ++cell)
    needed.push_back(imbalance(cell, x));
  addReactions(x, needed);
  const std::vector<DenseMatrix> flows = carryAlongTree(star_, tree_, needed);
  for (std::size_t s = 0; s < flows.size(); ++s) {
    if (tree_.used[s] == 0)
      continue;
    const Spoke& spoke = star_.spokes[s];
    const DenseMatrix traction = multiply(splits_[s].carrier, flows[s]);
    for (int field = 0; field < x.cols(); ++field)
      for (int i = 0; i < facetData; ++i) {
        x(spoke.cell[0] * data + spoke.facet[0] * facetData + i, field) += traction(i, field);
        x(spoke.cell[1] * data + spoke.facet[1] * facetData + i, field) -= traction(i, field);
      }
  }
  Vector left;
  for (int field = 0; field < x.cols(); ++field)
    left.push_back(norm(needed[std::size_t(tree_.order[0])].column(field)));
  return left;
}

} // namespace ndframe
