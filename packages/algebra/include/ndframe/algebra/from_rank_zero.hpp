#pragma once

#include <functional>
#include <string>

#include "ndframe/algebra/comm.hpp"

namespace ndframe
{

/// The bytes (some) that `make` returns on rank 0, on every rank; called there only. An InputError that it throws is
/// one on every rank. Collective. Limit: 2 GB.
std::string fromRankZero(const Comm& comm, const std::function<std::string()>& make);

/// The bytes that `make(rank)` returns on rank 0, on that rank; called there only, for one rank after the other, so
/// that rank 0 has those of one at a time, its own last. What it throws, others do not know of. Collective. Any length.
std::string handedOut(const Comm& comm, const std::function<std::string(int rank)>& make);

/// Calls `work` on every rank. An InputError of any is one on every rank: that of the lowest that has one. Collective.
void onEveryRank(const Comm& comm, const std::function<void()>& work);

} // namespace ndframe
