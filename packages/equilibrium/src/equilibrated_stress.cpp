#include "ndframe/equilibrium/equilibrated_stress.hpp"

#include "ndframe/assembly/cell_field.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/equilibrium/sub_cell.hpp"

namespace ndframe
{
namespace
{

/// Adds K eps(u), a polynomial of degree order - 1 on the whole cell, to the coefficients of a stress.
template <int dim, int order>
void addElasticStress(const BodyModel& body, const Vector& displacement, int cell, SplitStress& stress)
{
  const CellField<dim, order> field(body, displacement, cell);
  const QuadratureRule rule = simplexRule(dim, 2 * (order - 1));
  const MomentBasis& basis = referenceStress(dim, stress.degree).basis;
  const int modes = order == 1 ? 1 : dim + 1; // the functions of degree order - 1 come first
  for (int sub = 0; sub <= dim; ++sub)
    for (int q = 0; q < rule.size(); ++q) {
      double lambda[4], local[4], m[maxStressModes], strain[6], sigma[6], S[6];
      SubCell{dim, sub}.simplexCoordinates(rule.point(q), lambda);
      for (int a = 0; a <= dim; ++a)
        local[stress.cell.local[std::size_t(a)]] = lambda[a];
      field.evaluate(local, strain, sigma);
      transformStress(dim, stress.map.inverse.data(), stress.map.det, sigma, S);
      basis.values(rule.point(q), m);
      for (int s = 0; s < numStrains(dim); ++s)
        for (int k = 0; k < modes; ++k)
          stress.coefficients[(std::size_t(sub) * std::size_t(numStrains(dim)) + std::size_t(s)) *
                                  std::size_t(basis.size()) +
                              std::size_t(k)] += rule.weights[std::size_t(q)] * S[s] * m[k];
    }
}

void addElasticStress(const BodyModel& body, const Vector& displacement, int cell, SplitStress& stress)
{
  withDimAndOrder(body.mesh.dim, body.nodes.order,
                  [&](auto d, auto p) { addElasticStress<d(), p()>(body, displacement, cell, stress); });
}

} // namespace

namespace
{

SplitStress zeroStress(const BodyModel& body, const ReferenceStress& reference, int cell)
{
  SplitStress stress;
  stress.dim = reference.dim;
  stress.degree = reference.degree;
  stress.cell = sortedCell(body.mesh, cell);
  stress.map = cellMap(body.mesh, stress.cell);
  return stress;
}

} // namespace

SplitStress correctionStress(const BodyModel& body, const StressCorrection& correction, int cell)
{
  const ReferenceStress& reference = referenceStress(body.mesh.dim, correction.degree);
  SplitStress stress = zeroStress(body, reference, cell);
  stress.coefficients =
      CellForm(reference, stress.map, body.laws(cell)).coefficients(pullBack(reference, stress.map, correction, cell));
  return stress;
}

SplitStress equilibratedStress(const BodyModel& body, const Vector& displacement, const StressCorrection& correction,
                               int cell)
{
  SplitStress stress = correctionStress(body, correction, cell);
  addElasticStress(body, displacement, cell, stress);
  return stress;
}

} // namespace ndframe
