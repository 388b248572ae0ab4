#pragma once

#include <string>
#include <vector>

#include "ndframe/run/run.hpp"

namespace ndframe
{

/// NAME.contact.csv: a header line with the column names, then one line per node sorted as given, 17 significant
/// digits, `closed` as 0 or 1. 2-D files have no z column, 3-D files no arc_length. interfaces: their names.
std::string contactCsv(const std::vector<ContactNode>& nodes, const std::vector<std::string>& interfaces, int dim);

/// The table of a run's final state.
std::string contactCsv(const Run& run);

} // namespace ndframe
