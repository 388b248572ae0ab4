#include "wrench_balance.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/assembly/rigid_modes.hpp"

namespace ndframe
{
namespace
{

constexpr int wrench = 6;

double largestArm(const Mesh& mesh, const Star& star)
{
  double largest = 0.0;
  const double* a = mesh.point(star.vertex);
  for (const StarCell& cell : star.cells)
    for (const int vertex : cell.sorted.vertices) {
      const double* b = mesh.point(vertex);
      largest = std::max(largest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  return largest;
}

} // namespace

/// What flows through a spoke for potentials p_0, p_1 of its cells (p_1 = 0 at a support):
/// conductance * through through^T (p_0 - p_1), as a wrench about the star's vertex; inside `through` is one.
struct WrenchBalance::Flow
{
  const Spoke* spoke;
  const StressFace* face;
  double conductance;
  DenseMatrix through; ///< 6 x r: reach about the star's vertex; empty inside
};

WrenchBalance::WrenchBalance(int body, const StressFaces& faces)
    : number_(body), body_(&faces.cells().body(body)), faces_(&faces)
{
  const Mesh& mesh = body_->model().mesh;
  const auto cells = std::size_t(mesh.numCells());
  volumes_.reserve(cells);
  centres_.reserve(cells);
  loadArms_.reserve(cells * std::size_t(body_->loadModes()));
  for (int c = 0; c < mesh.numCells(); ++c) {
    volumes_.push_back(cellMeasure(mesh, c));
    Direction centre{};
    for (int v = 0; v < 4; ++v)
      for (std::size_t i = 0; i < 3; ++i)
        centre[i] += 0.25 * mesh.point(mesh.cell(c)[v])[i];
    centres_.push_back(centre);
    const Vector arms = momentArms(body_->cellMeans(), corners(mesh, sortedCell(mesh, c), -1), centre.data(), 3);
    for (std::size_t k = 0; k < std::size_t(body_->loadModes()); ++k)
      loadArms_.push_back({arms[3 * k], arms[3 * k + 1], arms[3 * k + 2]});
  }
}

const StressFace& WrenchBalance::faceOf(int cell, int facet) const
{
  return (*faces_)[faces_->within(faces_->cells().number(number_, cell), facet)];
}

std::vector<WrenchBalance::Flow> WrenchBalance::flows(const Star& star, double size) const
{
  const double* a = body_->model().mesh.point(star.vertex);
  std::vector<Flow> all;
  for (const Spoke& spoke : star.spokes) {
    const StressFace& face = faceOf(star.cells[std::size_t(spoke.cell[0])].cell, spoke.facet[0]);
    double volume = 0.0;
    for (std::size_t side = 0; side < (face.isInside() ? 2 : 1); ++side)
      volume += volumes_[std::size_t(star.cells[std::size_t(spoke.cell[side])].cell)];
    Flow flow{&spoke, &face, std::pow(face.size, 4) / volume / size, {}};
    if (!face.isInside()) {
      flow.through = DenseMatrix(wrench, face.free->reach.cols());
      for (int j = 0; j < face.free->reach.cols(); ++j) {
        Wrench unit{};
        std::copy_n(face.free->reach.col(j), wrench, unit.begin());
        unit = movedWrench(unit, face.centre, face.size, {a[0], a[1], a[2]}, size);
        std::copy_n(unit.begin(), wrench, flow.through.col(j));
      }
    }
    all.push_back(std::move(flow));
  }
  return all;
}

/// The wrench that each cell's loads have and its tractions lack: 6 entries a cell, a column a field.
DenseMatrix WrenchBalance::imbalance(const Star& star, const StarFields& x, double size) const
{
  const double* a = body_->model().mesh.point(star.vertex);
  const int data = body_->reference().data(), facetData = body_->facetData(), loads = body_->loadModes();
  DenseMatrix needed(wrench * int(star.cells.size()), x.cols());
  for (int field = 0; field < x.cols(); ++field)
    for (std::size_t c = 0; c < star.cells.size(); ++c) {
      const StarCell& cell = star.cells[c];
      const double* values = x.col(field) + std::ptrdiff_t(c) * data;
      double* sum = needed.col(field) + std::ptrdiff_t(c) * wrench;
      for (int facet = 0; facet < 4; ++facet)
        if (facet != cell.apex) {
          const Wrench has = faceOf(cell.cell, facet).wrench(values + std::ptrdiff_t(facet) * facetData, a, size);
          for (std::size_t i = 0; i < has.size(); ++i)
            sum[i] -= has[i];
        }
      const double* load = values + body_->reference().tractions;
      const Direction& centre = centres_[std::size_t(cell.cell)];
      for (int i = 0; i < 3; ++i)
        sum[i] += load[i];
      addCross({centre[0] - a[0], centre[1] - a[1], centre[2] - a[2]}, load, 1.0 / size, sum + 3);
      for (int k = 0; k < loads; ++k)
        addCross(loadArms_[std::size_t(cell.cell) * std::size_t(loads) + std::size_t(k)], load + std::ptrdiff_t(3) * k,
                 1.0 / size, sum + 3);
    }
  return needed;
}

/// The motions (of the whole star) that its supports leave free: 6 x their number.
DenseMatrix WrenchBalance::freeMotions(const std::vector<Flow>& flows)
{
  DenseMatrix ground(wrench, wrench);
  for (const Flow& flow : flows)
    for (int k = 0; k < flow.through.cols(); ++k)
      for (int j = 0; j < wrench; ++j)
        for (int i = 0; i < wrench; ++i)
          ground(i, j) += flow.through(i, k) * flow.through(j, k);
  return nullSpace(ground, rigidTolerance);
}

/// What flows out of the cells by their potentials, `components` a cell: one where the six do not depend on each other,
/// as without supports. The free motions are held at the last cell, where nothing is then left to take.
DenseMatrix WrenchBalance::conductances(int cells, const std::vector<Flow>& flows, const DenseMatrix& free,
                                        int components)
{
  DenseMatrix L(cells * components, cells * components);
  const auto add = [&](int row, int col, int i, int j, double value) {
    L(row * components + i, col * components + j) += value;
  };
  const auto addSquare = [&](int cell, const DenseMatrix& columns, double factor) {
    for (int k = 0; k < columns.cols(); ++k)
      for (int j = 0; j < components; ++j)
        for (int i = 0; i < components; ++i)
          add(cell, cell, i, j, factor * columns(i, k) * columns(j, k));
  };
  double largest = 0.0;
  for (const Flow& flow : flows) {
    largest = std::max(largest, flow.conductance);
    const auto& cell = flow.spoke->cell;
    if (!flow.face->isInside())
      addSquare(cell[0], flow.through, flow.conductance);
    for (int i = 0; i < components && flow.face->isInside(); ++i)
      for (std::size_t side = 0; side < 2; ++side) {
        add(cell[side], cell[side], i, i, flow.conductance);
        add(cell[side], cell[1 - side], i, i, -flow.conductance);
      }
  }
  if (components == wrench)
    addSquare(cells - 1, free, largest);
  else
    add(cells - 1, cells - 1, 0, 0, largest);
  return L;
}

DenseMatrix WrenchBalance::potentials(int cells, const std::vector<Flow>& flows, const DenseMatrix& free,
                                      const DenseMatrix& needed)
{
  const int components = free.cols() == wrench ? 1 : wrench, alike = wrench / components;
  const DenseCholesky factor(conductances(cells, flows, free, components));
  DenseMatrix result(needed.rows(), needed.cols());
  for (int field = 0; field < needed.cols(); ++field)
    for (int part = 0; part < alike; ++part) {
      const auto row = [&](int i) { return alike == 1 ? i : i * wrench + part; };
      Vector right;
      for (int i = 0; i < cells * components; ++i)
        right.push_back(needed(row(i), field));
      const Vector p = factor.solve(std::move(right));
      for (int i = 0; i < cells * components; ++i)
        result(row(i), field) = p[std::size_t(i)];
    }
  return result;
}

/// Per field the part of all cells' wrenches together that works on free motions.
Vector WrenchBalance::leftOver(const DenseMatrix& needed, const DenseMatrix& free)
{
  Vector left;
  for (int field = 0; field < needed.cols(); ++field) {
    double square = 0.0;
    for (int k = 0; k < free.cols(); ++k) {
      double sum = 0.0;
      for (int row = 0; row < needed.rows(); ++row)
        sum += needed(row, field) * free(row % wrench, k);
      square += sum * sum;
    }
    left.push_back(std::sqrt(square));
  }
  return left;
}

/// What nothing takes is left to all cells, by their volumes: so it flows on (FlowSettler) as a smooth load.
void WrenchBalance::share(const Star& star, const DenseMatrix& free, DenseMatrix& needed) const
{
  double volume = 0.0;
  for (const StarCell& cell : star.cells)
    volume += volumes_[std::size_t(cell.cell)];
  for (int field = 0; field < needed.cols(); ++field) {
    double* of = needed.col(field);
    Wrench left{};
    for (int k = 0; k < free.cols(); ++k) {
      double sum = 0.0;
      for (int row = 0; row < needed.rows(); ++row)
        sum += of[row] * free(row % wrench, k);
      for (int i = 0; i < wrench; ++i)
        left[std::size_t(i)] += sum * free(i, k);
    }
    for (const StarCell& cell : star.cells)
      for (const double value : left)
        *of++ -= volumes_[std::size_t(cell.cell)] / volume * value;
  }
}

/// What a flow amounts to in terms of its face's carrier.
Vector WrenchBalance::amounts(const Flow& flow, const double* potentials, const Direction& vertex, double size)
{
  const double* first = potentials + std::ptrdiff_t(flow.spoke->cell[0]) * wrench;
  Vector result;
  if (!flow.face->isInside()) {
    for (int k = 0; k < flow.through.cols(); ++k) {
      result.push_back(0.0);
      for (int i = 0; i < wrench; ++i)
        result.back() += flow.conductance * flow.through(i, k) * first[i];
    }
    return result;
  }
  const double* second = potentials + std::ptrdiff_t(flow.spoke->cell[1]) * wrench;
  Wrench carried{};
  for (std::size_t i = 0; i < carried.size(); ++i)
    carried[i] = flow.conductance * (first[i] - second[i]);
  carried = movedWrench(carried, vertex, size, flow.face->centre, flow.face->size);
  return {carried.begin(), carried.end()};
}

Vector WrenchBalance::balance(const Star& star, StarFields& x) const
{
  const Mesh& mesh = body_->model().mesh;
  const int data = body_->reference().data(), facetData = body_->facetData();
  const double size = largestArm(mesh, star);
  Direction vertex{};
  std::copy_n(mesh.point(star.vertex), 3, vertex.begin());
  const auto place = [&](const Spoke& spoke, std::size_t side, int field) {
    return x.col(field) + std::ptrdiff_t(spoke.cell[side]) * data + std::ptrdiff_t(spoke.facet[side]) * facetData;
  };
  for (const Spoke& spoke : star.spokes)
    for (int field = 0; field < x.cols() && !spoke.onBoundary(); ++field)
      for (int i = 0; i < facetData; ++i)
        place(spoke, 0, field)[i] = place(spoke, 1, field)[i] *= 0.5;
  const std::vector<Flow> all = flows(star, size);
  DenseMatrix needed = imbalance(star, x, size);
  const DenseMatrix free = freeMotions(all);
  const Vector left = leftOver(needed, free);
  share(star, free, needed);
  const DenseMatrix p = potentials(int(star.cells.size()), all, free, needed);
  for (const Flow& flow : all)
    for (int field = 0; field < x.cols(); ++field) {
      Vector traction(std::size_t(facetData), 0.0);
      flow.face->addCarried(amounts(flow, p.col(field), vertex, size).data(), traction.data());
      for (std::size_t i = 0; i < traction.size(); ++i) {
        place(*flow.spoke, 0, field)[i] += traction[i];
        if (flow.face->isInside())
          place(*flow.spoke, 1, field)[i] -= traction[i];
      }
    }
  return left;
}

} // namespace ndframe
