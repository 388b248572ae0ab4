#pragma once

#include "ndframe/accuracy/checkpoint.hpp"
#include "ndframe/accuracy/level_errors.hpp"

namespace ndframe
{

/// What the certificate of a level teaches: contributions of the cells as they were refined, before sides were cut to
/// match, and where contact ends; all of it on every rank. Collective.
LevelLesson lessonOf(const Run& run, const LevelErrors& errors, const Comm& comm);

} // namespace ndframe
