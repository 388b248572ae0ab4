#include "stress_faces.hpp"

#include <algorithm>
#include <cmath>

#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/mesh/vertex_tuples.hpp"

namespace ndframe
{
namespace
{

Direction difference(const Direction& a, const Direction& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

void addCross(const Direction& arm, const double* force, double factor, double* moment)
{
  moment[0] += factor * (arm[1] * force[2] - arm[2] * force[1]);
  moment[1] += factor * (arm[2] * force[0] - arm[0] * force[2]);
  moment[2] += factor * (arm[0] * force[1] - arm[1] * force[0]);
}

DenseMatrix transposed(const DenseMatrix& matrix)
{
  DenseMatrix result(matrix.cols(), matrix.rows());
  for (int j = 0; j < matrix.cols(); ++j)
    for (int i = 0; i < matrix.rows(); ++i)
      result(j, i) = matrix(i, j);
  return result;
}

} // namespace

Wrench StressFace::wrench(const double* T, const double* point, double length) const
{
  Wrench result{T[0], T[1], T[2], 0.0, 0.0, 0.0};
  addCross({centre[0] - point[0], centre[1] - point[1], centre[2] - point[2]}, T, 1.0 / length, &result[3]);
  for (std::size_t k = 0; k < 2; ++k)
    addCross(arms[k], T + 3 * (k + 1), 1.0 / length, &result[3]);
  return result;
}

Wrench movedWrench(const Wrench& wrench, const Direction& from, double fromLength, const Direction& to, double toLength)
{
  Wrench result = wrench;
  for (std::size_t i = 3; i < 6; ++i)
    result[i] *= fromLength / toLength;
  addCross(difference(from, to), wrench.data(), 1.0 / toLength, &result[3]);
  return result;
}

StressFaces::StressFaces(const StarBody& body)
    : body_(&body), faceOf_(std::size_t(body.model().mesh.numCells()) * 4, -1)
{
  NDFRAME_ASSERT(body.dim() == 3, "faces of solids");
  addFaces();
  addEdges();
}

void StressFaces::addFaces()
{
  const Mesh& mesh = body_->model().mesh;
  const VertexTuples facets = allFacets(mesh, mesh.numPoints());
  for (int place = 0, end = 0; place < facets.size(); place = end) {
    end = facets.groupEnd(place);
    NDFRAME_ASSERT(end - place <= 2, "a facet of a sound mesh has one or two cells");
    StressFace face;
    for (int p = place; p < end; ++p) {
      const Facet facet{facets.at(p) / 4, facets.at(p) % 4};
      const auto side = std::size_t(p - place);
      face.cell[side] = facet.cell;
      face.facet[side] = sortedFacet(mesh, facet);
      faceOf_[std::size_t(facet.cell) * 4 + std::size_t(face.facet[side])] = int(faces_.size());
    }
    const Vector arms = findGeometry(face);
    if (face.isInside())
      freeTractions(face, arms);
    else
      freeReactions(face, arms);
    faces_.push_back(std::move(face));
  }
}

/// Centre, size and arms; returns the arms of all modes.
Vector StressFaces::findGeometry(StressFace& face) const
{
  const Mesh& mesh = body_->model().mesh;
  const auto vertices = corners(mesh, sortedCell(mesh, face.cell[0]), face.facet[0]);
  Direction e{}, f{};
  for (std::size_t i = 0; i < 3; ++i) {
    face.centre[i] = (vertices[0][i] + vertices[1][i] + vertices[2][i]) / 3.0;
    e[i] = vertices[1][i] - vertices[0][i];
    f[i] = vertices[2][i] - vertices[0][i];
  }
  double normal[3] = {};
  addCross(e, f.data(), 0.5, normal);
  face.size = std::sqrt(std::hypot(normal[0], normal[1], normal[2]));
  Vector arms = momentArms(body_->facetMeans(), vertices, face.centre.data(), 3);
  for (std::size_t k = 0; k < 2; ++k)
    std::copy_n(arms.data() + 3 * (k + 1), 3, face.arms[k].begin());
  return arms;
}

void StressFaces::freeTractions(StressFace& face, const Vector& arms) const
{
  FacetSplit split = splitFacet(3, arms, body_->facetModes(), face.size);
  face.own = std::move(split.modes);
  face.carrier = std::move(split.carrier);
  face.reach = DenseMatrix(6, 6);
  for (int i = 0; i < 6; ++i)
    face.reach(i, i) = 1.0;
  face.choose = face.reach;
}

void StressFaces::freeReactions(StressFace& face, const Vector& arms) const
{
  const int boundary = body_->boundaryIndex(face.cell[0], face.facet[0]), modes = body_->facetModes();
  const int directions = boundary < 0 ? 0 : body_->data().boundary[std::size_t(boundary)].supported;
  if (directions == 0) {
    face.own = face.carrier = DenseMatrix(body_->facetData(), 0);
    face.reach = DenseMatrix(6, 0);
    face.choose = DenseMatrix(0, 6);
    return;
  }
  const auto& along = body_->data().boundary[std::size_t(boundary)].directions;
  DenseMatrix reactions(body_->facetData(), directions * modes);
  for (int mode = 0, column = 0; mode < modes; ++mode)
    for (int d = 0; d < directions; ++d, ++column)
      std::copy_n(along[std::size_t(d)].begin(), 3, reactions.col(column) + std::ptrdiff_t(3) * mode);
  const DenseMatrix wrenches = multiply(wrenchMap(3, arms, modes, face.size), reactions);
  const DenseMatrix idle = nullSpace(wrenches, rigidTolerance), busy = nullSpace(transposed(idle), rigidTolerance);
  face.own = multiply(reactions, idle);
  face.carrier = multiply(reactions, busy);
  face.reach = multiply(wrenches, busy);
  face.choose = pseudoInverse(face.reach, rigidTolerance);
}

/// Edges by their vertices: which faces meet there.
void StressFaces::addEdges()
{
  const Mesh& mesh = body_->model().mesh;
  struct Part
  {
    std::array<int, 2> vertices;
    int face;
  };
  std::vector<Part> parts;
  for (int f = 0; f < int(faces_.size()); ++f) {
    const StressFace& face = faces_[std::size_t(f)];
    const SortedCell cell = sortedCell(mesh, face.cell[0]);
    std::array<int, 3> v{};
    for (int i = 0, n = 0; i < 4; ++i)
      if (i != face.facet[0])
        v[std::size_t(n++)] = cell.vertices[std::size_t(i)];
    for (const auto& ends : {std::array{v[0], v[1]}, std::array{v[0], v[2]}, std::array{v[1], v[2]}})
      parts.push_back({ends, f});
  }
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.vertices < b.vertices; });
  for (std::size_t first = 0, last = 0; first < parts.size(); first = last) {
    std::vector<int> around;
    for (last = first; last < parts.size() && parts[last].vertices == parts[first].vertices; ++last)
      around.push_back(parts[last].face);
    addRing(parts[first].vertices, around);
  }
}

/// Walks from face to face through the cells between them. Edges at which a body touches itself are left out.
void StressFaces::addRing(const std::array<int, 2>& vertices, const std::vector<int>& around)
{
  const Mesh& mesh = body_->model().mesh;
  const auto isOpen = [&](int f) { return !faces_[std::size_t(f)].isInside(); };
  const auto open = std::find_if(around.begin(), around.end(), isOpen);
  StressEdge edge;
  edge.isClosed = open == around.end();
  int face = edge.isClosed ? around.front() : *open, cell = faces_[std::size_t(face)].cell[0];
  if (!edge.isClosed) // into the body: a traction on its only cell is the opposite of what leaves a cell before it
    edge.ring.push_back({face, -1.0, -1});
  for (std::size_t step = 0; step < around.size(); ++step) {
    const auto next = std::find_if(around.begin(), around.end(), [&](int f) {
      const auto& cells = faces_[std::size_t(f)].cell;
      return f != face && (cells[0] == cell || cells[1] == cell);
    });
    if (next == around.end())
      return;
    face = *next;
    const auto& cells = faces_[std::size_t(face)].cell;
    edge.ring.push_back({face, cells[0] == cell ? 1.0 : -1.0, cell});
    cell = cells[0] == cell ? cells[1] : cells[0];
    if (cell < 0 || (edge.isClosed && face == around.front()))
      break;
  }
  if (edge.ring.size() != around.size())
    return;
  const double *a = mesh.point(vertices[0]), *b = mesh.point(vertices[1]);
  edge.length = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  for (std::size_t i = 0; i < 3; ++i)
    edge.middle[i] = 0.5 * (a[i] + b[i]);
  edge.basis = circulating(edge);
  if (edge.basis.cols() == 0)
    return;
  for (StressEdge::Step& taken : edge.ring)
    taken.through = through(edge, taken);
  edges_.push_back(std::move(edge));
}

DenseMatrix StressFaces::through(const StressEdge& edge, const StressEdge::Step& step) const
{
  const StressFace& face = faces_[std::size_t(step.face)];
  DenseMatrix wrenches(6, edge.basis.cols());
  for (int k = 0; k < wrenches.cols(); ++k) {
    Wrench wrench{};
    for (std::size_t i = 0; i < wrench.size(); ++i)
      wrench[i] = step.sign * edge.basis(int(i), k);
    wrench = movedWrench(wrench, edge.middle, edge.length, face.centre, face.size);
    std::copy(wrench.begin(), wrench.end(), wrenches.col(k));
  }
  return face.isInside() ? wrenches : multiply(face.choose, wrenches);
}

/// The wrenches about an edge that the faces at both ends of its ring can take.
DenseMatrix StressFaces::circulating(const StressEdge& edge) const
{
  DenseMatrix all(6, 6);
  for (int i = 0; i < 6; ++i)
    all(i, i) = 1.0;
  if (edge.isClosed)
    return all;
  DenseMatrix refused(12, 6);
  for (int end = 0; end < 2; ++end) {
    const StressFace& face = faces_[std::size_t(end == 0 ? edge.ring.front().face : edge.ring.back().face)];
    if (face.reach.cols() == 0)
      return {6, 0};
    const DenseMatrix taken = multiply(face.reach, face.choose);
    for (int j = 0; j < 6; ++j) {
      Wrench unit{};
      unit[std::size_t(j)] = 1.0;
      const Wrench there = movedWrench(unit, edge.middle, edge.length, face.centre, face.size);
      for (int i = 0; i < 6; ++i) {
        refused(end * 6 + i, j) = there[std::size_t(i)];
        for (int k = 0; k < 6; ++k)
          refused(end * 6 + i, j) -= taken(i, k) * there[std::size_t(k)];
      }
    }
  }
  double largest = 0.0;
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 12; ++i)
      largest = std::max(largest, std::abs(refused(i, j)));
  return largest <= rigidTolerance ? all : nullSpace(refused, rigidTolerance);
}

} // namespace ndframe
