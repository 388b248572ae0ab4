#include "pressure_room.hpp"

#include <algorithm>
#include <limits>

#include "ndframe/admissibility/quadratic_program.hpp"
#include "ndframe/algebra/shared_values.hpp"

namespace ndframe
{

namespace
{

constexpr int linear = 3; ///< modes that carry the wrench

/// The change of a facet's moments, quadratic modes only, that brings all coefficients -B T below -least; zero where
/// none does. It is as small as possible.
Vector movedInside(const DenseMatrix& toBernstein, const Vector& moments, double least)
{
  const int modes = toBernstein.cols();
  QuadraticProgram program{DenseMatrix(modes - linear, modes - linear), Vector(std::size_t(modes - linear), 0.0),
                           DenseMatrix(toBernstein.rows(), modes - linear), Vector()};
  const Vector b = multiply(toBernstein, moments);
  for (int j = linear; j < modes; ++j) {
    program.H(j - linear, j - linear) = 1.0;
    for (int i = 0; i < toBernstein.rows(); ++i)
      program.B(i, j - linear) = toBernstein(i, j);
  }
  for (const double value : b)
    program.b.push_back(-least - value);
  Vector change(std::size_t(modes), 0.0);
  if (const auto found = minimise(program))
    std::copy(found->x.begin(), found->x.end(), change.begin() + linear);
  return change;
}

} // namespace

std::vector<FaceTraction> interiorChange(const StressFaces& faces, const std::vector<ContactPatch>& contact,
                                         const ContactTraction& traction)
{
  const DenseMatrix toBernstein = bernsteinOfMoments(3, traction.degree);
  std::vector<FaceTraction> changes;
  if (toBernstein.cols() == linear)
    return changes;
  for (int f = 0; f < faces.size(); ++f) {
    if (faces[f].contact < 0 || !faces.isNear(f))
      continue;
    const Vector moments = traction.moments(faces[f].contact);
    const Vector b = multiply(toBernstein, moments);
    const double largest = *std::max_element(b.begin(), b.end());
    for (const double part : {0.3, 0.1, 0.03}) {
      const double least = -part * moments[0];
      if (-largest >= least || least <= 0.0)
        break;
      const Vector moved = movedInside(toBernstein, moments, least);
      if (dot(moved, moved) == 0.0)
        continue;
      changes.push_back({f, {}});
      for (const double moment : moved)
        for (const double component : contact[std::size_t(faces[f].contact)].normal)
          changes.back().T.push_back(moment * component);
      break;
    }
  }
  return changes;
}

Vector normalMoments(const ContactPatch& patch, const double* T, std::size_t modes)
{
  Vector moments;
  for (std::size_t k = 0; k < modes; ++k)
    moments.push_back(patch.normal[0] * T[3 * k] + patch.normal[1] * T[3 * k + 1] + patch.normal[2] * T[3 * k + 2]);
  return moments;
}

PressureRoom::PressureRoom(const StressFaces& faces, const std::vector<ContactPatch>& contact,
                           const ContactTraction& traction, const Comm& comm)
    : faces_(&faces), contact_(&contact), comm_(comm), toBernstein_(bernsteinOfMoments(3, traction.degree)),
      held_(contact.size(), 0)
{
  constexpr double nothing = 3e-2; // of the largest: less would soon stop steps, which begin anew then
  Vector largest{0.0};
  for (int f = 0; f < faces.size(); ++f) {
    if (faces[f].contact < 0 || !faces.isNear(f))
      continue;
    const auto patch = std::size_t(faces[f].contact);
    Vector room = multiply(toBernstein_, traction.moments(int(patch)));
    for (double& value : room) {
      value = std::max(0.0, -value / contact[patch].measure);
      largest[0] = std::max(largest[0], value);
    }
    inContact_.push_back(f);
    room_.push_back(std::move(room));
  }
  takeLargest(largest, comm_);
  for (std::size_t i = 0; i < room_.size(); ++i)
    if (*std::min_element(room_[i].begin(), room_[i].end()) <= nothing * largest[0])
      held_[std::size_t(faces[inContact_[i]].contact)] = 1;
  agree();
}

/// What one rank holds all hold: edges whose rings reach there stay, too.
void PressureRoom::agree()
{
  if (comm_.size() == 1)
    return;
  Vector flags(held_.begin(), held_.end());
  takeLargest(flags, comm_);
  std::transform(flags.begin(), flags.end(), held_.begin(), [](double flag) { return char(flag > 0.0); });
}

/// What tractions along the normal change the coefficients by.
Vector PressureRoom::coefficients(int face, const double* T) const
{
  const ContactPatch& patch = (*contact_)[std::size_t((*faces_)[face].contact)];
  const auto modes = std::size_t(toBernstein_.cols());
  Vector moments = normalMoments(patch, T, modes);
  for (double& moment : moments)
    moment /= patch.measure;
  return multiply(toBernstein_, moments);
}

double PressureRoom::move(const std::function<void(int face, double* T)>& tractions, double length)
{
  constexpr double soon = 0.5, same = 1.0 + 1e-5; // mirrored facets reach their limits together, but for round-off
  double reached = length;
  std::vector<Vector> changes;
  std::vector<double> allowed(inContact_.size(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < inContact_.size(); ++i) {
    std::array<double, 18> T{}; // facet data at most
    tractions(inContact_[i], T.data());
    changes.push_back(coefficients(inContact_[i], T.data()));
    for (std::size_t k = 0; k < changes[i].size(); ++k)
      if (changes[i][k] * length > room_[i][k])
        allowed[i] = std::min(allowed[i], room_[i][k] / changes[i][k]);
    reached = std::min(reached, allowed[i]);
  }
  Vector least{-reached};
  takeLargest(least, comm_);
  reached = -least.front();
  for (std::size_t i = 0; i < inContact_.size(); ++i) {
    for (std::size_t k = 0; k < changes[i].size(); ++k)
      room_[i][k] = std::max(0.0, room_[i][k] - reached * changes[i][k]);
    if (allowed[i] < std::max(soon * length, same * reached))
      held_[std::size_t((*faces_)[inContact_[i]].contact)] = 1;
  }
  if (reached < length)
    agree();
  return reached;
}

} // namespace ndframe
