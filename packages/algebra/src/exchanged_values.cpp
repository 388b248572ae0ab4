#include "ndframe/algebra/exchanged_values.hpp"

#include "exchange.hpp"

namespace ndframe
{

std::vector<Vector> exchangedValues(const std::vector<Vector>& values, const Comm& comm)
{
  return exchanged(values, comm);
}

std::vector<std::string> exchangedBytes(const std::vector<std::string>& bytes, const Comm& comm)
{
  std::vector<std::vector<char>> pieces;
  for (const std::string& piece : bytes)
    pieces.emplace_back(piece.begin(), piece.end());
  std::vector<std::string> result;
  for (const std::vector<char>& piece : exchanged(pieces, comm))
    result.emplace_back(piece.begin(), piece.end());
  return result;
}

} // namespace ndframe
