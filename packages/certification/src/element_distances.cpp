#include "element_distances.hpp"

#include <algorithm>
#include <numeric>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/simd/cell_distances.hpp"

namespace ndframe
{
namespace
{

/// Cells that a thread measures before it takes the next ones.
constexpr std::int64_t group = 256;

std::vector<int> allCells(const BodyModel& body)
{
  std::vector<int> cells(std::size_t(body.mesh.numCells()));
  std::iota(cells.begin(), cells.end(), 0);
  return cells;
}

} // namespace

CellValues elementDistances(const CertifiedScene& scene, std::size_t body, const StressCorrection& correction,
                            const Vector& v, const std::vector<int>* cells)
{
  if (scene.dim() == 2)
    return ofCells(cellDistances(*scene.bodies[body], correction, &v));
  const std::vector<int> all = cells == nullptr ? allCells(*scene.bodies[body]) : *cells;
  const auto share = [&](int rank) { return std::int64_t(all.size()) * rank / scene.comm.size(); };
  const std::int64_t begin = share(scene.comm.rank()), end = share(scene.comm.rank() + 1);
  Vector found(all.size(), 0.0);
  runInRanges(int((end - begin + group - 1) / group), numThreads(scene.comm), [&](int first, int last) {
    const std::int64_t from = begin + first * group, to = std::min(begin + last * group, end);
    const Vector distances =
        solidDistances(*scene.bodies[body], correction, &v, std::vector<int>(all.begin() + from, all.begin() + to));
    std::copy(distances.begin(), distances.end(), found.begin() + from);
  });
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
    const CellValues found = elementDistances(scene_, b, recovered_.stress.corrections[b], v[b], &cells);
    for (std::size_t c = 0; c < cells.size(); ++c)
      distances_[b][std::size_t(cells[c])] = found[c];
  }
  if (scene_.dim() == 2)
    runLargestFirst(scene_.model.numDofs(), scene_.condensed.threads, [&](int body) {
      const auto b = std::size_t(body);
      if (!scene_.bodies[b]->isRigid && !(v[b] == last_[b]))
        distances_[b] = elementDistances(scene_, b, recovered_.stress.corrections[b], v[b]);
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
