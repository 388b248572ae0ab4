#pragma once

#include <string>
#include <vector>

#include "certificate/trial.hpp"

namespace ndframe::test
{

/// A scene as a line of CSV, and the columns' names.
std::string titleRow();
std::string row(const Trial& trial);

/// Numbers of scenes, medians and extremes of the effectivities by group, everything that is wrong.
std::string report(const std::vector<Trial>& trials);

bool violated(const std::vector<Trial>& trials);

double median(std::vector<double> values);

} // namespace ndframe::test
