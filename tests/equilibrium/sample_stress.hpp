#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ndframe/equilibrium/cell_energy.hpp"

namespace ndframe::test
{

/// A pair for which reference stresses exist.
struct StressKind
{
  int dim, degree;

  std::string name() const;
};

const std::vector<StressKind>& stressKinds();
/// Those that stresses of whole bodies may be of: not degree 3 in space.
std::vector<StressKind> recoveredKinds();

/// Voigt stress at a point.
using StressField = std::function<void(const double* x, double* sigma)>;

/// A random symmetric polynomial of that degree.
StressField polynomialStress(int dim, int degree, unsigned seed);

/// K eps(u) of a random quadratic (order 2) or linear displacement, and the displacement itself.
struct ElasticField
{
  std::function<void(const double* x, double* u)> displacement;
  StressField stress;
};
ElasticField elasticField(const Elasticity& law, int order, unsigned seed);

/// The divergence of a polynomial of degree <= 4 at a point, by exact differences.
std::vector<double> divergenceOf(const StressField& field, int dim, const double* x);

/// Moments of a field's tractions and divergence on every cell, by quadrature; the field has that degree.
StressCorrection momentsOf(const StressField& field, const Mesh& mesh, int degree);

/// int t . v - int div . v on a mesh of one cell for unit moments one by one, and for a correction's. Displacements by
/// sorted barycentric coordinates and component.
Vector workOfUnitMoments(const Mesh& mesh, int degree, const std::function<double(const double*, int)>& displacement);
double workOf(const StressCorrection& correction, const Mesh& mesh,
              const std::function<double(const double*, int)>& displacement);

/// Random moments on one cell that balance.
StressCorrection balancedMoments(const Mesh& cell, int degree, unsigned seed);

/// One random cell whose vertices are numbered in a random order, so that sorting may turn it inside out.
Mesh shuffledCell(int dim, unsigned seed);

/// A body of one material on a mesh, without supports and loads.
BodyModel bodyOf(Mesh mesh, int order, const Elasticity& law);

/// Isotropic, nearly incompressible and orthotropic.
std::vector<Elasticity> sampleLaws(int dim);

/// A point of a mesh's cell from barycentric coordinates in sorted order.
std::vector<double> pointOf(const Mesh& mesh, const SortedCell& cell, const double* lambda);

/// Barycentric coordinates in a cell from those on its facet, both by ascending vertices.
std::vector<double> facetPoint(int dim, int facet, const double* onFacet);

/// Calls `visit(sub, lambda, weight)` at quadrature points of all sub-cells; weights add up to 1. Exact up to `degree`
/// on every sub-cell.
void overSubCells(int dim, int degree, const std::function<void(int sub, const double* lambda, double weight)>& visit);

/// The sum of |entries| of a Voigt stress, and of a difference.
double size(const std::vector<double>& values);
std::vector<double> difference(std::vector<double> a, const std::vector<double>& b);

} // namespace ndframe::test
