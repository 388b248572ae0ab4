#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace ndframe
{

/// Writes a file under a temporary name in the same folder, then renames it: nobody ever sees half a file.
///
/// `write` gets the temporary path and throws on failure; the temporary file is then removed and the error passed on.
/// An unwritable folder or a full disk ends as InputError naming `path` and the system's reason.
/// Returns the number of bytes written.
std::int64_t writeAtomically(const std::string& path, const std::function<void(const std::string& temporaryPath)>& write);

/// The same for a text.
std::int64_t writeTextAtomically(const std::string& path, const std::string& text);

} // namespace ndframe
