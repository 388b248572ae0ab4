#include "element_distances.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/assembly/fields.hpp"
#include "ndframe/recovery/scene_pieces.hpp"
#include "ndframe/simd/cell_distances.hpp"

namespace ndframe
{
namespace
{

/// Cells that a thread measures before it takes the next ones.
constexpr std::int64_t group = 256;

/// Of the body, or own ones of a share.
std::vector<int> allCells(const BodyModel& body)
{
  std::vector<int> cells(std::size_t(countedCells(body).size()));
  std::iota(cells.begin(), cells.end(), 0);
  return cells;
}

/// What this rank measures of some cells of a solid.
struct Share
{
  const BodyModel* model;
  std::vector<int> cells;  ///< of the model
  std::vector<int> places; ///< and which of the given ones they are
};

/// The own cells of the rank's piece; a range of them where all ranks have all.
Share shareOf(const CertifiedScene& scene, std::size_t body, const SceneStress& stress, const std::vector<int>& cells)
{
  if (stress.pieces) {
    const BodyPiece& piece = *stress.pieces->bodies[body];
    Share share{&piece.model, {}, {}};
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (const int cell = piece.local(cells[i]); cell >= 0 && piece.owns(cell)) {
        share.cells.push_back(cell);
        share.places.push_back(int(i));
      }
    return share;
  }
  const auto begin = [&](int rank) { return std::int64_t(cells.size()) * rank / scene.comm.size(); };
  const std::int64_t first = begin(scene.comm.rank()), last = begin(scene.comm.rank() + 1);
  Share share{
      scene.bodies[body], {cells.begin() + first, cells.begin() + last}, std::vector<int>(std::size_t(last - first))};
  std::iota(share.places.begin(), share.places.end(), int(first));
  return share;
}

} // namespace

CellValues elementDistances(const CertifiedScene& scene, std::size_t body, const SceneStress& stress, const Vector* v,
                            const std::vector<int>* cells)
{
  const StressCorrection& correction = stress.corrections[body];
  if (scene.dim() == 2)
    return ofCells(cellDistances(*scene.bodies[body], correction, v));
  const BodyModel& model = *scene.bodies[body];
  const std::vector<int> all = cells == nullptr ? allCells(model) : *cells;
  Vector found(cells == nullptr ? std::size_t(model.mesh.numCells()) : all.size(), 0.0);
  const Share share = shareOf(scene, body, stress, all);
  const auto size = std::int64_t(share.places.size());
  runInRanges(int((size + group - 1) / group), numThreads(scene.comm), [&](int first, int last) {
    const std::int64_t from = first * group, to = std::min(last * group, size);
    const Vector distances = solidDistances(*share.model, correction, v,
                                            std::vector<int>(share.cells.begin() + from, share.cells.begin() + to));
    for (std::int64_t i = from; i < to; ++i)
      found[std::size_t(share.places[std::size_t(i)])] = distances[std::size_t(i - from)];
  });
  if (!model.share)
    scene.comm.sum(found);
  return ofCells(std::move(found));
}

ElementDistances::ElementDistances(const CertifiedScene& scene, const RecoveredField& recovered)
    : scene_(scene), recovered_(recovered), last_(scene.bodies.size())
{
  for (const BodyModel* body : scene.bodies)
    distances_.emplace_back(IndexMap::whole(body->mesh.numCells()), 1);
}

const std::vector<CellValues>& ElementDistances::to(const std::vector<NodalField>& displacement)
{
  std::vector<NodalField> v(scene_.bodies.size());
  for (const int body : scene_.model.elasticBodies()) {
    const auto b = std::size_t(body);
    v[b] = atNodes(difference(recovered_.field.displacement[b], displacement[b]), scene_.dim());
    if (scene_.dim() == 2)
      continue;
    const std::vector<int> cells = changed(b, v[b]);
    const CellValues found = elementDistances(scene_, b, recovered_.stress, &v[b].whole(), &cells);
    for (std::size_t c = 0; c < cells.size(); ++c)
      distances_[b][std::size_t(cells[c])] = found[c];
  }
  if (scene_.dim() == 2)
    runLargestFirst(scene_.model.numDofs(), scene_.condensed.threads, [&](int body) {
      const auto b = std::size_t(body);
      if (!scene_.bodies[b]->isRigid && !(v[b] == last_[b]))
        distances_[b] = elementDistances(scene_, b, recovered_.stress, &v[b].whole());
    });
  last_ = std::move(v);
  return distances_;
}

/// The cells that have to be measured.
std::vector<int> ElementDistances::changed(std::size_t body, const Vector& v) const
{
  const NodeMap& nodes = scene_.bodies[body]->nodes;
  std::vector<int> cells = allCells(*scene_.bodies[body]);
  if (last_[body].empty())
    return cells;
  const auto isSame = [&](int cell) {
    return std::all_of(nodes.cell(cell), nodes.cell(cell) + nodes.nodesPerCell, [&](int node) {
      const auto at = std::ptrdiff_t(node) * nodes.dim;
      return std::equal(v.begin() + at, v.begin() + at + nodes.dim, last_[body].begin() + at);
    });
  };
  cells.erase(std::remove_if(cells.begin(), cells.end(), isSame), cells.end());
  return cells;
}

} // namespace ndframe
