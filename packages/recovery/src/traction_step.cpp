#include "traction_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ndframe/admissibility/quadratic_program.hpp"
#include "ndframe/admissibility/sign_conditions.hpp"
#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

/// A row that a basis turns into less than this is annulled by it.
constexpr double annulled = 1e-12;
/// What may be left of a coefficient that should not be positive, relative to the tractions that play a part.
constexpr double roundOff = 1e-11;

/// The dt in balance: orthonormal columns. Rows of E below rigidTolerance are those that supports or the direction of
/// the interface have emptied.
DenseMatrix balanced(const DenseMatrix& E)
{
  DenseMatrix rows(E.rows(), E.cols());
  for (int i = 0; i < E.rows(); ++i) {
    double largest = 0.0;
    for (int j = 0; j < E.cols(); ++j)
      largest = std::max(largest, std::abs(E(i, j)));
    for (int j = 0; j < E.cols() && largest > rigidTolerance; ++j)
      rows(i, j) = E(i, j);
  }
  return nullSpace(rows, rigidTolerance);
}

} // namespace

TractionStep::TractionStep(std::vector<PatchEnd> ends, const DenseMatrix& E, DenseMatrix H, Vector h)
    : ends_(std::move(ends)), H_(std::move(H)), basis_(balanced(E)), h_(std::move(h))
{
  NDFRAME_ASSERT(H_.rows() == int(h_.size()) && E.cols() == H_.rows(), "shapes do not match");
  reducedH_ = multiplyTransposed(basis_, multiply(H_, basis_));
  const int modes = H_.rows() / int(ends_.size());
  conditions_ = signConditions(2, modes - 1);
  const int conditions = conditions_.rows(); // of a patch
  reducedB_ = DenseMatrix(int(ends_.size()) * conditions, basis_.cols());
  for (int i = 0; i < reducedB_.rows(); ++i)
    for (int z = 0; z < basis_.cols(); ++z) {
      double value = 0.0;
      for (int k = 0; k < modes; ++k)
        value += conditions_(i % conditions, k) * basis_(i / conditions * modes + k, z);
      reducedB_(i, z) = std::abs(value) > annulled ? value : 0.0;
    }
}

Vector TractionStep::coefficients(const ContactTraction& traction) const
{
  Vector all;
  for (const PatchEnd& end : ends_) {
    const Vector values = multiply(conditions_, traction.moments(end.patch));
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

Vector TractionStep::apply(ContactTraction& traction)
{
  const Vector before = coefficients(traction);
  QuadraticProgram program{reducedH_, multiplyTransposed(basis_, DenseMatrix(h_)).column(0), reducedB_, before};
  for (double& value : program.b) // positive coefficients are round-off: no change must stay possible
    value = std::max(-value, 0.0);
  const auto minimum = minimise(program);
  if (!minimum) // conditions that round-off lets contradict each other; no change is always possible
    return Vector(h_.size(), 0.0);
  Vector change = multiply(basis_, minimum->x);
  const Vector force = multiply(H_, change);
  double scale = norm(before); // and the change that the stars would like
  for (std::size_t i = 0; i < h_.size(); ++i)
    scale = std::max(scale, std::abs(h_[i]) / H_(int(i), int(i)));
  if (0.5 * dot(force, change) + dot(h_, change) >= 0.0)
    return Vector(change.size(), 0.0);
  const std::size_t modes = change.size() / ends_.size();
  for (std::size_t i = 0; i < change.size(); ++i) {
    const PatchEnd& end = ends_[i / modes];
    traction.shares[traction.first(std::size_t(end.patch), std::size_t(end.vertex)) + i % modes] += change[i];
    h_[i] += force[i];
  }
  const Vector after = coefficients(traction);
  NDFRAME_ASSERT(*std::max_element(after.begin(), after.end()) <= roundOff * scale, "the traction stays admissible");
  return change;
}

} // namespace ndframe
