#include "batched_star_data.hpp"

#include "batched_cell_pass.hpp"

namespace ndframe
{
namespace
{

/// Adds a vertex's share of a traction on a facet, L_k turned to count from the vertex. shares: per facet vertex
/// (ascending), per mode, per component.
void addShare(const double* shares, int modes, bool isUpperVertex, double* moments)
{
  for (int mode = 0; mode < modes; ++mode)
    for (int i = 0; i < 2; ++i) {
      const double moment = shares[((isUpperVertex ? modes : 0) + mode) * 2 + i];
      moments[2 * mode + i] += isUpperVertex && mode % 2 == 1 ? -moment : moment;
    }
}

} // namespace

BatchedStarData::BatchedStarData(const BodyModel& model, const StaticData& staticData, const BatchedKernels& chosen)
    : body(model), data(staticData), kernels(chosen), rings(model.mesh),
      tables(data.degree, model.nodes.order, model.laws.all().front()), laws(severalLaws(model.laws)),
      permutations(data.degree), loadShares(loadBasis(2, data.degree), model.nodes.order)
{
  for (std::size_t i = 0; i < data.boundary.size(); ++i)
    boundary[3 * data.boundary[i].facet.cell + data.boundary[i].facet.local] = int(i);
  for (std::size_t i = 0; i < data.contact.size(); ++i)
    contact[3 * data.contact[i].cell + data.contact[i].local] = int(i);
}

StarFieldInputs::StarFieldInputs(const BatchedStarData& stars, const std::vector<FieldInput>& fields)
{
  for (const FieldInput& field : fields) {
    stress.push_back(vertexStress(stars.body, stars.kernels, *field.displacement));
    contact.push_back(field.contact);
  }
}

FanEnd fanEnd(const BatchedStarData& stars, int vertex, int other, int facet, const StarFieldInputs* inputs, int fields)
{
  const int modes = stars.data.degree + 1;
  const bool isUpper = vertex > other;
  FanEnd end;
  for (int i = 0; i < 2; ++i)
    end.spoke[std::size_t(i)] = stars.body.mesh.point(other)[i] - stars.body.mesh.point(vertex)[i];
  end.given.assign(2 * std::size_t(modes) * std::size_t(fields), 0.0);
  const auto boundary = stars.boundary.find(facet);
  if (boundary != stars.boundary.end()) {
    const BoundaryFacet& prescribed = stars.data.boundary[std::size_t(boundary->second)];
    end.freeDirections = 2 - prescribed.supported;
    if (prescribed.supported == 1)
      end.direction[0] = {-prescribed.directions[0][1], prescribed.directions[0][0]};
  }
  if (inputs == nullptr)
    return end;
  const auto contact = stars.contact.find(facet);
  for (int k = 0; k < fields; ++k) {
    double* moments = end.given.data() + std::ptrdiff_t(2) * modes * k;
    if (boundary != stars.boundary.end())
      addShare(stars.data.facetShares.data() + std::ptrdiff_t(4) * modes * boundary->second, modes, isUpper, moments);
    if (contact != stars.contact.end() && inputs->contact[std::size_t(k)] != nullptr)
      addShare(inputs->contact[std::size_t(k)]->data() + std::ptrdiff_t(4) * modes * contact->second, modes, isUpper,
               moments);
  }
  return end;
}

} // namespace ndframe
