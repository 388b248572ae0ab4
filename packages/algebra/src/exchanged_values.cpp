#include "ndframe/algebra/exchanged_values.hpp"

#include "exchange.hpp"

namespace ndframe
{

std::vector<Vector> exchangedValues(const std::vector<Vector>& values, const Comm& comm)
{
  return exchanged(values, comm);
}

} // namespace ndframe
