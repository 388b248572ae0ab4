#include <algorithm>

#include <fmt/format.h>

#include "ndframe/driver/model.hpp"
#include "ndframe/interface/body_trace.hpp"

namespace ndframe
{
namespace
{

/// What an interface node asks of the rigid motions of one body: row of normal displacements.
DenseMatrix interfaceRows(const Model& model, const InterfaceMesh& interface, int body)
{
  std::vector<const double*> points;
  for (int i = 0; i < interface.numNodes(); ++i)
    points.push_back(interface.point(i));
  const RigidBasis& basis = model.rigid[std::size_t(body)];
  DenseMatrix all(basis.size(), basis.size());
  for (int m = 0; m < basis.size(); ++m)
    all(m, m) = 1.0;
  return motionTraces(basis, all, points, interface.normals);
}

/// Rows of A below each other in the columns of one body (offset = first column).
void appendRows(DenseMatrix& A, const DenseMatrix& rows, int offset, double sign, int firstRow)
{
  for (int i = 0; i < rows.rows(); ++i)
    for (int j = 0; j < rows.cols(); ++j)
      A(firstRow + i, offset + j) += sign * rows(i, j);
}

/// All rigid motions of the listed bodies that their supports and the jumps on the interfaces between them leave free.
/// `alone`: interfaces hold the Dirichlet body against a fixed partner (the bodies are solved one after the other).
DenseMatrix freeTogether(const Model& model, const std::vector<int>& bodies, bool alone)
{
  int total = 0, rows = 0;
  std::vector<int> offset(model.bodies.size(), -1);
  for (const int b : bodies) {
    offset[std::size_t(b)] = total;
    total += model.rigid[std::size_t(b)].size();
    for (const auto& entry : model.constraints[std::size_t(b)].nodes())
      rows += entry.second.count;
  }
  for (const auto& interface : model.interfaces)
    rows += interface.numNodes();
  DenseMatrix A(rows, total);
  int row = 0;
  for (const int b : bodies) {
    const auto held =
        supportRows(model.rigid[std::size_t(b)], model.bodies[std::size_t(b)].nodes, model.constraints[std::size_t(b)]);
    appendRows(A, held, offset[std::size_t(b)], 1.0, row);
    row += held.rows();
  }
  for (const auto& interface : model.interfaces) {
    const int first = offset[std::size_t(interface.dirichletBody)], second = offset[std::size_t(interface.neumannBody)];
    if (first >= 0)
      appendRows(A, interfaceRows(model, interface, interface.dirichletBody), first, 1.0, row);
    if (second >= 0 && !alone)
      appendRows(A, interfaceRows(model, interface, interface.neumannBody), second, -1.0, row);
    row += interface.numNodes();
  }
  return nullSpace(A, rigidTolerance);
}

/// Part of joint motions that moves one body, reduced to an orthonormal basis.
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

bool touchesAsNeumann(const Model& model, int body)
{
  return std::any_of(model.interfaces.begin(), model.interfaces.end(),
                     [body](const InterfaceMesh& interface) { return interface.neumannBody == body; });
}

void report(const Model& model, const Params& deck, int body, const DenseMatrix& motions, const std::string& advice,
            Diagnostics& diagnostics)
{
  if (motions.cols() == 0)
    return;
  const auto names = describeMotions(model.rigid[std::size_t(body)], motions);
  const auto& name = model.bodies[std::size_t(body)].name;
  diagnostics.add(deck.sub("Bodies").sub(name).mistake(
      "", fmt::format("nothing holds this body; free rigid motions: {}. {}", fmt::join(names, ", "), advice)));
}

} // namespace

void checkHeld(const Model& model, const Params& deck, bool alternates, Diagnostics& diagnostics)
{
  std::vector<int> all;
  for (int b = 0; b < int(model.bodies.size()); ++b)
    all.push_back(b);
  const std::string advice = "Add a support that stops it.";
  if (!alternates) {
    const DenseMatrix motions = freeTogether(model, all, false);
    int offset = 0;
    for (const int b : all) {
      const int size = model.rigid[std::size_t(b)].size();
      report(model, deck, b, partOf(motions, offset, size), advice, diagnostics);
      offset += size;
    }
    return;
  }
  for (const int b : all)
    report(model, deck, b, freeTogether(model, {b}, true),
           touchesAsNeumann(model, b)
               ? "The Neumann body must be held by its supports: make it the Dirichlet body, or add a "
                 "support that stops it."
               : advice,
           diagnostics);
}

std::string heldBy(const Model& model, int body)
{
  std::string text;
  for (const auto& support : model.bodies[std::size_t(body)].supports)
    text += (text.empty() ? "" : "; ") + support->description();
  const DenseMatrix& free = model.freeMotions[std::size_t(body)];
  if (free.cols() > 0)
    text += fmt::format("{}by contact: {}", text.empty() ? "" : "; ",
                        fmt::join(describeMotions(model.rigid[std::size_t(body)], free), ", "));
  return text;
}

} // namespace ndframe
