#include "wrench_balance.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/equilibrium/self_touching.hpp"

namespace ndframe
{
namespace
{

constexpr int wrench = 6;

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

struct WrenchBalance::Around
{
  int vertex = 0;
  const int *begin = nullptr, *end = nullptr; ///< cells, ascending
  const double* point = nullptr;
  double size = 0.0;           ///< the longest way from the vertex to another
  std::vector<int> apex;       ///< per cell, the sorted number of the vertex
  std::vector<FlowLink> links; ///< wrenches are about the vertex
  std::vector<int> faces;      ///< per link

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
  star.apex.reserve(std::size_t(star.numCells()));
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
  findLinks(star);
  requireConnected(star);
  return star;
}

void WrenchBalance::findLinks(Around& star) const
{
  const int first = faces_->cells().number(number_, 0);
  const auto most = std::size_t(star.numCells()) * 3; // of faces at the vertex
  star.links.reserve(most);
  star.faces.reserve(most);
  for (int c = 0; c < star.numCells(); ++c)
    for (int facet = 0; facet < 4; ++facet) {
      const int cell = star.begin[c], number = faces_->within(first + cell, facet);
      const StressFace& own = face(number);
      if (facet == star.apex[std::size_t(c)] || own.cell[0] != first + cell)
        continue;
      double volume = volumes_[std::size_t(cell)];
      FlowLink link{{c, -1}, 0.0, {}};
      if (own.isInside()) {
        link.cell[1] = star.place(own.cell[1] - first);
        volume += volumes_[std::size_t(own.cell[1] - first)];
      } else if (own.free->reach.cols() > 0) {
        const Direction vertex{star.point[0], star.point[1], star.point[2]};
        link.through = movedWrenches(own.free->reach, own.centre, own.size, vertex, star.size);
      } else
        continue;
      const double area = own.size * own.size;
      link.conductance = area * area / volume / star.size;
      star.links.push_back(std::move(link));
      star.faces.push_back(number);
    }
}

void WrenchBalance::requireConnected(const Around& star) const
{
  std::vector<char> reached(std::size_t(star.numCells()), 0);
  int count = 1;
  reached[0] = 1;
  for (bool isNew = true; isNew && count < star.numCells();) {
    isNew = false;
    for (const FlowLink& link : star.links)
      if (link.cell[1] >= 0 && reached[std::size_t(link.cell[0])] != reached[std::size_t(link.cell[1])]) {
        reached[std::size_t(link.cell[0])] = reached[std::size_t(link.cell[1])] = 1;
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
      const Wrench has = initial.wrenchOf(own, cell, facet, Star::apexOnFacet(apex, facet), star.point, star.size);
      for (int i = 0; i < wrench; ++i)
        needed(i, c) -= has[std::size_t(i)]; // the same on both sides
      if (!own.isInside())
        continue;
      const int other = star.place(own.cell[1] - first);
      for (int i = 0; i < wrench; ++i)
        needed(i, other) -= has[std::size_t(i)];
    }
  }
  return needed;
}

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
Wrench WrenchBalance::amounts(std::size_t number, const DenseMatrix& potentials, const Around& star) const
{
  const FlowLink& link = star.links[number];
  const double* first = potentials.col(link.cell[0]);
  Wrench result{};
  if (link.cell[1] < 0) {
    for (int k = 0; k < link.through.cols(); ++k)
      for (int i = 0; i < wrench; ++i)
        result[std::size_t(k)] += link.conductance * link.through(i, k) * first[i];
    return result;
  }
  const double* second = potentials.col(link.cell[1]);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = link.conductance * (first[i] - second[i]);
  const StressFace& own = face(star.faces[number]);
  return movedWrench(result, {star.point[0], star.point[1], star.point[2]}, star.size, own.centre, own.size);
}

WrenchBalance::Flows WrenchBalance::balance(int vertex) const
{
  const Around star = around(vertex);
  const DenseMatrix free = freeMotions(star.links);
  Flows flows;
  flows.faces = star.faces;
  for (std::size_t field = 0; field < initial_.size(); ++field) {
    flows.force.push_back(0.0);
    DenseMatrix needed = imbalance(star, field, flows.force.back());
    const Vector left = leftOver(needed, free);
    flows.left.push_back(norm(left));
    share(star, left, free, needed);
    const DenseMatrix p = potentials(star.links, free, std::move(needed));
    for (std::size_t link = 0; link < star.links.size(); ++link)
      flows.amounts.push_back(amounts(link, p, star));
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
