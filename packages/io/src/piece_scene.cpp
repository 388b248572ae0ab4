#include "piece_scene.hpp"

#include <algorithm>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// Numbers of the chosen facets, which get their cells' numbers in the piece.
std::vector<int> takeFacets(const std::vector<Facet>& facets, const PieceBody& part, std::vector<Facet>& taken)
{
  std::vector<int> numbers;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const int cell = part.inPiece[std::size_t(facets[f].cell)];
    if (cell < 0)
      continue;
    taken.push_back({cell, facets[f].local});
    numbers.push_back(int(f));
  }
  return numbers;
}

void takeNodes(const NodeMap& whole, PieceBody& part)
{
  part.nodes = {whole.dim, whole.order, whole.nodesPerCell, whole.nodesPerFacet, {}, {}, {}};
  for (const int cell : part.cells)
    part.nodes.cellNodes.insert(part.nodes.cellNodes.end(), whole.cell(cell), whole.cell(cell) + whole.nodesPerCell);
  part.ofBody = part.nodes.cellNodes;
  std::sort(part.ofBody.begin(), part.ofBody.end());
  part.ofBody.erase(std::unique(part.ofBody.begin(), part.ofBody.end()), part.ofBody.end());
  const auto numberOf = [&](int node) {
    return int(std::lower_bound(part.ofBody.begin(), part.ofBody.end(), node) - part.ofBody.begin());
  };
  for (int& node : part.nodes.cellNodes)
    node = numberOf(node);
  for (const int node : part.ofBody)
    if (const auto x = whole.point(node); node < whole.numVertices())
      part.nodes.points.insert(part.nodes.points.end(), x.begin(), x.begin() + whole.dim);
    else
      part.nodes.edges.push_back({numberOf(whole.ends(node)[0]), numberOf(whole.ends(node)[1])});
}

PieceBody takeBody(const ExodusBody& body, const std::vector<int>& owner, int piece)
{
  PieceBody part;
  part.inPiece.assign(owner.size(), -1);
  for (std::size_t cell = 0; cell < owner.size(); ++cell)
    if (owner[cell] == piece) {
      part.inPiece[cell] = int(part.cells.size());
      part.cells.push_back(int(cell));
    }
  takeNodes(*body.nodes, part);
  part.mesh.dim = body.mesh->dim;
  for (const Side& side : body.mesh->sides) {
    part.mesh.sides.push_back({side.name, {}});
    takeFacets(side.facets, part, part.mesh.sides.back().facets);
  }
  return part;
}

std::vector<ExodusPart> takeParts(const std::vector<ExodusPart>& parts, const std::vector<int>& inPiece)
{
  std::vector<ExodusPart> taken;
  for (const ExodusPart& part : parts) {
    taken.push_back({part.name, {}});
    for (const int cell : part.cells)
      if (inPiece[std::size_t(cell)] >= 0)
        taken.back().cells.push_back(inPiece[std::size_t(cell)]);
  }
  return taken;
}

std::vector<NamedField> chosen(const std::vector<NamedField>& fields, const std::vector<int>& places)
{
  std::vector<NamedField> taken;
  for (const NamedField& field : fields) {
    taken.push_back({field.name, {}});
    taken.back().values.reserve(places.size());
    for (const int place : places)
      taken.back().values.push_back(field.values[std::size_t(place)]);
  }
  return taken;
}

} // namespace

PieceScene::PieceScene(const std::vector<ExodusBody>& bodies, const std::vector<ExodusContactSide>& contactSides,
                       const ExodusSharing& sharing, int piece)
{
  NDFRAME_ASSERT(sharing.owner.size() == bodies.size() && piece >= 0 && piece < sharing.pieces,
                 "cells of all bodies are shared out, and there is such a piece");
  parts_.reserve(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    parts_.push_back(takeBody(bodies[b], sharing.owner[b], piece));
    bodies_.push_back(
        {bodies[b].name, &parts_[b].mesh, &parts_[b].nodes, takeParts(bodies[b].parts, parts_[b].inPiece)});
  }
  for (const ExodusContactSide& side : contactSides) {
    sides_.push_back({side.name, side.body, {}});
    facets_.push_back(takeFacets(side.facets, parts_[std::size_t(side.body)], sides_.back().facets));
  }
}

ExodusStep PieceScene::restricted(const ExodusStep& step) const
{
  ExodusStep taken{step.time, {}, {}, {}, step.global};
  for (std::size_t b = 0; b < parts_.size(); ++b) {
    taken.nodal.push_back(chosen(step.nodal[b], parts_[b].ofBody));
    taken.element.push_back(chosen(step.element[b], parts_[b].cells));
  }
  for (std::size_t s = 0; s < facets_.size(); ++s)
    taken.contactSide.push_back(chosen(step.contactSide[s], facets_[s]));
  return taken;
}

} // namespace ndframe
