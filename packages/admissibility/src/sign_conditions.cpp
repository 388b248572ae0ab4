#include "ndframe/admissibility/sign_conditions.hpp"

namespace ndframe
{

DenseMatrix signConditions(int dim, int degree)
{
  const DenseMatrix whole = bernsteinOfMoments(dim, degree);
  if (dim == 3)
    return whole;
  const int size = whole.rows();
  DenseMatrix halves(2 * size, whole.cols());
  for (int j = 0; j < whole.cols(); ++j) {
    Vector means = whole.column(j); // of `left` neighbours, again and again
    for (int left = 0; left < size; ++left) {
      halves(left, j) = means.front();
      halves(2 * size - 1 - left, j) = means.back();
      for (std::size_t i = 0; i + 1 < means.size(); ++i)
        means[i] = 0.5 * (means[i] + means[i + 1]);
      means.pop_back();
    }
  }
  return halves;
}

double largestSign(const ContactTraction& traction, const std::vector<ContactPatch>& patches)
{
  return largestOfMoments(signConditions(traction.dim, traction.degree), traction, patches);
}

} // namespace ndframe
