#pragma once

namespace ndframe
{

/// Prepares the process for a rough world; to be called before anything starts threads. SIGINT, SIGTERM and SIGHUP
/// still end it, with the usual status (128 + signal), but unfinished files are removed before. A full disk and a
/// reader that has gone away are errors of the write. A standard stream that was closed becomes /dev/null: a result
/// must not get its number.
void prepareProcess();

/// Why what was written to the standard output did not get there; null when it did, or when its reader went away on
/// purpose (`ndframe ... | head`).
const char* lostOutput();

} // namespace ndframe
