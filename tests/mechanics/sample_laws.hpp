#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ndframe/mechanics/material_law.hpp"

namespace ndframe::test
{

using Entries = std::vector<std::pair<std::string, double>>;

/// A material as a deck with these entries gives it. InputError goes through.
std::unique_ptr<MaterialLaw> material(const std::string& type, const Entries& entries,
                                      const std::string& hypothesis = "Plane Strain");

/// The message of the InputError that the entries are answered with; empty when they are right.
std::string complaint(const std::string& type, const Entries& entries);

Elasticity isotropic(double young, double poisson, const std::string& hypothesis = "Plane Strain");

/// A wood-like material, stiffer along axis 1, by its deck entries. `unit` scales all moduli.
Entries woodEntries(double angle = 0.0, double unit = 1.0);

/// `entries` with one of them replaced.
Entries with(Entries entries, const std::string& key, double value);

/// Wood in space, axis 1 turned by `angle` degrees about z.
SpatialStiffness wood(double angle = 0.0);

/// y = D eps.
std::vector<double> apply(const Elasticity& law, const std::vector<double>& strain);

/// The hypothesis of a body of that dimension (plane strain in two).
inline Hypothesis hypothesisOf(int dim)
{
  return dim == 2 ? Hypothesis::PlaneStrain : Hypothesis::ThreeDimensional;
}

} // namespace ndframe::test
