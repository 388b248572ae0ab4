#pragma once

#include "box_polynomial.hpp"
#include "packed_rows.hpp"

namespace ndframe
{

/// Lower triangular: by i and p, the coefficient of the new product p in the old product i along an axis. What a row
/// has beyond its degree is zero.
using SubstitutionMatrix = std::array<std::array<double, mostPacks * packLanes>, BoxPolynomial::highest + 1>;

/// b_pqr = sum a_ijk x_ip y_jq z_kr: other coordinates, or other products of the same degrees. In a plane there is no
/// z. rows: memory that is used again.
void substitute(PlacedPolynomial& polynomial, const std::array<const SubstitutionMatrix*, 3>& xyz,
                std::vector<double>& rows);

} // namespace ndframe
