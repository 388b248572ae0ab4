#include "stress_matrices.hpp"

#include <algorithm>

namespace ndframe
{
namespace
{

constexpr std::size_t most = 72; ///< tractions of a cell, degree 2

typedef float Lanes __attribute__((vector_size(4 * StressMatrices::lanes), aligned(4), may_alias));

#if defined(__x86_64__) && defined(__gnu_linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define NDFRAME_EVERY_PROCESSOR __attribute__((target_clones("default", "arch=haswell", "arch=skylake-avx512")))
#else
#define NDFRAME_EVERY_PROCESSOR
#endif

/// y = A x, lane by lane, from the columns of A below its diagonal.
NDFRAME_EVERY_PROCESSOR void symmetricProduct(const float* triangle, const float* x, float* y, std::size_t size)
{
  const auto* A = reinterpret_cast<const Lanes*>(triangle);
  const auto* from = reinterpret_cast<const Lanes*>(x);
  auto* to = reinterpret_cast<Lanes*>(y);
  for (std::size_t j = 0; j < size; ++j) {
    const Lanes here = from[j];
    Lanes sum = to[j] + *A++ * here;
    for (std::size_t i = j + 1; i < size; ++i) {
      const Lanes entry = *A++;
      to[i] += entry * here;
      sum += entry * from[i];
    }
    to[j] = sum;
  }
}

void pullBack(const CellMap& map, const double* vector, double* result)
{
  for (std::size_t i = 0; i < 3; ++i)
    result[i] =
        map.inverse[3 * i] * vector[0] + map.inverse[3 * i + 1] * vector[1] + map.inverse[3 * i + 2] * vector[2];
}

} // namespace

DenseMatrix pulledBack(const CellMap& map, const DenseMatrix& columns)
{
  DenseMatrix result(columns.rows(), columns.cols());
  for (int j = 0; j < columns.cols(); ++j)
    for (int at = 0; at < columns.rows(); at += 3)
      pullBack(map, columns.col(j) + at, result.col(j) + at);
  return result;
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
      triangles_(std::size_t(last - first) * batchSize())
{
  NDFRAME_ASSERT(tractions_ <= most, "more data than a cell of degree 2 has");
}

void StressMatrices::find(int first, int last, const std::function<void(int, const CellMap&, const DenseMatrix&)>& use)
{
  const Mesh& mesh = body_->model().mesh;
  for (int batch = first; batch < last; ++batch) {
    const int begin = batch * lanes;
    CellMap* maps = maps_.data() + std::size_t(begin - first_ * lanes);
    DenseMatrix compliances(int(body_->reference().energy.size()), sizeOf(batch));
    for (int c = 0; c < compliances.cols(); ++c) {
      maps[c] = cellMap(mesh, sortedCell(mesh, begin + c));
      const auto entries = pulledBackCompliance(maps[c], body_->model().laws(begin + c));
      std::copy(entries.begin(), entries.end(), compliances.col(c));
    }
    forms_.each(compliances, [&](int c, const DenseMatrix& A) {
      keep(A, triangles(batch) + c);
      use(begin + c, maps[c], A);
    });
  }
}

void StressMatrices::keep(const DenseMatrix& A, float* lane) const
{
  for (int j = 0; j < int(tractions_); ++j)
    for (int i = j; i < int(tractions_); ++i, lane += lanes)
      *lane = float(A(i, j));
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
  symmetricProduct(triangles_.data() + std::size_t(batch - first_) * batchSize(), x.data(), y.data(), tractions_);
  std::fill_n(forces, count * tractions_, 0.0);
  std::array<double, most> local{};
  for (std::size_t lane = 0; lane < count; ++lane) {
    for (std::size_t at = 0; at < tractions_; ++at)
      local[at] = double(y[at * lanes + lane]);
    addPushed(maps[lane], local.data(), int(tractions_), forces + lane * tractions_);
  }
}

} // namespace ndframe
