#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// What names a thing on all ranks: e.g. the numbers of its vertices, and a number that is none for those that it does
/// not have.
using CommonKey = std::array<std::int64_t, 4>;

/// Numbers of things that ranks have, some of them several.
struct CommonNumbers
{
  std::vector<std::int64_t> numbers; ///< per thing of this rank, from 0 on in the order of all keys, without holes
  /// The same: the lowest or the highest rank that has it, by turns in four stripes of first entries. So what two ranks
  /// have in common is shared out between them in few pieces.
  std::vector<int> owners;
  std::int64_t count = 0; ///< of different things
};

/// keys: per thing of this rank, all different; their first entries are in [0, bound). Each rank orders those of a
/// block of first entries, so that none has all. Collective.
CommonNumbers commonNumbers(const std::vector<CommonKey>& keys, std::int64_t bound, const Comm& comm);

} // namespace ndframe
