#pragma once

#include <vector>

namespace ndframe
{

/// A polynomial in t from -1 to 1 by its coefficients, the constant first.
using LinePolynomial = std::vector<double>;

double valueAt(const LinePolynomial& p, double t);

/// The one of degree n through values at the points cos(pi j / n), by Chebyshev polynomials.
LinePolynomial through(const std::vector<double>& values);

/// A lower bound of its values: the least Bernstein coefficient.
double leastCoefficient(const LinePolynomial& p);

LinePolynomial differenceOf(LinePolynomial a, const LinePolynomial& b);

} // namespace ndframe
