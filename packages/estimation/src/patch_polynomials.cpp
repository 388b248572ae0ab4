#include "patch_polynomials.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/algebra/dense.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/vertex_cells.hpp"

namespace ndframe
{
namespace
{

/// A pivot below this, relative to the largest diagonal entry of the normal equations: the samples do not determine the
/// polynomial (they lie nearly on a line or a conic).
constexpr double wellDetermined = 1e-6;
constexpr double thinnest = 1e-13; ///< square of width over length of a patch that is no line
constexpr int mostTerms = 10;      ///< degree 2 in space

int numTerms(int dim, int degree)
{
  return degree == 0 ? 1 : degree == 1 ? dim + 1 : (dim + 1) * (dim + 2) / 2;
}

/// 1, y_k, y_k y_l at y = T (x - origin); as many as the degree has.
void monomials(int dim, int degree, const double* x, const double* origin, const PatchFrame& T, double* m)
{
  double* next = m;
  *next++ = 1.0;
  for (int k = 0; k < dim && degree >= 1; ++k) {
    double y = 0.0;
    for (int l = 0; l <= k; ++l)
      y += T[std::size_t(k)][std::size_t(l)] * (x[l] - origin[l]);
    *next++ = y;
  }
  for (int k = 0; k < dim && degree >= 2; ++k)
    for (int l = 0; l <= k; ++l)
      *next++ = m[1 + k] * m[1 + l];
}

/// L^-1 of second moments L L^T, sizes of the axes taken out first; zero where the samples lie on a line or plane.
PatchFrame frameOf(std::size_t dim, const PatchFrame& moments)
{
  PatchFrame L{}, T{};
  std::array<double, 3> size{};
  for (std::size_t k = 0; k < dim; ++k)
    size[k] = std::sqrt(moments[k][k]);
  for (std::size_t k = 0; k < dim; ++k)
    for (std::size_t l = 0; l <= k; ++l) {
      double entry = moments[k][l] / (size[k] * size[l]);
      for (std::size_t m = 0; m < l; ++m)
        entry -= L[k][m] * L[l][m];
      if (k == l && !(entry > thinnest))
        return {};
      L[k][l] = k == l ? std::sqrt(entry) : entry / L[l][l];
    }
  for (std::size_t k = 0; k < dim; ++k)
    for (std::size_t l = 0; l <= k; ++l) {
      double entry = k == l ? 1.0 : 0.0;
      for (std::size_t m = l; m < k; ++m)
        entry -= L[k][m] * T[m][l];
      T[k][l] = entry / L[k][k];
    }
  for (auto& row : T)
    for (std::size_t l = 0; l < dim; ++l)
      row[l] /= size[l];
  return T;
}

/// All cells with a vertex in common with one of these.
std::vector<int> withNeighbours(const Mesh& mesh, const VertexCells& around, const std::vector<int>& cells)
{
  std::vector<int> grown;
  for (const int cell : cells)
    for (int v = 0; v <= mesh.dim; ++v) {
      const int vertex = mesh.cell(cell)[v];
      grown.insert(grown.end(), around.begin(vertex), around.end(vertex));
    }
  std::sort(grown.begin(), grown.end());
  grown.erase(std::unique(grown.begin(), grown.end()), grown.end());
  return grown;
}

} // namespace

/// The least squares problem of one vertex.
class PatchPolynomials::Fit
{
public:
  Fit(const Mesh& mesh, const PatchSamples& samples, int vertex)
      : mesh_(mesh), samples_(samples), origin_(mesh.point(vertex))
  {}

  const PatchFrame& frame() const { return frame_; }

  /// Writes the coefficients of a polynomial of this degree; false when the cells' samples do not determine it.
  bool solve(const std::vector<int>& cells, int degree, double* coefficients)
  {
    const int terms = numTerms(mesh_.dim, degree);
    if (degree > 0 && int(cells.size()) * samples_.perCell < 2 * terms)
      return false;
    frame_ = frameOf(std::size_t(mesh_.dim), moments(cells));
    if (degree > 0 && frame_[0][0] == 0.0)
      return false;
    DenseMatrix normal(terms, terms), right(terms, samples_.components);
    double m[mostTerms];
    for (const int cell : cells)
      for (int s = cell * samples_.perCell; s < (cell + 1) * samples_.perCell; ++s) {
        monomials(mesh_.dim, degree, point(s), origin_, frame_, m);
        for (int i = 0; i < terms; ++i) {
          for (int j = 0; j < terms; ++j)
            normal(i, j) += m[i] * m[j];
          for (int c = 0; c < samples_.components; ++c)
            right(i, c) += m[i] * samples_.values[std::size_t(s) * std::size_t(samples_.components) + std::size_t(c)];
        }
      }
    try {
      const DenseCholesky factor(std::move(normal), wellDetermined);
      for (int c = 0; c < samples_.components; ++c) {
        const Vector solution = factor.solve(right.column(c));
        for (int i = 0; i < terms; ++i)
          coefficients[i * samples_.components + c] = solution[std::size_t(i)];
      }
      return true;
    } catch (const NotPositiveDefinite&) {
      return false;
    }
  }

private:
  const double* point(int sample) const
  {
    return samples_.points.data() + std::size_t(sample) * std::size_t(mesh_.dim);
  }

  /// Mean of (x - origin) (x - origin)^T, its lower triangle.
  PatchFrame moments(const std::vector<int>& cells) const
  {
    PatchFrame sum{};
    for (const int cell : cells)
      for (int s = cell * samples_.perCell; s < (cell + 1) * samples_.perCell; ++s)
        for (int k = 0; k < mesh_.dim; ++k)
          for (int l = 0; l <= k; ++l)
            sum[std::size_t(k)][std::size_t(l)] += (point(s)[k] - origin_[k]) * (point(s)[l] - origin_[l]);
    for (auto& row : sum)
      for (double& entry : row)
        entry /= double(cells.size()) * samples_.perCell;
    return sum;
  }

  const Mesh& mesh_;
  const PatchSamples& samples_;
  const double* origin_;
  PatchFrame frame_{};
};

PatchPolynomials::PatchPolynomials(const Mesh& mesh, int degree, const PatchSamples& samples)
    : mesh_(mesh), degree_(degree), components_(samples.components), terms_(numTerms(mesh.dim, degree)),
      frames_(std::size_t(mesh.numPoints())),
      coefficients_(std::size_t(mesh.numPoints()) * std::size_t(terms_) * std::size_t(components_), 0.0)
{
  NDFRAME_ASSERT(degree <= 2, "polynomials of degree 2 at most");
  const VertexCells around(mesh);
  for (int v = 0; v < mesh.numPoints(); ++v) {
    Fit fit(mesh, samples, v);
    double* coefficients = coefficients_.data() + std::size_t(v) * std::size_t(terms_) * std::size_t(components_);
    std::vector<int> cells(around.begin(v), around.end(v));
    for (int d = degree; !fit.solve(cells, d, coefficients);) {
      auto grown = withNeighbours(mesh, around, cells);
      if (grown.size() == cells.size())
        --d;
      cells = std::move(grown);
    }
    frames_[std::size_t(v)] = fit.frame();
  }
}

void PatchPolynomials::blend(const int* vertices, const double* lambda, const double* x, double* values) const
{
  double m[mostTerms];
  std::fill(values, values + components_, 0.0);
  for (int a = 0; a <= mesh_.dim; ++a) {
    const auto v = std::size_t(vertices[a]);
    monomials(mesh_.dim, degree_, x, mesh_.point(vertices[a]), frames_[v], m);
    const double* coefficient = coefficients_.data() + v * std::size_t(terms_) * std::size_t(components_);
    for (int i = 0; i < terms_; ++i)
      for (int c = 0; c < components_; ++c)
        values[c] += lambda[a] * m[i] * *coefficient++;
  }
}

} // namespace ndframe
