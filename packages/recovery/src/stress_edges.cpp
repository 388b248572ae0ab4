#include "stress_edges.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{
namespace
{

/// Vertices of all bodies; those that face each other in contact are one.
class SharedVertices
{
public:
  explicit SharedVertices(const StressFaces& faces) : cells_(&faces.cells())
  {
    for (int body = 0; body < cells_->numBodies(); ++body)
      first_.push_back(first_.back() + (cells_->has(body) ? cells_->body(body).model().mesh.numPoints() : 0));
    same_.resize(std::size_t(first_.back()));
    std::iota(same_.begin(), same_.end(), 0);
    for (const StressFace& face : faces.all())
      if (face.contact >= 0 && !face.isBoundary()) {
        const auto first = vertices(face, 0), second = vertices(face, 1);
        for (std::size_t place = 0; place < second.size(); ++place)
          join(first[std::size_t(face.theirs[place])], second[place]);
      }
  }

  /// Of one side of a face, ascending in its body.
  std::array<int, 3> vertices(const StressFace& face, std::size_t side) const
  {
    const SortedCell cell = cells_->sorted(face.cell[side]);
    const int first = first_[std::size_t(cells_->bodyOf(face.cell[side]))];
    std::array<int, 3> result{};
    for (int i = 0, n = 0; i < 4; ++i)
      if (i != face.facet[side])
        result[std::size_t(n++)] = first + cell.vertices[std::size_t(i)];
    return result;
  }

  int size() const { return first_.back(); }

  int representative(int vertex) const
  {
    while (same_[std::size_t(vertex)] != vertex)
      vertex = same_[std::size_t(vertex)];
    return vertex;
  }

  const double* point(int vertex) const
  {
    const auto body = std::size_t(std::upper_bound(first_.begin(), first_.end(), vertex) - first_.begin()) - 1;
    return cells_->body(int(body)).model().mesh.point(vertex - first_[body]);
  }

private:
  void join(int a, int b)
  {
    a = representative(a);
    b = representative(b);
    same_[std::size_t(std::max(a, b))] = std::min(a, b);
  }

  const StressCells* cells_;
  std::vector<int> first_{0}, same_;
};

/// What a step is to do on a face. basis: 6 x unknowns, the wrenches about the middle.
DenseMatrix throughMatrix(const StressEdge& edge, const DenseMatrix& basis, const StressEdge::Step& step,
                          const StressFace& face)
{
  DenseMatrix given(basis.rows(), basis.cols());
  for (int k = 0; k < given.cols(); ++k)
    for (int i = 0; i < given.rows(); ++i)
      given(i, k) = step.sign * basis(i, k);
  DenseMatrix wrenches = movedWrenches(given, edge.middle, edge.length, face.centre, face.size);
  return face.isInside() ? wrenches : multiply(face.free->choose, wrenches);
}

/// Finds what may circulate around edges.
class Rings
{
public:
  explicit Rings(const StressFaces& faces) : faces_(faces), vertices_(faces) {}

  std::vector<StressEdge> find();

private:
  void add(const std::array<int, 2>& vertices, const std::vector<int>& around);
  void place(StressEdge& edge, const std::array<int, 2>& vertices) const;
  DenseMatrix circulating(const StressEdge& edge) const;

  const StressFaces& faces_;
  SharedVertices vertices_;
  std::vector<StressEdge> edges_;
};

/// Edges by their vertices: which faces meet there.
std::vector<StressEdge> Rings::find()
{
  std::vector<int> ends, faceOf; // per face and edge of it
  ends.reserve(std::size_t(faces_.size()) * 6);
  faceOf.reserve(std::size_t(faces_.size()) * 3);
  for (int f = 0; f < faces_.size(); ++f) {
    if (faces_.isReplaced(f))
      continue;
    auto v = vertices_.vertices(faces_[f], 0);
    for (int& vertex : v)
      vertex = vertices_.representative(vertex);
    ends.insert(ends.end(), {v[0], v[1], v[0], v[2], v[1], v[2]});
    faceOf.insert(faceOf.end(), 3, f);
  }
  const VertexTuples parts(std::move(ends), 2, vertices_.size());
  edges_.reserve(faceOf.size() / 4); // some five faces meet at an edge
  std::vector<int> around;
  for (int place = 0, end = 0; place < parts.size(); place = end) {
    end = parts.groupEnd(place);
    around.clear();
    for (int at = place; at < end; ++at)
      around.push_back(faceOf[std::size_t(parts.at(at))]);
    const int* vertices = parts.tuple(parts.at(place));
    add({vertices[0], vertices[1]}, around);
  }
  return std::move(edges_);
}

void Rings::place(StressEdge& edge, const std::array<int, 2>& vertices) const
{
  const double *a = vertices_.point(vertices[0]), *b = vertices_.point(vertices[1]);
  edge.length = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  for (std::size_t i = 0; i < 3; ++i)
    edge.middle[i] = 0.5 * (a[i] + b[i]);
}

/// Walks from face to face through the cells between them.
void Rings::add(const std::array<int, 2>& vertices, const std::vector<int>& around)
{
  if (std::none_of(around.begin(), around.end(), [&](int f) { return faces_.isNear(f); }))
    return;
  const auto isOpen = [&](int f) { return faces_[f].isBoundary(); };
  const auto open = std::find_if(around.begin(), around.end(), isOpen);
  StressEdge edge;
  edge.ring.reserve(around.size());
  const bool isClosed = open == around.end();
  int face = isClosed ? around.front() : *open, cell = faces_[face].cell[0];
  if (!isClosed) // into the body: a traction on its only cell is the opposite of what leaves a cell before it
    edge.ring.push_back({face, -1, -1.0});
  for (std::size_t step = 0; step < around.size(); ++step) {
    const auto next = std::find_if(around.begin(), around.end(), [&](int f) {
      const auto& cells = faces_[f].cell;
      return f != face && (cells[0] == cell || cells[1] == cell);
    });
    if (next == around.end())
      return;
    face = *next;
    const auto& cells = faces_[face].cell;
    edge.ring.push_back({face, cell, cells[0] == cell ? 1.0 : -1.0});
    cell = cells[0] == cell ? cells[1] : cells[0];
    if (cell < 0 || (isClosed && face == around.front()))
      break;
  }
  if (edge.ring.size() != around.size())
    return;
  place(edge, vertices);
  const DenseMatrix basis = circulating(edge);
  edge.unknowns = basis.cols();
  if (edge.unknowns == 0)
    return;
  for (StressEdge::Step& taken : edge.ring)
    if (edge.unknowns < wrenchSize(3) || !faces_[taken.face].isInside())
      taken.through = std::make_unique<const DenseMatrix>(throughMatrix(edge, basis, taken, faces_[taken.face]));
  edges_.push_back(std::move(edge));
}

/// The wrenches about an edge that all faces of its ring can take.
DenseMatrix Rings::circulating(const StressEdge& edge) const
{
  std::vector<const StressFace*> limited;
  for (const StressEdge::Step& step : edge.ring)
    if (!faces_[step.face].isInside())
      limited.push_back(&faces_[step.face]);
  DenseMatrix all(6, 6), refused(6 * int(limited.size()), 6);
  for (int i = 0; i < 6; ++i)
    all(i, i) = 1.0;
  double largest = 0.0;
  for (std::size_t f = 0; f < limited.size(); ++f) {
    const StressFace& face = *limited[f];
    if (face.free->reach.cols() == 0)
      return {6, 0};
    const DenseMatrix taken = multiply(face.free->reach, face.free->choose),
                      there = movedWrenches(all, edge.middle, edge.length, face.centre, face.size);
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 6; ++i) {
        double& rest = refused(int(f) * 6 + i, j);
        rest = there(i, j);
        for (int k = 0; k < 6; ++k)
          rest -= taken(i, k) * there(k, j);
        largest = std::max(largest, std::abs(rest));
      }
  }
  return largest <= rigidTolerance ? all : nullSpace(refused, rigidTolerance);
}

} // namespace

ThroughMatrix::ThroughMatrix(const StressEdge& edge, const StressEdge::Step& step, const StressFace& face)
{
  if (step.through != nullptr) {
    rows = step.through->rows();
    cols = step.through->cols();
    for (int k = 0; k < cols; ++k)
      std::copy_n(step.through->col(k), rows, values.begin() + std::ptrdiff_t(6) * k);
    return;
  }
  rows = cols = wrenchSize(3);
  for (std::size_t k = 0; k < 6; ++k) {
    Wrench wrench{};
    wrench[k] = step.sign;
    wrench = movedWrench(wrench, edge.middle, edge.length, face.centre, face.size);
    std::copy(wrench.begin(), wrench.end(), values.begin() + std::ptrdiff_t(6) * std::ptrdiff_t(k));
  }
}

DenseMatrix edgeColumns(const StressEdge& edge, const StressEdge::Step& step, const StressFace& face, std::size_t side)
{
  const ThroughMatrix through(edge, step, face);
  const DenseMatrix carrier = face.onSide(side, face.carriers());
  DenseMatrix columns(carrier.rows(), through.cols);
  for (int j = 0; j < columns.cols(); ++j)
    for (int k = 0; k < carrier.cols(); ++k)
      for (int i = 0; i < columns.rows(); ++i)
        columns(i, j) += carrier(i, k) * through(k, j);
  return columns;
}

std::array<DenseMatrix, 4> edgeColumns(const StressEdge& edge, const StressFaces& faces, int cell)
{
  std::array<DenseMatrix, 4> columns;
  for (int facet = 0; facet < 4; ++facet)
    for (const StressEdge::Step& step : edge.ring)
      if (step.face == faces.of(cell, facet))
        columns[std::size_t(facet)] = edgeColumns(edge, step, faces[step.face], faces[step.face].sideOf(cell));
  return columns;
}

std::vector<StressEdge> stressEdges(const StressFaces& faces)
{
  return Rings(faces).find();
}

} // namespace ndframe
