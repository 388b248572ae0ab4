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
constexpr int mostTerms = 10; ///< degree 2 in space

int numTerms(int dim, int degree)
{
  return degree == 0 ? 1 : degree == 1 ? dim + 1 : (dim + 1) * (dim + 2) / 2;
}

/// 1, x_k, x_k x_l at (x - origin) / scale; as many as the degree has.
void monomials(int dim, int degree, const double* x, const double* origin, double scale, double* m)
{
  double* next = m;
  *next++ = 1.0;
  for (int k = 0; k < dim && degree >= 1; ++k)
    *next++ = (x[k] - origin[k]) / scale;
  for (int k = 0; k < dim && degree >= 2; ++k)
    for (int l = 0; l <= k; ++l)
      *next++ = m[1 + k] * m[1 + l];
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

  double scale() const { return scale_; }

  /// Writes the coefficients of a polynomial of this degree; false when the cells' samples do not determine it.
  bool solve(const std::vector<int>& cells, int degree, double* coefficients)
  {
    const int terms = numTerms(mesh_.dim, degree);
    if (degree > 0 && int(cells.size()) * samples_.perCell < 2 * terms)
      return false;
    setScale(cells);
    DenseMatrix normal(terms, terms), right(terms, samples_.components);
    double m[mostTerms];
    for (const int cell : cells)
      for (int s = cell * samples_.perCell; s < (cell + 1) * samples_.perCell; ++s) {
        monomials(mesh_.dim, degree, point(s), origin_, scale_, m);
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

  void setScale(const std::vector<int>& cells)
  {
    scale_ = 0.0;
    for (const int cell : cells)
      for (int s = cell * samples_.perCell; s < (cell + 1) * samples_.perCell; ++s)
        for (int k = 0; k < mesh_.dim; ++k)
          scale_ = std::max(scale_, std::abs(point(s)[k] - origin_[k]));
  }

  const Mesh& mesh_;
  const PatchSamples& samples_;
  const double* origin_;
  double scale_ = 0.0;
};

PatchPolynomials::PatchPolynomials(const Mesh& mesh, int degree, const PatchSamples& samples)
    : mesh_(mesh), degree_(degree), components_(samples.components), terms_(numTerms(mesh.dim, degree)),
      scale_(std::size_t(mesh.numPoints())),
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
    scale_[std::size_t(v)] = fit.scale();
  }
}

void PatchPolynomials::blend(const int* vertices, const double* lambda, const double* x, double* values) const
{
  double m[mostTerms];
  std::fill(values, values + components_, 0.0);
  for (int a = 0; a <= mesh_.dim; ++a) {
    const auto v = std::size_t(vertices[a]);
    monomials(mesh_.dim, degree_, x, mesh_.point(vertices[a]), scale_[v], m);
    const double* coefficient = coefficients_.data() + v * std::size_t(terms_) * std::size_t(components_);
    for (int i = 0; i < terms_; ++i)
      for (int c = 0; c < components_; ++c)
        values[c] += lambda[a] * m[i] * *coefficient++;
  }
}

} // namespace ndframe
