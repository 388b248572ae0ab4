// The constants C_0, C_1 of Kuhn's tetrahedron (docs/theory.md, section 2), by the finite eigenvalue problems of the
// proof.

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "ndframe/equilibrium/cell_energy.hpp"
#include "ndframe/equilibrium/star_wrench.hpp"
#include "ndframe/fem/quadrature.hpp"
#include "ndframe/mesh/refine.hpp"
#include "ndframe/mesh/vertex_tuples.hpp"
#include "oscillation.hpp"

namespace ndframe
{

namespace
{

constexpr int degree = 2;

Mesh kuhn(int level)
{
  Mesh mesh{3, {0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 1}, {0, 1, 2, 3}, {}, {}, {}};
  for (int i = 0; i < level; ++i)
    mesh = refineUniformly(mesh);
  return mesh;
}

/// sigma = eps: energies are squared L2 norms of stresses.
Elasticity unitLaw()
{
  Elasticity law;
  law.dim = 3;
  for (std::size_t i = 0; i < 6; ++i)
    law.D[7 * i] = i < 3 ? 1.0 : 0.5;
  return law;
}

/// The stress of least norm on the refined tetrahedron with given loads in the cells and tractions on its boundary, as
/// a quadratic form of both.
class LeastStress
{
public:
  explicit LeastStress(int level) : mesh_(kuhn(level)), reference_(referenceStress(3, degree))
  {
    const VertexTuples facets = allFacets(mesh_, mesh_.numPoints());
    face_.assign(std::size_t(mesh_.numCells()) * 4, -1);
    for (int place = 0, end = 0; place < facets.size(); place = end, ++numFaces_) {
      end = facets.groupEnd(place);
      for (int p = place; p < end; ++p) {
        const Facet facet{facets.at(p) / 4, facets.at(p) % 4};
        face_[std::size_t(facet.cell) * 4 + std::size_t(sortedFacet(mesh_, facet))] = numFaces_;
        if (end - place == 1)
          boundary_.push_back(facet);
      }
      isInside_.push_back(end - place == 2);
      firstCell_.push_back(facets.at(place) / 4);
    }
    for (int f = 0, next = 0; f < numFaces_; ++f)
      unknown_.push_back(isInside_[std::size_t(f)] ? next++ * data() : -1), inside_ = next * data();
    assemble();
  }

  const Mesh& mesh() const { return mesh_; }
  const std::vector<Facet>& boundary() const { return boundary_; }
  int data() const { return reference_.facetModes * 3; }
  int loads() const { return reference_.loads; }

  /// X^T (energy of the least stress) X for columns of data: all boundary facets' tractions, then all cells' loads
  /// (div sigma), each column in balance as a whole.
  DenseMatrix energy(const DenseMatrix& given) const
  {
    const int cells = mesh_.numCells(), columns = given.cols();
    // all data of all cells, the unknown ones zero
    DenseMatrix fixed(cells * reference_.data(), columns);
    for (std::size_t b = 0; b < boundary_.size(); ++b)
      for (int j = 0; j < columns; ++j)
        for (int i = 0; i < data(); ++i)
          fixed(boundary_[b].cell * reference_.data() + sortedFacet(mesh_, boundary_[b]) * data() + i, j) =
              given(int(b) * data() + i, j);
    for (int c = 0; c < cells; ++c)
      for (int j = 0; j < columns; ++j)
        for (int i = 0; i < loads(); ++i)
          fixed(c * reference_.data() + reference_.tractions + i, j) =
              given(int(boundary_.size()) * data() + c * loads() + i, j);
    const DenseMatrix AFixed = multiplyCells(fixed), r = scaled(multiply(balance_, fixed), -1.0);
    // least x^T A x + 2 x^T c with B x = r:  A_g = A + g B^T B,  S l = B A_g^-1 (g B^T r - c) - r
    DenseMatrix right = scaled(multiplyTransposed(B_, r), weight);
    const DenseMatrix c = toUnknowns(AFixed);
    for (int j = 0; j < columns; ++j)
      for (int i = 0; i < inside_; ++i)
        right(i, j) -= c(i, j);
    DenseMatrix x = solved(*factor_, right), violation = multiply(B_, x);
    for (int j = 0; j < columns; ++j)
      for (int i = 0; i < violation.rows(); ++i)
        violation(i, j) -= r(i, j);
    const DenseMatrix multipliers = solved(*schur_, violation);
    const DenseMatrix back = multiply(AinvBt_, multipliers);
    for (int j = 0; j < columns; ++j)
      for (int i = 0; i < inside_; ++i)
        x(i, j) -= back(i, j);
    const DenseMatrix Ax = multiply(A_, x), xc = multiplyTransposed(x, c);
    DenseMatrix form = multiplyTransposed(x, Ax);
    const DenseMatrix ff = multiplyTransposed(fixed, AFixed);
    for (int j = 0; j < columns; ++j)
      for (int i = 0; i < columns; ++i)
        form(i, j) += xc(i, j) + xc(j, i) + ff(i, j);
    return form;
  }

private:
  static constexpr double weight = 1.0;

  static DenseMatrix scaled(DenseMatrix matrix, double factor)
  {
    for (int j = 0; j < matrix.cols(); ++j)
      for (int i = 0; i < matrix.rows(); ++i)
        matrix(i, j) *= factor;
    return matrix;
  }

  static DenseMatrix solved(const DenseCholesky& factor, const DenseMatrix& right)
  {
    DenseMatrix x(right.rows(), right.cols());
    for (int j = 0; j < right.cols(); ++j) {
      const Vector column = factor.solve(right.column(j));
      std::copy(column.begin(), column.end(), x.col(j));
    }
    return x;
  }

  double signOf(int cell, int facet) const
  {
    return firstCell_[std::size_t(face_[std::size_t(cell) * 4 + std::size_t(facet)])] == cell ? 1.0 : -1.0;
  }

  /// Rows of all cells' data to those of the unknown tractions.
  DenseMatrix toUnknowns(const DenseMatrix& ofCells) const
  {
    DenseMatrix result(inside_, ofCells.cols());
    visit([&](int cell, int facet, int unknown, double sign) {
      for (int j = 0; j < ofCells.cols(); ++j)
        for (int i = 0; i < data(); ++i)
          result(unknown + i, j) += sign * ofCells(cell * reference_.data() + facet * data() + i, j);
    });
    return result;
  }

  template <class Visit>
  void visit(const Visit& visitFacet) const
  {
    for (int cell = 0; cell < mesh_.numCells(); ++cell)
      for (int facet = 0; facet < 4; ++facet)
        if (const int u = unknown_[std::size_t(face_[std::size_t(cell) * 4 + std::size_t(facet)])]; u >= 0)
          visitFacet(cell, facet, u, signOf(cell, facet));
  }

  DenseMatrix multiplyCells(const DenseMatrix& x) const
  {
    DenseMatrix result(x.rows(), x.cols());
    const int n = reference_.data();
    for (int cell = 0; cell < mesh_.numCells(); ++cell)
      for (int j = 0; j < x.cols(); ++j) {
        const double* first = x.col(j) + std::ptrdiff_t(cell) * n;
        const Vector Ax = multiply(cells_[std::size_t(cell)], Vector(first, first + n));
        std::copy(Ax.begin(), Ax.end(), result.col(j) + std::ptrdiff_t(cell) * n);
      }
    return result;
  }

  void assemble()
  {
    const int cells = mesh_.numCells(), n = reference_.data();
    const Vector facetMeans = meanCoordinates(facetBasis(3, degree)), cellMeans = meanCoordinates(loadBasis(3, degree));
    balance_ = DenseMatrix(6 * cells, n * cells);
    for (int cell = 0; cell < cells; ++cell) {
      const SortedCell sorted = sortedCell(mesh_, cell);
      cells_.push_back(cellEnergyMatrix(reference_, cellMap(mesh_, sorted), unitLaw()));
      const double* origin = mesh_.point(sorted.vertices[0]);
      const auto add = [&](const DenseMatrix& map, int first, double factor) {
        for (int j = 0; j < map.cols(); ++j)
          for (int i = 0; i < 6; ++i)
            balance_(6 * cell + i, cell * n + first + j) = factor * map(i, j);
      };
      for (int facet = 0; facet < 4; ++facet)
        add(wrenchMap(3, momentArms(facetMeans, corners(mesh_, sorted, facet), origin, 3), reference_.facetModes, 1.0),
            facet * data(), 1.0);
      add(wrenchMap(3, momentArms(cellMeans, corners(mesh_, sorted, -1), origin, 3), reference_.loadModes, 1.0),
          reference_.tractions, -1.0);
    }
    A_ = DenseMatrix(inside_, inside_);
    B_ = DenseMatrix(6 * cells, inside_);
    visit([&](int cell, int facet, int row, double sign) {
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < data(); ++j)
          B_(6 * cell + i, row + j) += sign * balance_(6 * cell + i, cell * n + facet * data() + j);
      for (int other = 0; other < 4; ++other)
        if (const int col = unknown_[std::size_t(face_[std::size_t(cell) * 4 + std::size_t(other)])]; col >= 0)
          for (int i = 0; i < data(); ++i)
            for (int j = 0; j < data(); ++j)
              A_(row + i, col + j) +=
                  sign * signOf(cell, other) * cells_[std::size_t(cell)](facet * data() + i, other * data() + j);
    });
    // the last cell's balance follows from the others'
    DenseMatrix kept(B_.rows() - 6, B_.cols()), wrenches(balance_.rows() - 6, balance_.cols());
    for (int j = 0; j < kept.cols(); ++j)
      std::copy_n(B_.col(j), kept.rows(), kept.col(j));
    for (int j = 0; j < wrenches.cols(); ++j)
      std::copy_n(balance_.col(j), wrenches.rows(), wrenches.col(j));
    B_ = std::move(kept);
    balance_ = std::move(wrenches);
    DenseMatrix weighted = multiplyTransposed(B_, B_);
    for (int j = 0; j < inside_; ++j)
      for (int i = 0; i < inside_; ++i)
        weighted(i, j) = weight * weighted(i, j) + A_(i, j);
    factor_ = std::make_unique<DenseCholesky>(std::move(weighted));
    DenseMatrix transposed(inside_, B_.rows());
    for (int j = 0; j < inside_; ++j)
      for (int i = 0; i < B_.rows(); ++i)
        transposed(j, i) = B_(i, j);
    AinvBt_ = solved(*factor_, transposed);
    schur_ = std::make_unique<DenseCholesky>(multiply(B_, AinvBt_));
  }

  Mesh mesh_;
  const ReferenceStress& reference_;
  int numFaces_ = 0, inside_ = 0;
  std::vector<int> face_, firstCell_, unknown_;
  std::vector<char> isInside_;
  std::vector<Facet> boundary_;
  std::vector<DenseMatrix> cells_;
  DenseMatrix balance_, A_, B_, AinvBt_;
  std::unique_ptr<DenseCholesky> factor_, schur_;
};

/// The moments of an orthonormal basis (columns, of the whole) of the functions that are given by columns at the points
/// of a rule, and the columns orthogonal to the rigid motions.
Direction rigidMotion(int number, const double* x)
{
  switch (number) {
  case 3:
    return {0.0, -x[2], x[1]};
  case 4:
    return {x[2], 0.0, -x[0]};
  case 5:
    return {-x[1], x[0], 0.0};
  default:
    break;
  }
  Direction unit{};
  unit[std::size_t(number)] = 1.0;
  return unit;
}

/// The largest eigenvalue of  energy v = mu mass v  among v with  global v = 0.
double largestRatio(const LeastStress& least, const DenseMatrix& moments, const DenseMatrix& mass,
                    const DenseMatrix& global)
{
  const DenseMatrix N = nullSpace(global, 1e-10);
  const DenseMatrix M = least.energy(multiply(moments, N)), D = multiplyTransposed(N, multiply(mass, N));
  const DenseCholesky root(D);
  DenseMatrix half(M.rows(), M.cols()), whole(M.rows(), M.cols());
  for (int j = 0; j < M.cols(); ++j) {
    const Vector column = root.solveLower(M.column(j));
    for (int i = 0; i < M.rows(); ++i)
      half(j, i) = column[std::size_t(i)];
  }
  for (int j = 0; j < M.cols(); ++j) {
    const Vector column = root.solveLower(half.column(j));
    std::copy(column.begin(), column.end(), whole.col(j));
  }
  return symmetricEigenvalues(std::move(whole)).back();
}

/// Vector functions that a load is projected on, copy by copy, and those of the whole that it is orthogonal to.
struct Functions
{
  using Values = std::function<void(const double* lambda, const double* x, Direction* values)>;
  int onEach, ofWhole;
  Values each, whole; ///< lambda: in the copy (cell or part of a facet); x: the point
};

/// Adds the products of both kinds at the points of a rule: the moments of each function in `basis`, its products with
/// the others of its copy and with those of the whole.
class Products
{
public:
  Products(const LeastStress& least, const Functions& functions, const MomentBasis& basis, int copies)
      : functions_(functions), basis_(basis), columns_(functions.onEach * copies),
        moments(int(least.boundary().size()) * least.data() + least.mesh().numCells() * least.loads(), columns_),
        mass(columns_, columns_), global(functions.ofWhole, columns_)
  {}

  /// corners: of the copy; row: of its first moment.
  template <class Corners>
  void add(const Corners& corners, double measure, int copy, int row)
  {
    const QuadratureRule rule = simplexRule(basis_.dim(), 4);
    const int n = functions_.onEach;
    std::vector<Direction> each(std::size_t(n), Direction{}), whole(std::size_t(functions_.ofWhole), Direction{});
    Vector m(std::size_t(basis_.size()));
    for (int q = 0; q < rule.size(); ++q) {
      double x[3] = {};
      for (int v = 0; v <= basis_.dim(); ++v)
        for (int k = 0; k < 3; ++k)
          x[k] += rule.point(q)[v] * corners(v)[k];
      basis_.values(rule.point(q), m.data());
      functions_.each(rule.point(q), x, each.data());
      functions_.whole(rule.point(q), x, whole.data());
      const double weight = measure * rule.weights[std::size_t(q)];
      for (int a = 0; a < n; ++a) {
        const Direction& f = each[std::size_t(a)];
        for (int k = 0; k < basis_.size(); ++k)
          for (int i = 0; i < 3; ++i)
            moments(row + 3 * k + i, n * copy + a) += weight * m[std::size_t(k)] * f[std::size_t(i)];
        for (int b = 0; b < n; ++b)
          mass(n * copy + a, n * copy + b) += weight * dotProduct(f, each[std::size_t(b)]);
        for (int b = 0; b < functions_.ofWhole; ++b)
          global(b, n * copy + a) += weight * dotProduct(f, whole[std::size_t(b)]);
      }
    }
  }

private:
  const Functions& functions_;
  const MomentBasis& basis_;
  int columns_;

public:
  DenseMatrix moments, mass, global;
};

void rigidMotions(const double*, const double* x, Direction* values)
{
  for (int a = 0; a < 6; ++a)
    values[a] = rigidMotion(a, x);
}

/// The polynomials of a degree in the barycentric coordinates of a copy.
Functions::Values polynomials(int dim, int order)
{
  return [basis = MomentBasis::polynomials(dim, order)](const double* lambda, const double*, Direction* values) {
    Vector m(std::size_t(basis.size()));
    basis.values(lambda, m.data());
    for (std::size_t j = 0; j < m.size(); ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        values[3 * j + k] = {};
        values[3 * j + k][k] = m[j];
      }
  };
}

/// 1, x, y, z and their products along each axis: on a facet more of them than there are polynomials.
void quadratics(const double*, const double* x, Direction* values)
{
  const double all[10] = {1.0,         x[0],        x[1],        x[2],        x[0] * x[0],
                          x[1] * x[1], x[2] * x[2], x[0] * x[1], x[1] * x[2], x[2] * x[0]};
  for (std::size_t j = 0; j < 10; ++j)
    for (std::size_t k = 0; k < 3; ++k) {
      values[3 * j + k] = {};
      values[3 * j + k][k] = all[j];
    }
}

/// C_h^2 of loads that are rigid motions on every copy.
double cellConstant(int level)
{
  const Functions functions{6, 6, rigidMotions, rigidMotions};
  const LeastStress least(level);
  const Mesh& mesh = least.mesh();
  const MomentBasis basis = loadBasis(3, degree);
  Products products(least, functions, basis, mesh.numCells());
  for (int cell = 0; cell < mesh.numCells(); ++cell) {
    const SortedCell sorted = sortedCell(mesh, cell);
    products.add([&](int v) { return mesh.point(sorted.vertices[std::size_t(v)]); }, cellMeasure(mesh, cell), cell,
                 int(least.boundary().size()) * least.data() + cell * least.loads());
  }
  return largestRatio(least, products.moments, products.mass, products.global);
}

/// C_1h^2 of tractions on the facet opposite to a vertex.
double facetConstant(int level, int opposite, const Functions& functions)
{
  const LeastStress least(level);
  const Mesh& mesh = least.mesh();
  const auto isOnFacet = [&](const double* x) { // of Kuhn's tetrahedron 0 <= z <= y <= x <= 1
    const double lambda[4] = {1.0 - x[0], x[0] - x[1], x[1] - x[2], x[2]};
    return lambda[opposite] < 1e-9;
  };
  std::vector<int> parts;
  for (int b = 0; b < int(least.boundary().size()); ++b) {
    int vertices[3];
    facetVertices(mesh, least.boundary()[std::size_t(b)], vertices);
    if (std::all_of(vertices, vertices + 3, [&](int v) { return isOnFacet(mesh.point(v)); }))
      parts.push_back(b);
  }
  const MomentBasis basis = facetBasis(3, degree);
  Products products(least, functions, basis, int(parts.size()));
  for (int p = 0; p < int(parts.size()); ++p) {
    const int place = parts[std::size_t(p)];
    const Facet facet = least.boundary()[std::size_t(place)];
    const auto vertices = corners(mesh, sortedCell(mesh, facet.cell), sortedFacet(mesh, facet));
    double normal[3];
    products.add([&](int v) { return vertices[std::size_t(v)]; }, facetNormal(mesh, facet, normal), p,
                 place * least.data());
  }
  return largestRatio(least, products.moments, products.mass, products.global);
}

double largestFacetConstant(int level, const Functions& functions)
{
  double largest = 0.0;
  for (int opposite = 0; opposite < 4; ++opposite)
    largest = std::max(largest, facetConstant(level, opposite, functions));
  return largest;
}

} // namespace

TEST(OscillationConstants, ChildrenOfKuhnsTetrahedronAreCopiesOfHalfTheSize)
{
  const auto lengths = [](const Mesh& mesh, int cell) {
    std::vector<double> all;
    for (int a = 0; a < 4; ++a)
      for (int b = 0; b < a; ++b) {
        const double *x = mesh.point(mesh.cell(cell)[a]), *y = mesh.point(mesh.cell(cell)[b]);
        all.push_back(std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]));
      }
    std::sort(all.begin(), all.end());
    return all;
  };
  const auto whole = lengths(kuhn(0), 0);
  for (int level = 1; level <= 2; ++level) {
    const Mesh mesh = kuhn(level);
    for (int cell = 0; cell < mesh.numCells(); ++cell)
      for (std::size_t i = 0; i < whole.size(); ++i)
        EXPECT_NEAR(lengths(mesh, cell)[i] * (1 << level), whole[i], 1e-14);
  }
}

TEST(OscillationConstants, OfTheCellIsBelowTheOneThatIsUsed)
{
  const double first = cellConstant(1) / (1.0 - 1.0 / 4), second = cellConstant(2) / (1.0 - 1.0 / 16);
  EXPECT_NEAR(first, 0.7062, 1e-4);
  EXPECT_NEAR(second, 0.6043, 1e-4);
  EXPECT_LT(second, 0.61 * (1.0 - 1e-6));
}

TEST(OscillationConstants, OfFacetsAreBelowTheOneThatIsUsed)
{
  const double largest = largestFacetConstant(2, {9, 6, polynomials(2, 1), rigidMotions});
  EXPECT_NEAR(largest / (1.0 - 1.0 / 4), 11.48, 1e-2);
  EXPECT_LT(largest / (1.0 - 1.0 / 4), 11.5 * (1.0 - 1e-6));
}

TEST(OscillationConstants, OfFacetsForWhatIsOrthogonalToQuadraticTractionsAreBelowTheOneThatIsUsed)
{
  const double largest = largestFacetConstant(2, {18, 30, polynomials(2, 2), quadratics});
  EXPECT_NEAR(largest / (1.0 - 1.0 / 4), 5.989, 1e-3);
  EXPECT_LT(largest / (1.0 - 1.0 / 4), 11.5 * std::pow(shareBeyondPolynomials(3, 2), 2) * (1.0 - 1e-6));
  EXPECT_EQ(shareBeyondPolynomials(3, 1), 1.0);
  EXPECT_EQ(shareBeyondPolynomials(2, 3), 1.0);
}

} // namespace ndframe
