#include "ndframe/admissibility/make_static_data.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "doubt.hpp"
#include "load_moments.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/simd/cell_distances.hpp"
#include "oscillation.hpp"

namespace ndframe
{
namespace
{

/// Degree of the richest stresses there are: they carry most of what the stresses of lower degree leave over.
int richestDegree(int dim)
{
  return dim == 2 ? 3 : 2;
}

/// The independent directions that all supports prescribe on each facet they share, by facet: reduced like those at
/// nodes.
ConstraintSet supportedDirections(const BodyModel& body)
{
  ConstraintSet supported(body.mesh.dim, 1.0);
  for (const auto& support : body.supports)
    for (const Facet facet : support->facets(body.mesh))
      for (const Direction& direction : support->directions(body.mesh))
        supported.add({facet.cell * (body.mesh.dim + 1) + facet.local, direction, 0.0});
  return supported;
}

/// Fills StaticData load by load.
class DataBuilder
{
public:
  DataBuilder(const BodyModel& body, StaticData& data)
      : body_(body), data_(data),
        onFacets_(LoadMoments::onFacets(data.dim, data.order, data.degree, richestDegree(data.dim))),
        inCells_(LoadMoments::inCells(data.dim, data.order, data.degree, richestDegree(data.dim)))
  {
    data_.oscillation.assign(std::size_t(body.mesh.numCells()), 0.0);
    data_.rest = data_.oscillation;
  }

  void listBoundary();
  void addLoad(const Load& load);
  /// Turns the sums over each cell's loads, which are bounds for |eps(v)|, into squared bounds for the energy norm.
  void finish();

private:
  int number(Facet facet) const { return facet.cell * (body_.mesh.dim + 1) + facet.local; }
  void addOnFacet(LoadedSimplex simplex);
  void addInCell(const LoadedSimplex& simplex);
  static void addTo(std::vector<double>& all, std::size_t place, const std::vector<double>& values,
                    double factor = 1.0);
  void addBound(const LoadedSimplex& simplex, const SimplexMoments& moments);

  const BodyModel& body_;
  StaticData& data_;
  LoadMoments onFacets_, inCells_;
  std::map<int, std::size_t> place_; ///< in data.boundary, by facet
};

void DataBuilder::listBoundary()
{
  const auto supported = supportedDirections(body_);
  std::map<int, BoundaryFacet> found;
  const auto facetOf = [&](int number) { return Facet{number / (body_.mesh.dim + 1), number % (body_.mesh.dim + 1)}; };
  for (const auto& [number, node] : supported.nodes())
    found[number] = {facetOf(number), node.count, node.direction};
  for (const auto& load : body_.loads)
    if (const auto* facets = load->facets(body_.mesh))
      for (const Facet facet : *facets)
        found.insert({number(facet), {facet, 0, {}}});
  for (const auto& [number, facet] : found) {
    place_[number] = data_.boundary.size();
    data_.boundary.push_back(facet);
  }
  const auto modes = std::size_t(facetBasis(data_.dim, data_.degree).size());
  data_.facetShares.assign(found.size() * std::size_t(data_.dim) * std::size_t(data_.dim) * modes, 0.0);
}

void DataBuilder::addTo(std::vector<double>& all, std::size_t place, const std::vector<double>& values, double factor)
{
  for (std::size_t i = 0; i < values.size(); ++i)
    all[place * values.size() + i] += factor * values[i];
}

/// Only what no support takes counts.
void DataBuilder::addOnFacet(LoadedSimplex simplex)
{
  const std::size_t place = place_.at(number(simplex.facet)), dim = std::size_t(data_.dim);
  Vector& values = simplex.samples.values;
  data_.boundary[place].removeSupported(data_.dim, values.size() / dim, values.data());
  const SimplexMoments& moments = onFacets_.of(simplex);
  addTo(data_.facetShares, place, moments.shares);
  if (!moments.beyond.empty()) {
    const std::size_t first = std::size_t(simplex.facet.cell) * (dim + 1);
    Vector& traction = data_.liftedTractions[first + std::size_t(sortedFacet(body_.mesh, simplex.facet))];
    traction.resize(moments.beyond.size(), 0.0);
    addTo(traction, 0, moments.beyond);
  }
  addBound(simplex, moments);
}

void DataBuilder::addInCell(const LoadedSimplex& simplex)
{
  const auto cell = std::size_t(simplex.facet.cell);
  const SimplexMoments& moments = inCells_.of(simplex);
  data_.cellShares.resize(moments.shares.size() * std::size_t(body_.mesh.numCells()), 0.0);
  addTo(data_.cellShares, cell, moments.shares);
  if (!moments.beyond.empty()) {
    data_.liftedLoads.resize(data_.oscillation.size() * moments.beyond.size(), 0.0);
    addTo(data_.liftedLoads, cell, moments.beyond, -1.0); // moments of the divergence
  }
  addBound(simplex, moments);
}

void DataBuilder::addLoad(const Load& load)
{
  Doubt doubt;
  visitLoad(load, body_.mesh, [&](const LoadedSimplex& simplex) {
    doubt.add(simplex.samples, body_.mesh, simplex.isCell ? body_.mesh.dim : body_.mesh.dim - 1,
              simplex.vertices.data());
    simplex.isCell ? addInCell(simplex) : addOnFacet(simplex);
  });
  if (doubt)
    data_.caveat +=
        fmt::format("the integrals of the {} of {} are not certain near {} ({}); let it be smooth on both sides of its "
                    "jumps and kinks{}. ",
                    load.description(), body_.name, doubt.place, doubt.size(),
                    body_.mesh.dim == 3 ? ", which should be planes inside a solid" : "");
}

void DataBuilder::addBound(const LoadedSimplex& simplex, const SimplexMoments& moments)
{
  if (moments.rest + moments.others + moments.beyondNorm == 0.0)
    return;
  const Mesh& mesh = body_.mesh;
  const Facet facet = simplex.facet;
  const double constant =
      simplex.isCell ? cellOscillationConstant(mesh, facet.cell) : facetOscillationConstant(mesh, facet);
  const double share = simplex.isCell ? 1.0 : shareBeyondPolynomials(mesh.dim, richestDegree(mesh.dim));
  const double rest = constant * (share * moments.rest + moments.others);
  data_.rest[std::size_t(facet.cell)] += rest;
  data_.oscillation[std::size_t(facet.cell)] += rest + constant * moments.beyondNorm;
}

void DataBuilder::finish()
{
  const Vector stiffness = smallestStiffness(body_.laws);
  double largest = 0.0;
  for (std::size_t cell = 0; cell < data_.oscillation.size(); ++cell) {
    double& bound = data_.oscillation[cell];
    bound *= bound / stiffness[std::size_t(body_.laws.number(int(cell)))];
    largest = std::max(largest, bound);
  }
  if (largest == 0.0)
    data_.rest = {};
}

/// Of the stress that carries what the shares leave over.
Vector liftedEnergies(const BodyModel& body, StaticData& data)
{
  if (data.liftedTractions.empty() && data.liftedLoads.empty())
    return Vector(data.oscillation.size(), 0.0);
  StressCorrection whole = zeroCorrection(body.mesh, richestDegree(body.mesh.dim));
  for (const auto& [place, traction] : data.liftedTractions)
    std::copy(traction.begin(), traction.end(), whole.tractions.data() + place * traction.size());
  if (!data.liftedLoads.empty())
    whole.loads = std::move(data.liftedLoads);
  return cellDistances(body, whole, nullptr);
}

} // namespace

StaticData makeStaticData(const BodyModel& body, int degree, std::vector<Facet> contact, OscillationBound bound)
{
  StaticData data;
  data.dim = body.mesh.dim;
  data.order = body.nodes.order;
  data.degree = degree;
  data.contact = std::move(contact);
  DataBuilder builder(body, data);
  builder.listBoundary();
  for (const auto& load : body.loads)
    builder.addLoad(*load);
  builder.finish();
  if (bound == OscillationBound::Sharp)
    sharpenOscillation(body, data);
  return data;
}

/// The stress tau with div tau = - (b - b_h) in a cell and tau n = p - p_h on its facets gives
/// (b - b_h, v) + (p - p_h, v) = (tau, eps(v)) <= |tau| |v|; the constants bound what it does not carry.
void sharpenOscillation(const BodyModel& body, StaticData& data)
{
  if (data.rest.empty())
    return;
  const Vector stiffness = smallestStiffness(body.laws), carried = liftedEnergies(body, data);
  for (std::size_t cell = 0; cell < carried.size(); ++cell) {
    const double rest = data.rest[cell] / std::sqrt(stiffness[std::size_t(body.laws.number(int(cell)))]);
    data.oscillation[cell] = std::min(data.oscillation[cell], std::pow(std::sqrt(carried[cell]) + rest, 2));
  }
  data.liftedTractions.clear();
  data.liftedLoads = {};
  data.rest = {};
}

} // namespace ndframe
