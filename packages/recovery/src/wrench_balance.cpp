#include "wrench_balance.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/equilibrium/self_touching.hpp"

namespace ndframe
{
namespace
{

constexpr int wrench = 6;

/// L L^T in place in the lower triangle, row by row; the diagonal holds inverses. Columns of `values` become solutions:
/// a wrench a row.
void solveLaplacian(std::vector<double>& L, std::size_t size, double* values)
{
  for (std::size_t i = 0; i < size; ++i) {
    double* row = L.data() + i * size;
    for (std::size_t j = 0; j <= i; ++j) {
      const double* other = L.data() + j * size;
      double sum = row[j];
      for (std::size_t k = 0; k < j; ++k)
        sum -= row[k] * other[k];
      if (j == i && !(sum > 0.0))
        throw NotPositiveDefinite(int(i));
      row[j] = j == i ? 1.0 / std::sqrt(sum) : sum * other[j];
    }
  }
  const auto add = [&](std::size_t to, double factor, std::size_t from) {
    for (std::size_t c = 0; c < wrench; ++c)
      values[to * wrench + c] += factor * values[from * wrench + c];
  };
  const auto scale = [&](std::size_t row) {
    for (std::size_t c = 0; c < wrench; ++c)
      values[row * wrench + c] *= L[row * size + row];
  };
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t k = 0; k < i; ++k)
      add(i, -L[i * size + k], k);
    scale(i);
  }
  for (std::size_t i = size; i-- > 0;) {
    scale(i);
    for (std::size_t k = 0; k < i; ++k)
      add(k, -L[i * size + k], i);
  }
}

} // namespace

/// What flows through a face of a star for potentials p_0, p_1 of its cells (p_1 = 0 at a support):
/// conductance * through through^T (p_0 - p_1), as a wrench about the star's vertex; inside `through` is one.
struct WrenchBalance::Spoke
{
  int face;
  std::array<int, 2> cell; ///< numbers in the star; the second is -1 on the boundary
  double conductance;
  DenseMatrix through; ///< 6 x r: reach about the star's vertex; empty inside
};

struct WrenchBalance::Around
{
  int vertex = 0;
  const int *begin = nullptr, *end = nullptr; ///< cells, ascending
  const double* point = nullptr;
  double size = 0.0;     ///< the longest way from the vertex to another
  std::vector<int> apex; ///< per cell, the sorted number of the vertex
  std::vector<Spoke> spokes;
  bool isHeld = false; ///< by supports

  int numCells() const { return int(end - begin); }
  int place(int cell) const { return int(std::lower_bound(begin, end, cell) - begin); }
};

WrenchBalance::WrenchBalance(int body, const StressFaces& faces, const std::vector<FieldInput>& fields,
                             const BodyCorrections& corrections, int threads)
    : number_(body), body_(&faces.cells().body(body)), faces_(&faces), corrections_(corrections)
{
  const Mesh& mesh = body_->model().mesh;
  volumes_.reserve(std::size_t(mesh.numCells()));
  for (int c = 0; c < mesh.numCells(); ++c)
    volumes_.push_back(cellMeasure(mesh, c));
  for (std::size_t f = 0; f < fields.size(); ++f)
    initial_.emplace_back(body, faces, fields[f], *corrections[f], threads);
  through_.assign(fields.size(), std::vector<Wrench>(std::size_t(faces.size()), Wrench{}));
}

WrenchBalance::Around WrenchBalance::around(int vertex) const
{
  const Mesh& mesh = body_->model().mesh;
  Around star;
  star.vertex = vertex;
  star.begin = body_->around().begin(vertex);
  star.end = body_->around().end(vertex);
  star.point = mesh.point(vertex);
  double largest = 0.0;
  for (const int* cell = star.begin; cell != star.end; ++cell) {
    int apex = 0;
    for (int v = 0; v < 4; ++v) {
      const int other = mesh.cell(*cell)[v];
      apex += int(other < vertex);
      const double* b = mesh.point(other);
      double squares = 0.0;
      for (std::size_t i = 0; i < 3; ++i)
        squares += (b[i] - star.point[i]) * (b[i] - star.point[i]);
      largest = std::max(largest, squares);
    }
    star.apex.push_back(apex);
  }
  star.size = std::sqrt(largest);
  findSpokes(star);
  requireConnected(star);
  return star;
}

void WrenchBalance::findSpokes(Around& star) const
{
  const int first = faces_->cells().number(number_, 0);
  for (int c = 0; c < star.numCells(); ++c)
    for (int facet = 0; facet < 4; ++facet) {
      const int cell = star.begin[c], number = faces_->within(first + cell, facet);
      const StressFace& own = face(number);
      if (facet == star.apex[std::size_t(c)] || own.cell[0] != first + cell)
        continue;
      double volume = volumes_[std::size_t(cell)];
      Spoke spoke{number, {c, -1}, 0.0, {}};
      if (own.isInside()) {
        spoke.cell[1] = star.place(own.cell[1] - first);
        volume += volumes_[std::size_t(own.cell[1] - first)];
      } else if (own.free->reach.cols() > 0) {
        star.isHeld = true;
        spoke.through = DenseMatrix(wrench, own.free->reach.cols());
        for (int j = 0; j < own.free->reach.cols(); ++j) {
          Wrench unit{};
          std::copy_n(own.free->reach.col(j), wrench, unit.begin());
          unit = movedWrench(unit, own.centre, own.size, {star.point[0], star.point[1], star.point[2]}, star.size);
          std::copy_n(unit.begin(), wrench, spoke.through.col(j));
        }
      } else
        continue;
      const double area = own.size * own.size;
      spoke.conductance = area * area / volume / star.size;
      star.spokes.push_back(std::move(spoke));
    }
}

void WrenchBalance::requireConnected(const Around& star) const
{
  std::vector<char> reached(std::size_t(star.numCells()), 0);
  int count = 1;
  reached[0] = 1;
  for (bool isNew = true; isNew && count < star.numCells();) {
    isNew = false;
    for (const Spoke& spoke : star.spokes)
      if (spoke.cell[1] >= 0 && reached[std::size_t(spoke.cell[0])] != reached[std::size_t(spoke.cell[1])]) {
        reached[std::size_t(spoke.cell[0])] = reached[std::size_t(spoke.cell[1])] = 1;
        isNew = true;
        ++count;
      }
  }
  if (count < star.numCells())
    throw SelfTouching(body_->model(), star.vertex);
}

/// The wrench that each cell's loads have and its tractions lack: 6 entries a cell. force: all that there is.
DenseMatrix WrenchBalance::imbalance(const Around& star, std::size_t field, double& force) const
{
  const int first = faces_->cells().number(number_, 0);
  const InitialTractions& initial = initial_[field];
  DenseMatrix needed(wrench, star.numCells());
  for (int c = 0; c < star.numCells(); ++c) {
    const int cell = star.begin[c], apex = star.apex[std::size_t(c)];
    force += initial.force(cell);
    Wrench load{};
    initial.addLoad(cell, apex, star.point, star.size, load);
    for (int i = 0; i < wrench; ++i)
      needed(i, c) += load[std::size_t(i)];
    for (int facet = 0; facet < 4; ++facet) {
      const StressFace& own = face(faces_->within(first + cell, facet));
      if (facet == apex || own.cell[0] != first + cell)
        continue;
      Wrench has{}; // the same on both sides
      initial.addTraction(cell, facet, Star::apexOnFacet(apex, facet), star.point, star.size, has);
      for (int i = 0; i < wrench; ++i)
        needed(i, c) -= has[std::size_t(i)];
      if (!own.isInside())
        continue;
      const int other = star.place(own.cell[1] - first);
      for (int i = 0; i < wrench; ++i)
        needed(i, other) -= has[std::size_t(i)];
    }
  }
  return needed;
}

/// The motions (of the whole star) that its supports leave free: 6 x their number.
DenseMatrix WrenchBalance::freeMotions(const std::vector<Spoke>& spokes)
{
  DenseMatrix ground(wrench, wrench);
  for (const Spoke& spoke : spokes)
    for (int k = 0; k < spoke.through.cols(); ++k)
      for (int j = 0; j < wrench; ++j)
        for (int i = 0; i < wrench; ++i)
          ground(i, j) += spoke.through(i, k) * spoke.through(j, k);
  return nullSpace(ground, rigidTolerance);
}

namespace
{

/// What flows out of the cells by their potentials, `components` a cell: one where the six do not depend on each other,
/// as without supports. The free motions are held at the last cell, where nothing is then left to take.
template <class Spokes>
DenseMatrix conductances(int cells, const Spokes& spokes, const DenseMatrix& free, int components)
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
  for (const auto& spoke : spokes) {
    largest = std::max(largest, spoke.conductance);
    if (spoke.cell[1] < 0)
      addSquare(spoke.cell[0], spoke.through, spoke.conductance);
    for (int i = 0; i < components && spoke.cell[1] >= 0; ++i)
      for (std::size_t side = 0; side < 2; ++side) {
        add(spoke.cell[side], spoke.cell[side], i, i, spoke.conductance);
        add(spoke.cell[side], spoke.cell[1 - side], i, i, -spoke.conductance);
      }
  }
  if (components == wrench)
    addSquare(cells - 1, free, largest);
  else
    add(cells - 1, cells - 1, 0, 0, cells == 1 ? 1.0 : largest);
  return L;
}

/// needed: 6 x cells.
template <class Spokes>
DenseMatrix potentials(const Spokes& spokes, const DenseMatrix& free, DenseMatrix needed)
{
  const int cells = needed.cols();
  if (free.cols() == wrench) {
    const DenseMatrix L = conductances(cells, spokes, free, 1);
    std::vector<double> values(L.data(), L.data() + std::ptrdiff_t(cells) * cells);
    solveLaplacian(values, std::size_t(cells), needed.data());
    return needed;
  }
  Vector all(needed.data(), needed.data() + std::ptrdiff_t(cells) * wrench);
  all = DenseCholesky(conductances(cells, spokes, free, wrench)).solve(std::move(all));
  std::copy(all.begin(), all.end(), needed.data());
  return needed;
}

DenseMatrix allMotions()
{
  DenseMatrix all(wrench, wrench);
  for (int i = 0; i < wrench; ++i)
    all(i, i) = 1.0;
  return all;
}

/// The part of all cells' wrenches together that works on free motions: by these.
Vector leftOver(const DenseMatrix& needed, const DenseMatrix& free)
{
  Wrench total{};
  for (int c = 0; c < needed.cols(); ++c)
    for (std::size_t i = 0; i < total.size(); ++i)
      total[i] += needed(int(i), c);
  Vector left(std::size_t(free.cols()), 0.0);
  for (int k = 0; k < free.cols(); ++k)
    for (std::size_t i = 0; i < total.size(); ++i)
      left[std::size_t(k)] += total[i] * free(int(i), k);
  return left;
}

} // namespace

/// What nothing takes is left to all cells, by their volumes: so it flows on (FlowSettler) as a smooth load.
void WrenchBalance::share(const Around& star, const Vector& left, const DenseMatrix& free, DenseMatrix& needed) const
{
  double volume = 0.0;
  for (const int* cell = star.begin; cell != star.end; ++cell)
    volume += volumes_[std::size_t(*cell)];
  const Vector all = multiply(free, left);
  for (int c = 0; c < needed.cols(); ++c)
    for (int i = 0; i < wrench; ++i)
      needed(i, c) -= volumes_[std::size_t(star.begin[c])] / volume * all[std::size_t(i)];
}

/// What a flow amounts to in terms of its face's carrier.
Wrench WrenchBalance::amounts(const Spoke& spoke, const DenseMatrix& potentials, const Around& star) const
{
  const double* first = potentials.col(spoke.cell[0]);
  Wrench result{};
  if (spoke.cell[1] < 0) {
    for (int k = 0; k < spoke.through.cols(); ++k)
      for (int i = 0; i < wrench; ++i)
        result[std::size_t(k)] += spoke.conductance * spoke.through(i, k) * first[i];
    return result;
  }
  const double* second = potentials.col(spoke.cell[1]);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = spoke.conductance * (first[i] - second[i]);
  const StressFace& own = face(spoke.face);
  return movedWrench(result, {star.point[0], star.point[1], star.point[2]}, star.size, own.centre, own.size);
}

WrenchBalance::Flows WrenchBalance::balance(int vertex) const
{
  const Around star = around(vertex);
  const DenseMatrix free = star.isHeld ? freeMotions(star.spokes) : allMotions();
  Flows flows;
  for (const Spoke& spoke : star.spokes)
    flows.faces.push_back(spoke.face);
  for (std::size_t field = 0; field < initial_.size(); ++field) {
    flows.force.push_back(0.0);
    DenseMatrix needed = imbalance(star, field, flows.force.back());
    const Vector left = leftOver(needed, free);
    flows.left.push_back(norm(left));
    share(star, left, free, needed);
    const DenseMatrix p = potentials(star.spokes, free, std::move(needed));
    for (const Spoke& spoke : star.spokes)
      flows.amounts.push_back(amounts(spoke, p, star));
  }
  return flows;
}

void WrenchBalance::add(const Flows& star)
{
  const Wrench* amount = star.amounts.data();
  for (std::size_t field = 0; field < through_.size(); ++field) {
    for (const int number : star.faces) {
      Wrench& sum = through_[field][std::size_t(number)];
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += (*amount)[i];
      ++amount;
    }
    corrections_[field]->imbalance = std::max(corrections_[field]->imbalance, star.left[field]);
    corrections_[field]->force = std::max(corrections_[field]->force, star.force[field]);
  }
}

void WrenchBalance::finish()
{
  const int first = faces_->cells().number(number_, 0), size = body_->facetData();
  std::array<double, 18> T{};
  for (int number = 0; number < faces_->size(); ++number) {
    const StressFace& own = face(number);
    if (own.contact >= 0 || faces_->cells().bodyOf(own.cell[0]) != number_ || own.numCarriers() == 0)
      continue;
    for (std::size_t field = 0; field < through_.size(); ++field) {
      T.fill(0.0);
      own.addCarried(through_[field][std::size_t(number)].data(), T.data());
      for (std::size_t side = 0; side < (own.isInside() ? 2 : 1); ++side) {
        double* sum = corrections_[field]->tractions.data() +
                      (std::ptrdiff_t(own.cell[side] - first) * 4 + own.facet[side]) * size;
        for (int i = 0; i < size; ++i)
          sum[i] += side == 0 ? T[std::size_t(i)] : -T[std::size_t(i)];
      }
    }
  }
}

} // namespace ndframe
