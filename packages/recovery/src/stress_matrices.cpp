#include "stress_matrices.hpp"

#include <algorithm>

#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t most = 72; ///< tractions of a cell, degree 2

/// y += A x, lane by lane, from the columns of A below its diagonal.
template <class Lanes, class Number>
inline __attribute__((always_inline)) void addSymmetric(const Number* triangle, const Number* x, Number* y,
                                                        std::size_t size)
{
  constexpr std::size_t lanes = sizeof(Lanes) / sizeof(Number);
  Lanes here, sum, entry, value;
  for (std::size_t j = 0; j < size; ++j, triangle += lanes) {
    load(x + j * lanes, here);
    load(y + j * lanes, sum);
    load(triangle, entry);
    sum += entry * here;
    for (std::size_t i = j + 1; i < size; ++i) {
      load(triangle += lanes, entry);
      load(y + i * lanes, value);
      store(value + entry * here, y + i * lanes);
      load(x + i * lanes, value);
      sum += entry * value;
    }
    store(sum, y + j * lanes);
  }
}

NDFRAME_EVERY_PROCESSOR void multiplySingle(const float* triangle, const float* x, float* y, std::size_t size)
{
  addSymmetric<FloatLanes>(triangle, x, y, size);
}

NDFRAME_EVERY_PROCESSOR void multiplyDouble(const double* triangle, const double* x, double* y, std::size_t size)
{
  addSymmetric<DoubleLanes>(triangle, x, y, size);
}

} // namespace

void CellMatrices::multiply(const double* x, double* forces) const
{
  multiplyDouble(triangle, x, forces, std::size_t(size));
}

void pullBack(const CellMap& map, const double* vector, double* result)
{
  for (std::size_t i = 0; i < 3; ++i)
    result[i] =
        map.inverse[3 * i] * vector[0] + map.inverse[3 * i + 1] * vector[1] + map.inverse[3 * i + 2] * vector[2];
}

void addPushed(const CellMap& map, const double* forces, int count, double* sum)
{
  for (int at = 0; at < count; at += 3)
    for (std::size_t i = 0; i < 3; ++i)
      sum[at + int(i)] +=
          map.inverse[i] * forces[at] + map.inverse[3 + i] * forces[at + 1] + map.inverse[6 + i] * forces[at + 2];
}

StressMatrices::StressMatrices(const StarBody& body, int first, int last)
    : body_(&body), first_(first), last_(last), tractions_(std::size_t(body.reference().tractions)),
      forms_(body.reference()), maps_(std::size_t(last - first) * lanes),
      triangles_(new float[std::size_t(last - first) * batchSize()]) // they are all found, but in lanes without a cell
{
  NDFRAME_ASSERT(tractions_ <= most, "more data than a cell of degree 2 has");
  if (first < last)
    std::fill_n(triangles(last - 1), batchSize(), 0.0F);
}

void StressMatrices::find(int first, int last, const std::function<void(const CellMatrices&)>& use)
{
  constexpr int wide = CellForms::lanes;
  const Mesh& mesh = body_->model().mesh;
  const std::size_t entries = body_->reference().energy.size();
  Vector compliances(entries * wide), work;
  for (int cell = first * lanes; cell < std::min(last * lanes, mesh.numCells()); cell += wide) {
    CellMatrices found{cell, std::min(wide, mesh.numCells() - cell), maps_.data() + (cell - first_ * lanes), nullptr,
                       body_->reference().data()};
    for (int c = 0; c < wide; ++c) { // lanes without a cell repeat the last one
      const int number = cell + std::min(c, found.count - 1);
      CellMap& map = maps_[std::size_t(number) - std::size_t(first_) * lanes] = cellMap(mesh, sortedCell(mesh, number));
      const auto own = pulledBackCompliance(map, body_->model().laws(number));
      for (std::size_t m = 0; m < entries; ++m)
        compliances[m * wide + std::size_t(c)] = own[m];
    }
    found.triangle = forms_.condensed(compliances.data(), work);
    keep(found);
    use(found);
  }
}

void StressMatrices::keep(const CellMatrices& found)
{
  float* to = triangles(found.cell / lanes) + found.cell % lanes;
  for (int j = 0; j < int(tractions_); ++j) {
    const double* from = found.entry(j, j);
    for (int i = j; i < int(tractions_); ++i, to += lanes, from += CellForms::lanes)
      for (int c = 0; c < CellForms::lanes; ++c)
        to[c] = float(from[c]);
  }
}

int StressMatrices::sizeOf(int batch) const
{
  return std::min(lanes, body_->model().mesh.numCells() - batch * lanes);
}

void StressMatrices::multiply(int batch, const double* T, double* forces) const
{
  std::array<float, most * lanes> x{}, y{};
  const auto count = std::size_t(sizeOf(batch));
  const CellMap* maps = maps_.data() + std::size_t(batch - first_) * lanes;
  for (std::size_t lane = 0; lane < count; ++lane)
    for (std::size_t at = 0; at < tractions_; at += 3) {
      double local[3];
      pullBack(maps[lane], T + lane * tractions_ + at, local);
      for (std::size_t i = 0; i < 3; ++i)
        x[(at + i) * lanes + lane] = float(local[i]);
    }
  multiplySingle(triangles_.get() + std::size_t(batch - first_) * batchSize(), x.data(), y.data(), tractions_);
  std::fill_n(forces, count * tractions_, 0.0);
  std::array<double, most> local{};
  for (std::size_t lane = 0; lane < count; ++lane) {
    for (std::size_t at = 0; at < tractions_; ++at)
      local[at] = double(y[at * lanes + lane]);
    addPushed(maps[lane], local.data(), int(tractions_), forces + lane * tractions_);
  }
}

} // namespace ndframe
