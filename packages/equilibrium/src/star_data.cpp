#include "ndframe/equilibrium/star_data.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{
StarLoads::StarLoads(const StarBody& body, std::vector<FieldInput> fields)
    : body_(&body), fields_(std::move(fields)),
      facetShares_(facetBasis(body.dim(), body.data().degree), body.data().order),
      cellShares_(loadBasis(body.dim(), body.data().degree), body.data().order)
{}

/// Minus the shares of sigma~ n on every spoke (outward for each cell) and of div sigma~. With the barycentric
/// coordinate of the vertex opposite to a facet, |f| n = - dim |E| grad lambda.
void StarLoads::addStress(const Star& star, int field, double* x) const
{
  const int dim = body_->dim(), data = body_->reference().data(), facetData = body_->facetData();
  for (const StarCell& cell : star.cells) {
    const CellStress stress =
        cellStress(body_->model(), cell.cell, cell.sorted, *fields_[std::size_t(field)].displacement);
    for (int facet = 0; facet <= dim; ++facet) {
      if (facet == cell.apex)
        continue;
      const int a = Star::apexOnFacet(cell.apex, facet);
      for (int b = 0; b < dim; ++b) {
        double force[3] = {};
        addForce(stress, b < facet ? b : b + 1, facet, dim * stress.measure, force);
        double* traction = x + std::ptrdiff_t(facet) * facetData;
        for (int k = 0; k < body_->facetModes(); ++k) {
          const double share =
              body_->data().order == 1 ? facetShares_.ofOne(a)[k] / dim : facetShares_.ofLinear(a, b)[k];
          for (int i = 0; i < dim; ++i)
            *traction++ += share * force[i];
        }
      }
    }
    for (int v = 0; v <= dim && body_->data().order == 2; ++v) {
      double force[3] = {}, *load = x + body_->reference().tractions;
      addForce(stress, v, v, -stress.measure, force);
      for (int k = 0; k < body_->loadModes(); ++k)
        for (int i = 0; i < dim; ++i)
          *load++ += cellShares_.ofOne(cell.apex)[k] * force[i];
    }
    x += data;
  }
}

/// The shares of one facet out of a list: per facet, per vertex, per mode, per component.
void StarLoads::addShare(const Star& star, const Spoke& spoke, const double* shares, int index, double* x) const
{
  const int facetData = body_->facetData();
  const int apex = Star::apexOnFacet(star.cells[std::size_t(spoke.cell[0])].apex, spoke.facet[0]);
  const double* share =
      shares + (std::ptrdiff_t(index) * std::ptrdiff_t(body_->dim()) + std::ptrdiff_t(apex)) * facetData;
  double* target =
      x + std::ptrdiff_t(spoke.cell[0]) * body_->reference().data() + std::ptrdiff_t(spoke.facet[0]) * facetData;
  for (int i = 0; i < facetData; ++i)
    target[i] += share[i];
}

void StarLoads::addLoads(const Star& star, int field, double* x) const
{
  const StaticData& data = body_->data();
  for (const Spoke& spoke : star.spokes) {
    if (!spoke.onBoundary())
      continue;
    const int cell = star.cells[std::size_t(spoke.cell[0])].cell;
    if (const int index = body_->boundaryIndex(cell, spoke.facet[0]); index >= 0 && !data.facetShares.empty())
      addShare(star, spoke, data.facetShares.data(), index, x);
    const Vector* contact = fields_[std::size_t(field)].contact;
    if (const int index = body_->contactIndex(cell, spoke.facet[0]); index >= 0 && contact != nullptr)
      addShare(star, spoke, contact->data(), index, x);
  }
  const int loads = body_->reference().loads;
  for (std::size_t c = 0; c < star.cells.size() && !data.cellShares.empty(); ++c) {
    const StarCell& cell = star.cells[c];
    const double* share =
        data.cellShares.data() +
        (std::ptrdiff_t(cell.cell) * std::ptrdiff_t(data.dim + 1) + std::ptrdiff_t(cell.apex)) * loads;
    double* target = x + std::ptrdiff_t(c) * body_->reference().data() + body_->reference().tractions;
    for (int i = 0; i < loads; ++i)
      target[i] -= share[i];
  }
}

StarFields StarLoads::initial(const Star& star, Vector& forces) const
{
  const int data = body_->reference().data(), facetData = body_->facetData();
  StarFields fields(int(star.cells.size()) * data, int(fields_.size()));
  Vector loads(std::size_t(fields.rows()));
  forces.assign(fields_.size(), 0.0);
  for (int field = 0; field < fields.cols(); ++field) {
    double *x = fields.col(field), &force = forces[std::size_t(field)];
    std::fill(loads.begin(), loads.end(), 0.0);
    addStress(star, field, x);
    addLoads(star, field, loads.data());
    for (std::size_t i = 0; i < loads.size(); ++i) {
      force += std::abs(x[i]) + std::abs(loads[i]);
      x[i] += loads[i];
    }
    for (const Spoke& spoke : star.spokes) {
      double* first = x + std::ptrdiff_t(spoke.cell[0]) * data + std::ptrdiff_t(spoke.facet[0]) * facetData;
      if (!spoke.onBoundary()) {
        double* second = x + std::ptrdiff_t(spoke.cell[1]) * data + std::ptrdiff_t(spoke.facet[1]) * facetData;
        for (int i = 0; i < facetData; ++i) {
          second[i] += first[i];
          first[i] = 0.0;
        }
      } else if (const int index = body_->boundaryIndex(star.cells[std::size_t(spoke.cell[0])].cell, spoke.facet[0]);
                 index >= 0)
        body_->data().boundary[std::size_t(index)].removeSupported(body_->dim(), std::size_t(body_->facetModes()),
                                                                   first);
    }
  }
  return fields;
}

namespace
{

/// Calls visit(value in x, value in the correction) for all data of a star.
template <class Fields, class Visit>
void visitData(const StarBody& body, const Star& star, Fields& x, const BodyCorrections& corrections,
               const Visit& visit)
{
  const std::size_t tractions = std::size_t(body.reference().tractions), loads = std::size_t(body.reference().loads);
  for (std::size_t field = 0; field < corrections.size(); ++field) {
    auto* column = x.col(int(field));
    for (const StarCell& cell : star.cells) {
      double* traction = corrections[field]->tractions.data() + std::size_t(cell.cell) * tractions;
      for (std::size_t i = 0; i < tractions; ++i)
        visit(*column++, traction[i]);
      double* load = corrections[field]->loads.data() + std::size_t(cell.cell) * loads;
      for (std::size_t i = 0; i < loads; ++i)
        visit(*column++, load[i]);
    }
  }
}

} // namespace

StarFields gather(const StarBody& body, const Star& star, const BodyCorrections& corrections)
{
  StarFields x(int(star.cells.size()) * body.reference().data(), int(corrections.size()));
  visitData(body, star, x, corrections, [](double& value, double stored) { value = stored; });
  return x;
}

void scatter(const StarBody& body, const Star& star, const StarFields& x, const BodyCorrections& corrections)
{
  visitData(body, star, x, corrections, [](double value, double& stored) { stored = value; });
}

void add(const StarBody& body, const Star& star, const StarFields& x, const BodyCorrections& corrections)
{
  visitData(body, star, x, corrections, [](double value, double& stored) { stored += value; });
}

} // namespace ndframe
