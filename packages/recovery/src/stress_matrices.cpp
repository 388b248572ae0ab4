#include "stress_matrices.hpp"

#include <algorithm>

#include "ndframe/base/lanes.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t most = 72; ///< tractions of a cell, degree 2

/// y += A x, lane by lane, from the columns of A below its diagonal.
NDFRAME_EVERY_PROCESSOR void addSymmetric(const double* triangle, const double* x, double* y, std::size_t size)
{
  constexpr std::size_t lanes = CellForms::lanes;
  DoubleLanes here, sum, entry, value;
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

} // namespace

void CellMatrices::multiply(const double* x, double* forces) const
{
  addSymmetric(triangle, x, forces, std::size_t(size));
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
      forms_(body.reference()), maps_(std::size_t(last - first) * lanes), kept_(at(last))
{
  NDFRAME_ASSERT(tractions_ <= most, "more data than a cell of degree 2 has");
}

void StressMatrices::find(int first, int last, const std::function<void(const CellMatrices&)>& use)
{
  const Mesh& mesh = body_->model().mesh;
  Vector work;
  for (int batch = first; batch < last; ++batch) {
    CellMap* maps = maps_.data() + std::size_t(batch - first_) * lanes;
    double* compliances = kept_.data() + at(batch);
    const int cell = batch * lanes, count = sizeOf(batch);
    for (int c = 0; c < lanes; ++c) { // lanes without a cell repeat the last one
      const int number = cell + std::min(c, count - 1);
      maps[c] = cellMap(mesh, sortedCell(mesh, number));
      const auto own = pulledBackCompliance(maps[c], body_->model().laws(number));
      for (std::size_t m = 0; m < own.size(); ++m)
        compliances[m * lanes + std::size_t(c)] = own[m];
    }
    const CellForms::Condensed found = forms_.condensed(compliances, work);
    std::copy_n(found.factor, forms_.factorSize() * lanes, compliances + this->compliances());
    use({cell, count, maps, found.triangle, body_->reference().data()});
  }
}

int StressMatrices::sizeOf(int batch) const
{
  return std::min(lanes, body_->model().mesh.numCells() - batch * lanes);
}

void StressMatrices::multiply(int batch, const double* T, double* forces) const
{
  std::array<double, most * lanes> x{}, y{};
  const auto count = std::size_t(sizeOf(batch));
  const CellMap* maps = maps_.data() + std::size_t(batch - first_) * lanes;
  std::array<double, most> local{};
  for (std::size_t lane = 0; lane < count; ++lane)
    for (std::size_t at = 0; at < tractions_; at += 3) {
      pullBack(maps[lane], T + lane * tractions_ + at, local.data());
      for (std::size_t i = 0; i < 3; ++i)
        x[(at + i) * lanes + lane] = local[i];
    }
  const double* kept = kept_.data() + at(batch);
  forms_.apply(kept, kept + compliances(), x.data(), y.data());
  std::fill_n(forces, count * tractions_, 0.0);
  for (std::size_t lane = 0; lane < count; ++lane) {
    for (std::size_t at = 0; at < tractions_; ++at)
      local[at] = y[at * lanes + lane];
    addPushed(maps[lane], local.data(), int(tractions_), forces + lane * tractions_);
  }
}

} // namespace ndframe
