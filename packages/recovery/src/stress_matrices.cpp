#include "stress_matrices.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ndframe/base/lanes.hpp"
#include "ndframe/equilibrium/lane_tables.hpp"

namespace ndframe
{
void findCompliances(const StressCells& cells, const int* numbers, int count, CellMap* maps, Vector& compliances)
{
  constexpr int lanes = CellForms::lanes;
  const std::size_t entries = cells.any().reference().energy.size();
  compliances.resize(entries * lanes);
  for (int c = 0; c < lanes; ++c) {
    const int number = numbers[std::min(c, count - 1)], body = cells.bodyOf(number);
    maps[c] = cellMap(cells.mesh(number), cells.sorted(number));
    const auto own = pulledBackCompliance(maps[c], cells.body(body).model().laws(number - cells.number(body, 0)));
    for (std::size_t m = 0; m < entries; ++m)
      compliances[m * lanes + std::size_t(c)] = own[m];
  }
}

namespace
{

/// Multiplies the vectors of every lane, `count` numbers, by F^-1 or F^-T.
void multiplyByInverse(const CellMap* maps, int count, std::size_t perRow, std::size_t perColumn, double* x)
{
  constexpr std::size_t lanes = CellForms::lanes;
  for (std::size_t at = 0; at < std::size_t(count); at += 3, x += 3 * lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const auto& inverse = maps[lane].inverse;
      const double given[3] = {x[lane], x[lanes + lane], x[2 * lanes + lane]};
      for (std::size_t i = 0; i < 3; ++i)
        x[i * lanes + lane] = inverse[perRow * i] * given[0] + inverse[perRow * i + perColumn] * given[1] +
                              inverse[perRow * i + 2 * perColumn] * given[2];
    }
}

} // namespace

void pullBackLanes(const CellMap* maps, int count, double* x)
{
  multiplyByInverse(maps, count, 3, 1, x);
}

void pushLanes(const CellMap* maps, int count, double* forces)
{
  multiplyByInverse(maps, count, 1, 3, forces);
}

StressMatrices::StressMatrices(const StressCells& cells, const ClassMatrices& ofClasses)
    : cells_(&cells), ofClasses_(&ofClasses), batches_(all()),
      tractions_(std::size_t(cells.any().reference().tractions)), forms_(solidForms(cells.any().data().degree))
{
  NDFRAME_ASSERT(cells.any().reference().data() * lanes <= mostNumbers, "more data than a cell of degree 2 has");
  std::size_t count = 0, kept = 0, rounded = 0;
  for (Batch& batch : batches_)
    if (batch.number >= 0) {
      batch.number = int(count++);
      batch.at = batch.isRound ? rounded : kept;
      (batch.isRound ? rounded : kept) += batch.isRound ? forms_.roundedSize() : keptSize();
    }
  maps_.resize(count * lanes);
  scales_.resize(count * lanes);
  kept_.resize(kept);
  rounded_.resize(rounded);
}

namespace
{

/// Whether a cell is not much longer than wide: single precision leaves four digits of its forces.
bool isRound(const CellMap& map)
{
  constexpr double mostStretched = 12.0;
  const auto norm = [](const auto& matrix) {
    return std::sqrt(std::inner_product(matrix.begin(), matrix.end(), matrix.begin(), 0.0));
  };
  return norm(map.F) * norm(map.inverse) < mostStretched;
}

} // namespace

/// By their first cells. Which cells are side by side changes nothing but round-off.
std::vector<StressMatrices::Batch> StressMatrices::all() const
{
  std::vector<Batch> batches;
  const auto classes = std::size_t(cells_->classes().size());
  std::vector<int> open(classes + 2, -1); // per class, and of cells without one, stretched and round
  for (int cell = 0; cell < cells_->size(); ++cell) {
    if (!cells_->isOwn(cell))
      continue;
    const bool isOfClass = ofClasses_->has(cell),
               round = !isOfClass && isRound(cellMap(cells_->mesh(cell), cells_->sorted(cell)));
    int& batch = open[isOfClass ? std::size_t(cells_->classes().of(cell)) : classes + std::size_t(round)];
    if (batch < 0 || batches[std::size_t(batch)].count == lanes) {
      batch = int(batches.size());
      batches.push_back({{}, 0, isOfClass ? -1 : 0, 0, round});
    }
    Batch& place = batches[std::size_t(batch)];
    place.cells[std::size_t(place.count++)] = cell;
  }
  return batches;
}

void StressMatrices::find(int number, Vector& work, const std::function<void(const CellFacets&)>& use)
{
  const Batch& batch = batches_[std::size_t(number)];
  const auto first = std::size_t(batch.number) * lanes;
  Vector own;
  findCompliances(*cells_, batch.cells.data(), batch.count, maps_.data() + first, own);
  const CellFacets all = found(batch, own, work);
  if (batch.isRound)
    forms_.round(own.data(), all.facets.factor, rounded_.data() + batch.at, scales_.data() + first);
  else {
    std::copy(own.begin(), own.end(), kept_.begin() + std::ptrdiff_t(batch.at));
    std::copy_n(all.facets.factor, forms_.factorSize() * lanes, kept_.data() + batch.at + compliances());
  }
  use(all);
}

CellFacets StressMatrices::found(const Batch& batch, Vector& compliances, Vector& work) const
{
  return {batch.cells.data(), batch.count, maps_.data() + std::size_t(batch.number) * lanes, compliances.data(),
          forms_.facets(compliances.data(), work)};
}

/// Of all lanes with the matrix of their class.
void StressMatrices::multiplyClass(const Batch& batch, std::size_t columns, const double* x, double* forces) const
{
  multiplyTable(ofClasses_->of(batch.cells[0]), std::size_t(ofClasses_->columns()), tractions_, columns, x, forces);
  std::array<double, lanes> scale{};
  for (std::size_t lane = 0; lane < std::size_t(batch.count); ++lane)
    scale[lane] = cells_->classes().scale(batch.cells[lane]);
  for (std::size_t at = 0; at < tractions_; ++at)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      forces[at * lanes + lane] *= scale[lane];
}

void StressMatrices::multiplyFound(const CellFacets& found, std::size_t columns, const double* x, double* forces) const
{
  std::array<double, mostNumbers> pulled{};
  std::copy_n(x, columns * lanes, pulled.data());
  pullBackLanes(found.maps, int(columns), pulled.data());
  forms_.apply(found.compliances, found.facets.factor, pulled.data(), columns, forces);
  pushLanes(found.maps, int(tractions_), forces);
}

void StressMatrices::multiplyRounded(const Batch& batch, const double* T, double* forces) const
{
  const auto first = std::size_t(batch.number) * lanes;
  std::array<double, mostNumbers> pulled{};
  std::copy_n(T, tractions_ * lanes, pulled.data());
  pullBackLanes(maps_.data() + first, int(tractions_), pulled.data());
  forms_.applyRounded(rounded_.data() + batch.at, scales_.data() + first, pulled.data(), forces);
  pushLanes(maps_.data() + first, int(tractions_), forces);
}

void StressMatrices::multiplyData(int number, const double* x, double* forces) const
{
  multiplyClass(batches_[std::size_t(number)], std::size_t(ofClasses_->columns()), x, forces);
}

void StressMatrices::multiplyData(const CellFacets& found, const double* x, double* forces) const
{
  multiplyFound(found, std::size_t(ofClasses_->columns()), x, forces);
}

/// Cells that are kept in single precision are found again for all digits.
void StressMatrices::multiply(int number, const double* T, double* forces, Digits digits) const
{
  const Batch& batch = batches_[std::size_t(number)];
  if (batch.number < 0)
    return multiplyClass(batch, tractions_, T, forces);
  if (batch.isRound && digits == Digits::Few)
    return multiplyRounded(batch, T, forces);
  const CellMap* maps = maps_.data() + std::size_t(batch.number) * lanes;
  if (!batch.isRound) {
    const double* kept = kept_.data() + batch.at;
    return multiplyFound({batch.cells.data(), batch.count, maps, kept, {nullptr, nullptr, kept + compliances()}},
                         tractions_, T, forces);
  }
  std::array<CellMap, lanes> same;
  Vector own, work;
  findCompliances(*cells_, batch.cells.data(), batch.count, same.data(), own);
  multiplyFound(found(batch, own, work), tractions_, T, forces);
}

} // namespace ndframe
