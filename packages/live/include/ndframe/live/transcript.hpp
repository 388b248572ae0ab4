#pragma once

#include <string>

namespace ndframe
{

// The file of --log: what this process prints, in the order in which it does, and a line "# 19:51:16  +1.234 s  factor"
// where a stage begins. Without a file the functions do nothing. Any thread may call them.

/// Begins the file; an earlier one of this name is lost. `title`: its first line. Why it cannot be written; empty when
/// it can.
std::string openTranscript(const std::string& file, const std::string& title);
/// One line or several, without the last newline.
void transcribe(const std::string& text);
/// A line "# TIME STAGE".
void transcribeStage(const std::string& stage);
/// Ends the file; nothing is transcribed any more. Why it is not complete (a full disk); empty when it is.
std::string closeTranscript();

} // namespace ndframe
