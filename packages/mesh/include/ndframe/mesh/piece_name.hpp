#pragma once

#include <string>
#include <vector>

namespace ndframe
{

/// "NAME.e.16.03" for "NAME.e": the name of piece 3 of 16 as ParaView and SEACAS's epu want it, the last number with as
/// many digits as the number of pieces has.
std::string pieceName(const std::string& path, int pieces, int piece);

/// The names of all pieces that "NAME.e.16" stands for; empty where the name does not end in a number from 1 to 1e6.
std::vector<std::string> piecesMeant(const std::string& name);

} // namespace ndframe
