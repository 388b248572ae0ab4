#include <algorithm>

#include <fmt/format.h>

#include "holds.hpp"
#include "ndframe/driver/model.hpp"
#include "ndframe/interface/body_trace.hpp"

namespace ndframe
{
namespace
{

/// What the interface nodes that carry contact ask of the rigid motions of one body: rows of normal displacements.
DenseMatrix interfaceRows(const Model& model, const InterfaceMesh& interface, int body)
{
  std::vector<const double*> points;
  std::vector<Direction> normals;
  for (int i = 0; i < interface.numNodes(); ++i)
    if (model.carriesContact(interface, i)) {
      points.push_back(interface.point(i));
      normals.push_back(interface.normals[std::size_t(i)]);
    }
  const RigidBasis& basis = model.rigid[std::size_t(body)];
  DenseMatrix all(basis.size(), basis.size());
  for (int m = 0; m < basis.size(); ++m)
    all(m, m) = 1.0;
  return motionTraces(basis, all, points, normals);
}

/// Rows of A below each other in the columns of one body (offset = first column).
void appendRows(DenseMatrix& A, const DenseMatrix& rows, int offset, double sign, int firstRow)
{
  for (int i = 0; i < rows.rows(); ++i)
    for (int j = 0; j < rows.cols(); ++j)
      A(firstRow + i, offset + j) += sign * rows(i, j);
}

void report(const Model& model, const Params& deck, std::size_t body, const DenseMatrix& motions,
            Diagnostics& diagnostics)
{
  if (motions.cols() == 0)
    return;
  const auto names = describeMotions(model.rigid[body], motions);
  diagnostics.add(deck.sub("Bodies")
                      .sub(model.bodies[body].name)
                      .mistake("", fmt::format("nothing holds this body; free rigid motions: {}. Add a support that "
                                               "stops it; where the loads are in equilibrium along it, Hold does.",
                                               fmt::join(names, ", "))));
}

} // namespace

DenseMatrix freeTogether(const Model& model)
{
  int total = 0, rows = 0;
  std::vector<int> offset;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    offset.push_back(total);
    total += model.rigid[b].size();
    for (const auto& entry : model.constraints[b].nodes())
      rows += entry.second.count;
  }
  for (const auto& interface : model.interfaces)
    rows += interface.numNodes();
  DenseMatrix A(rows, total);
  int row = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const auto held = supportRows(model.rigid[b], model.bodies[b].nodes, model.constraints[b]);
    appendRows(A, held, offset[b], 1.0, row);
    row += held.rows();
  }
  for (const auto& interface : model.interfaces) {
    for (const auto& [body, sign] : {std::pair(interface.dirichletBody, 1.0), std::pair(interface.neumannBody, -1.0)})
      appendRows(A, interfaceRows(model, interface, body), offset[std::size_t(body)], sign, row);
    row += interface.numNodes();
  }
  return nullSpace(A, rigidTolerance);
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

void checkHeld(const Model& model, const Params& deck, Diagnostics& diagnostics)
{
  const DenseMatrix motions = freeTogether(model);
  int offset = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const int size = model.rigid[b].size();
    report(model, deck, b, partOf(motions, offset, size), diagnostics);
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
