#include <algorithm>

#include <fmt/format.h>

#include "ndframe/algebra/sparse_cholesky.hpp"
#include "ndframe/interface/body_trace.hpp"
#include "ndframe/scene/holds.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{
namespace
{

/// What the interface nodes that carry contact ask of the rigid motions of one body: rows of normal displacements.
DenseMatrix interfaceRows(const Model& model, const InterfaceMesh& interface, ContactRole role)
{
  std::vector<const double*> points;
  std::vector<Direction> normals;
  for (int i = 0; i < interface.numNodes(); ++i)
    if (model.carriesContact(interface, i)) {
      points.push_back(interface.pointOf(role, i));
      normals.push_back(interface.normals[std::size_t(i)]);
    }
  const RigidBasis& basis = model.rigid[std::size_t(interface.side(role).body)];
  DenseMatrix all(basis.size(), basis.size());
  for (int m = 0; m < basis.size(); ++m)
    all(m, m) = 1.0;
  return motionTraces(basis, all, points, normals);
}

/// The equations for the joint rigid motions: rows over the motions of one body, or of the two that touch.
class JointRows
{
public:
  explicit JointRows(int numMotions) : numMotions_(numMotions) {}

  /// Rows of a body whose motions begin at `offset`, from the row `first` on.
  void add(const DenseMatrix& rows, int offset, double sign, int first)
  {
    rows_.resize(std::max(rows_.size(), std::size_t(first) + std::size_t(rows.rows())));
    for (int i = 0; i < rows.rows(); ++i)
      for (int j = 0; j < rows.cols(); ++j)
        rows_[std::size_t(first) + std::size_t(i)].emplace_back(offset + j, sign * rows(i, j));
  }
  int size() const { return int(rows_.size()); }

  /// Whether no motion is left, shown without much work: A^T A has a sparse Cholesky factor. False: perhaps not.
  bool areIndependent() const
  {
    constexpr double seen = 1e-12; // squared; of motions that all are about 1: what turns in a round hole has round-off
    SymmetricEntries gram;
    gram.size = numMotions_;
    Vector squares(std::size_t(numMotions_), 0.0);
    for (int j = 0; j < numMotions_; ++j)
      gram.add(j, j, 0.0);
    for (const auto& row : rows_)
      for (const auto& [i, first] : row)
        for (const auto& [j, second] : row)
          if (i <= j) {
            gram.add(i, j, first * second);
            squares[std::size_t(i)] += i == j ? first * second : 0.0;
          }
    if (*std::min_element(squares.begin(), squares.end()) <= seen * largestEntry(squares))
      return false;
    try {
      const SparseCholesky factor(gram);
      return true;
    } catch (const NotPositiveDefinite&) {
      return false;
    }
  }

  DenseMatrix matrix() const
  {
    DenseMatrix A(size(), numMotions_);
    for (int i = 0; i < size(); ++i)
      for (const auto& [j, value] : rows_[std::size_t(i)])
        A(i, j) += value;
    return A;
  }

private:
  int numMotions_;
  std::vector<std::vector<std::pair<int, double>>> rows_;
};

void report(const Model& model, const SceneSettings& scene, std::size_t body, const DenseMatrix& motions,
            Diagnostics& diagnostics)
{
  if (motions.cols() == 0)
    return;
  const auto names = describeMotions(model.rigid[body], motions);
  diagnostics.add(scene.bodies[body].place.mistake(
      "", fmt::format("nothing holds this body; free rigid motions: {}. Add a support that "
                      "stops it; where the loads are in equilibrium along it, Hold does.",
                      fmt::join(names, ", "))));
}

} // namespace

DenseMatrix freeTogether(const Model& model)
{
  int total = 0;
  std::vector<int> offset;
  for (const RigidBasis& basis : model.rigid) {
    offset.push_back(total);
    total += basis.size();
  }
  JointRows rows(total);
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    rows.add(supportRows(model.rigid[b], model.bodies[b].nodes, model.constraints[b]), offset[b], 1.0, rows.size());
  for (const auto& interface : model.interfaces) {
    if (interface.touchesItself()) // a rigid motion moves both sides alike
      continue;
    const int first = rows.size();
    for (const ContactRole role : bothRoles)
      rows.add(interfaceRows(model, interface, role), offset[std::size_t(interface.side(role).body)], signOf(role),
               first);
  }
  return rows.areIndependent() ? DenseMatrix(total, 0) : nullSpace(rows.matrix(), rigidTolerance);
}

DenseMatrix partOf(const DenseMatrix& motions, int offset, int size)
{
  std::vector<Vector> basis;
  for (int j = 0; j < motions.cols(); ++j) {
    Vector part(motions.col(j) + offset, motions.col(j) + offset + size);
    for (int pass = 0; pass < 2; ++pass)
      for (const auto& known : basis) {
        const double along = dot(known, part);
        for (std::size_t i = 0; i < part.size(); ++i)
          part[i] -= along * known[i];
      }
    const double length = norm(part);
    if (length < 1e-6)
      continue;
    for (double& value : part)
      value /= length;
    basis.push_back(std::move(part));
  }
  DenseMatrix result(size, int(basis.size()));
  for (std::size_t j = 0; j < basis.size(); ++j)
    std::copy(basis[j].begin(), basis[j].end(), result.col(int(j)));
  return result;
}

void checkHeld(const Model& model, const SceneSettings& scene, Diagnostics& diagnostics)
{
  const DenseMatrix motions = freeTogether(model);
  int offset = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const int size = model.rigid[b].size();
    report(model, scene, b, partOf(motions, offset, size), diagnostics);
    offset += size;
  }
}

std::string heldBy(const Model& model, int body)
{
  std::string text;
  const auto& supports = model.bodies[std::size_t(body)].supports;
  for (std::size_t s = 0; s < supports.size(); ++s) {
    const std::string motions = heldMotions(model, body, s);
    text += (text.empty() ? "" : "; ") + supports[s]->description() + (motions.empty() ? "" : ": " + motions);
  }
  const DenseMatrix& free = model.freeMotions[std::size_t(body)];
  if (free.cols() > 0)
    text += fmt::format("{}by contact: {}", text.empty() ? "" : "; ",
                        fmt::join(describeMotions(model.rigid[std::size_t(body)], free), ", "));
  return text;
}

} // namespace ndframe
