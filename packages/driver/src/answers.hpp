#pragma once

#include <iosfwd>

#include "command_line.hpp"
#include "ndframe/algebra/comm.hpp"
#include "ndframe/driver/components.hpp"

namespace ndframe
{

/// Answers the questions that need no deck (--help, --list, ...); true when one was asked.
bool answer(const CommandLine& options, const CLI::App& app, const Components& components, const Comm& comm,
            std::ostream& out);

} // namespace ndframe
