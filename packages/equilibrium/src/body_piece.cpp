#include "ndframe/equilibrium/body_piece.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/base/ascending.hpp"
#include "ndframe/equilibrium/reference_stress.hpp"

namespace ndframe
{
namespace
{

/// The blocks of `all` at these places.
template <class Values>
Values selected(const Values& all, std::size_t size, const std::vector<int>& places)
{
  Values result;
  result.reserve(places.size() * size);
  for (const int place : places) {
    const auto begin = all.begin() + std::ptrdiff_t(place) * std::ptrdiff_t(size);
    result.insert(result.end(), begin, begin + std::ptrdiff_t(size));
  }
  return result;
}

void holdCells(const BodyModel& body, const std::vector<int>& owner, const std::vector<char>& isTouched,
               BodyPiece& piece)
{
  std::vector<char> isUsed(std::size_t(body.mesh.numPoints()), 0);
  const int corners = body.mesh.dim + 1;
  for (int cell = 0; cell < body.mesh.numCells(); ++cell) {
    const int* vertices = body.mesh.cell(cell);
    if (std::none_of(vertices, vertices + corners, [&](int v) { return isTouched[std::size_t(v)] != 0; }))
      continue;
    piece.cells.push_back(cell);
    for (int i = 0; i < corners; ++i)
      isUsed[std::size_t(vertices[i])] = 1;
  }
  const auto number = [&](int cell) { return body.share ? body.share->cells().numbers[std::size_t(cell)] : cell; };
  std::sort(piece.cells.begin(), piece.cells.end(), [&](int a, int b) { return number(a) < number(b); });
  piece.places.assign(std::size_t(body.mesh.numCells()), -1);
  for (std::size_t i = 0; i < piece.cells.size(); ++i) {
    const int cell = piece.cells[i];
    piece.places[std::size_t(cell)] = int(i);
    piece.numbers.push_back(number(cell));
    piece.owner.push_back(owner[std::size_t(cell)]);
  }
  for (int v = 0; v < body.mesh.numPoints(); ++v)
    if (isUsed[std::size_t(v)] != 0)
      piece.points.push_back(v);
}

void cutModel(const BodyModel& body, BodyPiece& piece)
{
  BodyModel& model = piece.model;
  model.name = body.name;
  model.mesh.dim = body.mesh.dim;
  model.mesh.points = selected(body.mesh.points, std::size_t(body.mesh.dim), piece.points);
  model.mesh.cells = selected(body.mesh.cells, std::size_t(body.mesh.dim) + 1, piece.cells);
  for (int& vertex : model.mesh.cells)
    vertex = placeOf(piece.points, vertex);
  model.nodes.dim = body.nodes.dim;
  model.nodes.order = body.nodes.order;
  model.nodes.nodesPerCell = body.nodes.nodesPerCell;
  model.nodes.nodesPerFacet = body.nodes.nodesPerFacet;
  model.nodes.cellNodes = selected(body.nodes.cellNodes, std::size_t(body.nodes.nodesPerCell), piece.cells);
  std::vector<int> laws;
  for (const int cell : piece.cells)
    laws.push_back(body.laws.number(cell));
  model.laws = CellLaws(body.laws.all(), laws);
}

void cutData(const StaticData& data, BodyPiece& piece)
{
  piece.data.dim = data.dim;
  piece.data.order = data.order;
  piece.data.degree = data.degree;
  std::vector<int> boundary;
  for (std::size_t i = 0; i < data.boundary.size(); ++i)
    if (const int cell = piece.local(data.boundary[i].facet.cell); cell >= 0) {
      boundary.push_back(int(i));
      piece.data.boundary.push_back(data.boundary[i]);
      piece.data.boundary.back().facet.cell = cell;
    }
  if (!data.boundary.empty())
    piece.data.facetShares = selected(data.facetShares, data.facetShares.size() / data.boundary.size(), boundary);
  const auto cells = piece.places.size();
  if (cells > 0)
    piece.data.cellShares = selected(data.cellShares, data.cellShares.size() / cells, piece.cells);
  for (std::size_t i = 0; i < data.contact.size(); ++i)
    if (const int cell = piece.local(data.contact[i].cell); cell >= 0) {
      piece.contact.push_back(int(i));
      piece.data.contact.push_back({cell, data.contact[i].local});
    }
}

void measureBody(BodyPiece& piece, const Comm& comm)
{
  Vector low(3, HUGE_VAL), high(3, -HUGE_VAL);
  const Mesh& mesh = piece.model.mesh;
  const auto dim = std::size_t(mesh.dim);
  for (int v = 0; v < mesh.numPoints(); ++v)
    for (std::size_t i = 0; i < dim; ++i) {
      low[i] = std::min(low[i], mesh.point(v)[i]);
      high[i] = std::max(high[i], mesh.point(v)[i]);
    }
  takeExtremes(low, high, comm);
  for (std::size_t i = 0; i < dim; ++i) {
    piece.centre[i] = 0.5 * (high[i] + low[i]);
    piece.extent = std::hypot(piece.extent, high[i] - low[i]);
  }
}

} // namespace

std::vector<int> BodyPiece::ownCells() const
{
  std::vector<int> own;
  for (int cell = 0; cell < int(cells.size()); ++cell)
    if (owns(cell))
      own.push_back(cell);
  return own;
}

int BodyPiece::held(std::int64_t number) const
{
  return placeOf(numbers, number);
}

Vector BodyPiece::ofContact(const Vector& all) const
{
  return numContact == 0 ? Vector() : selected(all, all.size() / numContact, contact);
}

void BodyPiece::gather(StressCorrection& correction, const Comm& comm) const
{
  for (Vector* values : {&correction.tractions, &correction.loads}) {
    const ReferenceStress& reference = referenceStress(correction.dim, correction.degree);
    const auto size = std::size_t(values == &correction.tractions ? reference.tractions : reference.loads);
    Vector all(places.size() * size, 0.0);
    for (std::size_t cell = 0; cell < cells.size(); ++cell)
      if (body->share || owns(int(cell)))
        std::copy_n(values->begin() + std::ptrdiff_t(cell) * std::ptrdiff_t(size), size,
                    all.begin() + std::ptrdiff_t(cells[cell]) * std::ptrdiff_t(size));
    if (!body->share)
      comm.sum(all);
    *values = std::move(all);
  }
}

void BodyPiece::fetchGhosts(StressCorrection& correction) const
{
  for (Vector* values : {&correction.tractions, &correction.loads}) {
    const std::size_t size = cells.empty() ? 0 : values->size() / cells.size();
    shared.fetch([&](int cell) { return SharedValues::Place{std::size_t(cell) * size, size}; }, *values);
  }
}

BodyPiece cutPiece(const BodyModel& body, const StaticData& data, const std::vector<int>& owner,
                   const std::vector<char>& isTouched, const Comm& comm)
{
  BodyPiece piece;
  piece.body = &body;
  piece.rank = comm.rank();
  piece.numContact = data.contact.size();
  holdCells(body, owner, isTouched, piece);
  cutModel(body, piece);
  cutData(data, piece);
  measureBody(piece, comm);
  piece.shared = sharedByOwners(
      piece.numbers, piece.owner, [&piece](std::int64_t number) { return piece.held(number); }, comm);
  return piece;
}

} // namespace ndframe
