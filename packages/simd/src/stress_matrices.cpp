#include "ndframe/simd/stress_matrices.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/equilibrium/lane_tables.hpp"
#include "ndframe/simd/block_kernels.hpp"

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
  std::size_t kept = 0, rounded = 0;
  for (Batch& batch : batches_)
    if (batch.number >= 0)
      batch.number = int(batch.isRound ? rounded++ : kept++);
  maps_.resize(kept * lanes);
  scales_.resize(rounded * lanes);
  kept_.resize(kept * keptSize());
  rounded_.resize(rounded * roundedSize());
}

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
      batches.push_back({{}, 0, isOfClass ? -1 : 0, round});
    }
    Batch& place = batches[std::size_t(batch)];
    place.cells[std::size_t(place.count++)] = cell;
  }
  return batches;
}

void StressMatrices::find(int number, Vector& work, const std::function<void(const CellFacets&)>& use)
{
  const Batch& batch = batches_[std::size_t(number)];
  const auto place = std::size_t(batch.number);
  Vector own;
  std::array<CellMap, lanes> maps;
  findCompliances(*cells_, batch.cells.data(), batch.count, maps.data(), own);
  const CellFacets all{batch.cells.data(), batch.count, maps.data(), own.data(), forms_.facets(own.data(), work)};
  if (batch.isRound) {
    forms_.round(own.data(), all.facets.factor, rounded_.data() + place * roundedSize(),
                 scales_.data() + place * lanes);
    roundMaps(batch, maps.data());
  } else {
    std::copy(maps.begin(), maps.end(), maps_.data() + place * lanes);
    std::copy(own.begin(), own.end(), kept_.data() + place * keptSize());
    std::copy_n(all.facets.factor, forms_.factorSize() * lanes, kept_.data() + place * keptSize() + compliances());
  }
  use(all);
}

/// F^-1 in single precision, its largest entry one; the scales take that in: of compliances, to be divided by.
void StressMatrices::roundMaps(const Batch& batch, const CellMap* maps)
{
  float* inverse = rounded_.data() + std::size_t(batch.number) * roundedSize() + forms_.roundedSize();
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    double largest = 0.0;
    for (const double entry : maps[lane].inverse)
      largest = std::max(largest, std::abs(entry));
    for (std::size_t k = 0; k < 9; ++k)
      inverse[k * lanes + lane] = float(maps[lane].inverse[k] / largest);
    double& scale = scales_[std::size_t(batch.number) * lanes + lane];
    scale /= largest * largest;
  }
}

/// Of all lanes with the matrix of their class.
void StressMatrices::multiplyClass(const Batch& batch, std::size_t size, const double* x, double* forces) const
{
  multiplyTable(ofClasses_->of(batch.cells[0]), std::size_t(ofClasses_->columns()), size, size, x, forces);
  std::array<double, lanes> scale{};
  for (std::size_t lane = 0; lane < std::size_t(batch.count); ++lane)
    scale[lane] = cells_->classes().scale(batch.cells[lane]);
  for (std::size_t at = 0; at < size; ++at)
    for (std::size_t lane = 0; lane < lanes; ++lane)
      forces[at * lanes + lane] *= scale[lane];
}

void StressMatrices::multiplyFound(const CellFacets& found, std::size_t size, const double* x, double* forces) const
{
  std::array<double, mostNumbers> pulled{};
  std::copy_n(x, size * lanes, pulled.data());
  pullBackLanes(found.maps, int(size), pulled.data());
  forms_.apply(found.compliances, found.facets.factor, pulled.data(), size, forces);
  pushLanes(found.maps, int(size), forces);
}

/// Of cells without a class.
void StressMatrices::pushRounded(const Batch& batch, double unit, const float* T, float* forces) const
{
  const float* numbers = rounded_.data() + std::size_t(batch.number) * roundedSize();
  std::array<float, mostNumbers> pulled;
  std::array<float, lanes> units{};
  for (std::size_t lane = 0; lane < lanes; ++lane)
    units[lane] = float(unit / scales_[std::size_t(batch.number) * lanes + lane]);
  block_kernels::pullBack(numbers + forms_.roundedSize(), T, tractions_, pulled.data());
  forms_.applyRounded(numbers, pulled.data(), forces);
  block_kernels::push(numbers + forms_.roundedSize(), units.data(), tractions_, forces);
}

void StressMatrices::multiplyRounded(int number, double unit, const float* T, float* forces) const
{
  const Batch& batch = batches_[std::size_t(number)];
  const auto count = std::size_t(batch.count);
  if (const float* table = batch.number < 0 ? ofClasses_->rounded(batch.cells[0]) : nullptr; table != nullptr) {
    const double ofClass = unit * ofClasses_->unit(batch.cells[0]);
    for (std::size_t c = 0; c < count; ++c)
      block_kernels::multiplyCell(table, T + c * tractions_, tractions_,
                                  float(ofClass * cells_->classes().scale(batch.cells[c])), forces + c * tractions_);
    return;
  }
  const auto besides = [&](const auto& given, auto& sideBySide) {
    for (std::size_t c = 0; c < count; ++c)
      for (std::size_t i = 0; i < tractions_; ++i)
        sideBySide[i * lanes + c] = given[c * tractions_ + i];
  };
  const auto apart = [&](const auto& sideBySide, double factor) {
    for (std::size_t c = 0; c < count; ++c)
      for (std::size_t i = 0; i < tractions_; ++i)
        forces[c * tractions_ + i] = float(factor * double(sideBySide[i * lanes + c]));
  };
  if (batch.isRound && batch.number >= 0) {
    std::array<float, mostNumbers> x{}, result;
    besides(T, x);
    pushRounded(batch, unit, x.data(), result.data());
    return apart(result, 1.0);
  }
  std::array<double, mostNumbers> x{}, result;
  besides(T, x);
  multiply(number, x.data(), result.data());
  apart(result, unit);
}

void StressMatrices::multiplyData(int number, const double* x, double* forces) const
{
  multiplyClass(batches_[std::size_t(number)], std::size_t(ofClasses_->columns()), x, forces);
}

void StressMatrices::multiplyData(const CellFacets& found, const double* x, double* forces) const
{
  multiplyFound(found, std::size_t(ofClasses_->columns()), x, forces);
}

/// Cells that are kept in single precision are found again.
void StressMatrices::multiply(int number, const double* T, double* forces) const
{
  const Batch& batch = batches_[std::size_t(number)];
  if (batch.number < 0)
    return multiplyClass(batch, tractions_, T, forces);
  if (!batch.isRound) {
    const double* kept = kept_.data() + std::size_t(batch.number) * keptSize();
    const CellMap* maps = maps_.data() + std::size_t(batch.number) * lanes;
    return multiplyFound({batch.cells.data(), batch.count, maps, kept, {nullptr, nullptr, kept + compliances()}},
                         tractions_, T, forces);
  }
  std::array<CellMap, lanes> maps;
  Vector own, work;
  findCompliances(*cells_, batch.cells.data(), batch.count, maps.data(), own);
  multiplyFound({batch.cells.data(), batch.count, maps.data(), own.data(), forms_.facets(own.data(), work)}, tractions_,
                T, forces);
}

} // namespace ndframe
