#include "nemesis_records.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "exodus_content.hpp"
#include "piece_borders.hpp"

namespace ndframe
{
namespace
{

/// 1, 2, ..., as blocks and side sets are called.
std::vector<int> idsOf(std::size_t count)
{
  std::vector<int> ids(count);
  std::iota(ids.begin(), ids.end(), 1);
  return ids;
}

/// Numbers from 1 to `count`, those that are in `border` (ascending, perhaps several times) apart from the others.
void split(int count, std::vector<int>& border, std::vector<int>& inner)
{
  std::sort(border.begin(), border.end());
  border.erase(std::unique(border.begin(), border.end()), border.end());
  const std::vector<int> all = idsOf(std::size_t(count));
  std::set_difference(all.begin(), all.end(), border.begin(), border.end(), std::back_inserter(inner));
}

} // namespace

NemesisRecords::NemesisRecords(const ExodusLayout& whole, const ExodusLayout& piece, const PieceScene& scene,
                               const ExodusSharing& sharing, int number)
    : whole_{whole.numNodes(), whole.numCells(), {}, {}}, pieces_(sharing.pieces), number_(number),
      elementNumbers_(std::size_t(piece.numCells()))
{
  for (const ElementBlock& block : whole.blocks)
    whole_.blocks.push_back(block.numCells);
  for (const SideSet& set : whole.sets)
    whole_.sets.push_back(int(set.size));
  for (std::size_t b = 0; b < scene.parts().size(); ++b) {
    const PieceBody& part = scene.parts()[b];
    for (const int node : part.ofBody)
      nodeNumbers_.push_back(whole.firstNode[b] + node + 1);
    for (std::size_t cell = 0; cell < part.cells.size(); ++cell)
      elementNumbers_[std::size_t(piece.element(int(b), int(cell)))] = whole.element(int(b), part.cells[cell]) + 1;
  }
  std::vector<std::vector<PieceBorder>> borders;
  for (std::size_t b = 0; b < scene.parts().size(); ++b)
    borders.push_back(bordersOf(*(*whole.bodies)[b].nodes, sharing.owner[b], number_));
  addBorders(borders, piece, scene);
}

NemesisRecords::NemesisRecords(const ExodusLayout& piece, const PieceScene& scene, const ExodusWhole& whole)
    : pieces_(whole.pieces), number_(whole.piece), elementNumbers_(std::size_t(piece.numCells()))
{
  for (std::size_t b = 0; b < scene.parts().size(); ++b) {
    const PieceBody& part = scene.parts()[b];
    for (const int node : part.ofBody)
      nodeNumbers_.push_back(int(whole_.nodes + whole.nodes[b][std::size_t(node)] + 1));
    for (std::size_t cell = 0; cell < part.cells.size(); ++cell)
      elementNumbers_[std::size_t(piece.element(int(b), int(cell)))] =
          int(whole_.cells + whole.elements[b][std::size_t(part.cells[cell])] + 1);
    whole_.nodes += whole.numNodes[b];
    whole_.cells += whole.numCells[b];
  }
  if (std::max(whole_.nodes, whole_.cells) > std::numeric_limits<int>::max())
    throw std::runtime_error("the pieces have more nodes or elements together than 32-bit numbers can count");
  whole_.blocks.assign(whole.numElements.begin(), whole.numElements.end());
  whole_.sets.assign(whole.numFacets.begin(), whole.numFacets.end());
  addBorders(whole.borders, piece, scene);
}

void NemesisRecords::addBorders(const std::vector<std::vector<PieceBorder>>& borders, const ExodusLayout& piece,
                                const PieceScene& scene)
{
  std::vector<Common> common(static_cast<std::size_t>(pieces_));
  for (std::size_t b = 0; b < scene.parts().size(); ++b) {
    const PieceBody& part = scene.parts()[b];
    for (const PieceBorder& border : borders[b]) {
      Common& with = common[std::size_t(border.other)];
      for (const int node : border.nodes) {
        const auto found = std::lower_bound(part.ofBody.begin(), part.ofBody.end(), node);
        with.nodes.push_back(piece.firstNode[b] + int(found - part.ofBody.begin()) + 1);
      }
      for (const Facet facet : border.facets) {
        with.elements.push_back(piece.element(int(b), part.inPiece[std::size_t(facet.cell)]) + 1);
        with.sides.push_back(exodusSide(facet.local));
      }
    }
  }
  for (std::size_t other = 0; other < common.size(); ++other) {
    common[other].other = int(other);
    if (!common[other].nodes.empty())
      common_.push_back(std::move(common[other]));
  }
  separate(piece);
}

void NemesisRecords::separate(const ExodusLayout& piece)
{
  for (const Common& with : common_) {
    borderNodes_.insert(borderNodes_.end(), with.nodes.begin(), with.nodes.end());
    borderElements_.insert(borderElements_.end(), with.elements.begin(), with.elements.end());
  }
  split(piece.numNodes(), borderNodes_, innerNodes_);
  split(piece.numCells(), borderElements_, innerElements_);
}

void NemesisRecords::putWhole(ExodusFile& file)
{
  CStrings kind({"p"}); // one piece per file
  file.call("the number of pieces", ex_put_init_info, pieces_, 1, kind.data()[0]);
  file.call("the sizes of the whole", ex_put_init_global, whole_.nodes, whole_.cells, whole_.blocks.size(), 0,
            whole_.sets.size());
  std::vector<int> blocks = idsOf(whole_.blocks.size()), sets = idsOf(whole_.sets.size());
  std::vector<int> factors(sets.size(), 0);
  file.call("the blocks of the whole", ex_put_eb_info_global, blocks.data(), whole_.blocks.data());
  if (!sets.empty())
    file.call("the side sets of the whole", ex_put_ss_param_global, sets.data(), whole_.sets.data(), factors.data());
}

/// Maps of communication are called by the other piece's number, from 1; one without facets is for nodes only.
void NemesisRecords::putBalance(ExodusFile& file)
{
  std::vector<int> nodeMaps, nodes, elementMaps, elements;
  for (const Common& with : common_) {
    nodeMaps.push_back(with.other + 1);
    nodes.push_back(int(with.nodes.size()));
    if (with.elements.empty())
      continue;
    elementMaps.push_back(with.other + 1);
    elements.push_back(int(with.elements.size()));
  }
  file.call("the sizes of the piece", ex_put_loadbal_param, innerNodes_.size(), borderNodes_.size(), 0,
            innerElements_.size(), borderElements_.size(), nodeMaps.size(), elementMaps.size(), number_);
  file.call("the sizes of what pieces share", ex_put_cmap_params, nodeMaps.data(), nodes.data(), elementMaps.data(),
            elements.data(), number_);
}

void NemesisRecords::putMaps(ExodusFile& file)
{
  file.call("the node numbers of the whole", ex_put_id_map, EX_NODE_MAP, nodeNumbers_.data());
  file.call("the element numbers of the whole", ex_put_id_map, EX_ELEM_MAP, elementNumbers_.data());
  file.call("the inner and the border nodes", ex_put_processor_node_maps, innerNodes_.data(), borderNodes_.data(),
            static_cast<int*>(nullptr), number_);
  file.call("the inner and the border elements", ex_put_processor_elem_maps, innerElements_.data(),
            borderElements_.data(), number_);
  for (Common& with : common_) {
    std::vector<int> owners(std::max(with.nodes.size(), with.elements.size()), with.other);
    file.call("the nodes that another piece has", ex_put_node_cmap, with.other + 1, with.nodes.data(), owners.data(),
              number_);
    if (!with.elements.empty())
      file.call("the elements beside another piece", ex_put_elem_cmap, with.other + 1, with.elements.data(),
                with.sides.data(), owners.data(), number_);
  }
}

void NemesisRecords::put(ExodusFile& file)
{
  putWhole(file);
  putBalance(file);
  putMaps(file);
}

} // namespace ndframe
