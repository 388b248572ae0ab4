#include "ndframe/mesh/piece_name.hpp"

#include <charconv>

#include <fmt/format.h>

namespace ndframe
{
namespace
{

constexpr int mostPieces = 1'000'000;

} // namespace

std::string pieceName(const std::string& path, int pieces, int piece)
{
  return fmt::format("{}.{}.{:0{}}", path, pieces, piece, std::to_string(pieces).size());
}

std::vector<std::string> piecesMeant(const std::string& name)
{
  const auto dot = name.rfind('.');
  int pieces = 0;
  const char* const end = name.data() + name.size();
  if (dot == std::string::npos)
    return {};
  const auto [rest, error] = std::from_chars(name.data() + dot + 1, end, pieces);
  std::vector<std::string> names;
  if (error == std::errc() && rest == end && pieces >= 1 && pieces <= mostPieces)
    for (int piece = 0; piece < pieces; ++piece)
      names.push_back(pieceName(name.substr(0, dot), pieces, piece));
  return names;
}

} // namespace ndframe
