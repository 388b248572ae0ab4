#pragma once

#include "ndframe/io/exodus_writer.hpp"
#include "ndframe/run/run.hpp"

namespace ndframe
{

/// What the certificate adds to the elements of a body: eta_glob, eta_dis, eta_nda (the square roots of an element's
/// contributions, so that their squares add up), and the stresses that Output asks for. `isFinal`: the certificate is
/// of the final state; other steps of the file get NaN.
std::vector<NamedField> elementErrorFields(const Run& run, const OutputOptions& output, std::size_t body, bool isFinal);

/// Mean admissible pressure of the facets of interface number `interface`; none without an admissible traction.
std::vector<NamedField> admissiblePressure(const Run& run, std::size_t interface, bool isFinal);

} // namespace ndframe
