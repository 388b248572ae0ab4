#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ndframe::test
{

/// A reader to be tried: the files it should read, and how it is called. `read` throws InputError for a file that it
/// refuses.
struct Target
{
  bool text;
  std::vector<std::string> sound;
  std::function<void(const std::string& path)> read;
};

/// "deck", "msh", "geo", "exodus"; scratch: a folder where files may be made.
Target makeTarget(const std::string& name, const std::string& scratch);

} // namespace ndframe::test
