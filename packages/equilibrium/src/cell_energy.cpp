#include "ndframe/equilibrium/cell_energy.hpp"

#include "ndframe/equilibrium/cell_form.hpp"

namespace ndframe
{

DenseMatrix cellEnergyMatrix(const ReferenceStress& reference, const CellMap& map, const Elasticity& law)
{
  const DenseMatrix local = CellForm(reference, map, law).condensed();
  const int dim = map.dim, n = local.rows();
  const auto inverse = [&map, dim](int i, int k) {
    return map.inverse[std::size_t(i) * std::size_t(dim) + std::size_t(k)];
  };
  DenseMatrix half(n, n), A(n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < dim; ++k)
        half(i, j) += local(i, j / dim * dim + k) * inverse(k, j % dim);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      for (int k = 0; k < dim; ++k)
        A(i, j) += inverse(k, i % dim) * half(i / dim * dim + k, j);
  return A;
}

} // namespace ndframe
