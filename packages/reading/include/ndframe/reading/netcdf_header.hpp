#pragma once

#include <string>

namespace ndframe
{

/// Checks that a file is netCDF and, in the classic formats (CDF-1, 2, 5), that its header makes sense and its data are
/// all there. The netCDF library itself reads the missing end of a cut-off file as zeros, and the Exodus library
/// trusts the shapes of its lists of numbers. HDF5 files carry their
/// length, which their library checks. Throws FileError.
void checkNetcdfHeader(const std::string& path);

} // namespace ndframe
