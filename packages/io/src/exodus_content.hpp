#pragma once

#include <functional>
#include <string>
#include <vector>

#include "exodus_file.hpp"
#include "exodus_layout.hpp"

namespace ndframe
{

/// Exodus's number of our local facet k, the one opposite to vertex k, from 1.
int exodusSide(int local);

/// Defines everything of a file that has been created, and writes all names and records.
void defineContent(ExodusFile& file, const std::string& title, const ExodusLayout& layout,
                   const ExodusVariables& variables, const std::vector<std::string>& infoLines);

/// A step's time and global values.
void putTime(ExodusFile& file, int number, const ExodusStep& step);

/// Writes a file with what a layout has and these steps. `addRecords` gets the file when all else is defined, before
/// coordinates and values are written: a NetCDF-3 file is moved on disk when its header grows.
void writeContent(const std::string& path, const std::string& title, const ExodusLayout& layout,
                  const std::vector<ExodusStep>& steps, const std::vector<std::string>& infoLines,
                  const std::function<void(ExodusFile&)>& addRecords);

} // namespace ndframe
