#include "ndframe/equilibrium/reference_stress.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"
#include "reference_space.hpp"

namespace ndframe
{
namespace
{

/// Singular values of the reference maps are above 1e-3 or round-off.
constexpr double rankTolerance = 1e-8;

/// The integral of S_a S_b for all pairs of columns of `fields`, symmetric, with both orders of a != b.
DenseMatrix productTable(const ReferenceSpace& space, int dim, const DenseMatrix& fields, int a, int b)
{
  const int strains = space.strains(), modes = space.modes(), n = fields.cols();
  DenseMatrix ofA((dim + 1) * modes, n), ofB((dim + 1) * modes, n);
  for (int j = 0; j < n; ++j)
    for (int sub = 0; sub <= dim; ++sub)
      for (int m = 0; m < modes; ++m) {
        ofA(sub * modes + m, j) = fields((sub * strains + a) * modes + m, j);
        ofB(sub * modes + m, j) = fields((sub * strains + b) * modes + m, j);
      }
  const DenseMatrix product = multiplyTransposed(ofA, ofB);
  DenseMatrix table(n, n);
  const double factor = (a == b ? 0.5 : 1.0) * space.subCellMeasure();
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      table(i, j) = factor * (product(i, j) + product(j, i));
  return table;
}

/// Columns of A, then of B.
DenseMatrix beside(const DenseMatrix& A, const DenseMatrix& B)
{
  DenseMatrix both(A.rows(), A.cols() + B.cols());
  std::copy(A.data(), A.data() + std::ptrdiff_t(A.rows()) * A.cols(), both.data());
  std::copy(B.data(), B.data() + std::ptrdiff_t(B.rows()) * B.cols(), both.col(A.cols()));
  return both;
}

ReferenceStress makeTables(int dim, int degree, int bubbles)
{
  const ReferenceSpace space(dim, degree);
  ReferenceStress result;
  result.dim = dim;
  result.degree = degree;
  result.facetModes = space.facetModes();
  result.loadModes = space.loadModes();
  result.tractions = (dim + 1) * space.facetModes() * dim;
  result.loads = space.loadModes() * dim;
  result.bubbles = bubbles;
  result.coefficients = space.coefficients();
  result.basis = MomentBasis::polynomials(dim, degree);

  const DenseMatrix fields = nullSpace(space.constraints(), rankTolerance);
  const DenseMatrix data = multiply(space.dataMoments(), fields);
  const int rigidMotions = dim == 2 ? 3 : 6;
  NDFRAME_ASSERT(fields.cols() == result.data() - rigidMotions + bubbles, "a wrong number of reference stresses");
  result.lift = multiply(fields, pseudoInverse(data, rankTolerance));
  result.bubble = multiply(fields, nullSpace(data, rankTolerance));
  NDFRAME_ASSERT(result.bubble.cols() == bubbles, "a wrong number of bubbles: some balanced data cannot be reached");

  const DenseMatrix all = beside(result.lift, result.bubble);
  for (int a = 0; a < space.strains(); ++a)
    for (int b = a; b < space.strains(); ++b)
      result.energy.push_back(productTable(space, dim, all, a, b));
  return result;
}

template <int dim, int degree, int bubbles>
const ReferenceStress& keptTables()
{
  static const ReferenceStress tables = makeTables(dim, degree, bubbles);
  return tables;
}

} // namespace

const ReferenceStress& referenceStress(int dim, int degree)
{
  NDFRAME_ASSERT((dim == 2 || dim == 3) && degree >= 1 && degree <= 3, "tables exist for degrees 1 to 3");
  using Tables = const ReferenceStress& (*)();
  constexpr Tables ofPlane[] = {keptTables<2, 1, 0>, keptTables<2, 2, 3>, keptTables<2, 3, 9>};
  constexpr Tables ofSpace[] = {keptTables<3, 1, 0>, keptTables<3, 2, 18>, keptTables<3, 3, 66>};
  return (dim == 2 ? ofPlane : ofSpace)[degree - 1]();
}

} // namespace ndframe
