#include <filesystem>

#include <unistd.h>

#include <fmt/format.h>

#include "accuracy_options.hpp"
#include "outputs.hpp"

namespace ndframe
{

void checkOutputFolder(const Params& deck)
{
  const Params output = deck.sub("Output");
  const bool writes = output.get<bool>("Exodus") || output.get<bool>("Summary") || output.get<bool>("Contact Table") ||
                      (wantsAccuracy(deck) && output.get<bool>("Level Table"));
  std::filesystem::path folder = std::filesystem::absolute(output.get<std::string>("Directory"));
  std::error_code none;
  while (!std::filesystem::exists(folder, none) && folder.has_relative_path())
    folder = folder.parent_path(); // missing folders are made
  const bool isFolder = std::filesystem::is_directory(folder, none);
  if (writes && (!isFolder || access(folder.c_str(), W_OK) != 0))
    throw InputError(output.mistake(
        "Directory", fmt::format("\"{}\" is not a folder that can be written in; name another Directory.",
                                 isFolder ? folder.string() : output.get<std::string>("Directory"))));
}

std::filesystem::path outputStem(const Params& output, const std::string& deckName)
{
  const std::filesystem::path folder = output.get<std::string>("Directory");
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    throw InputError(output.mistake(
        "Directory", fmt::format("cannot make the folder \"{}\": {}.", folder.string(), failure.message())));
  const auto name = output.get<std::string>("Name");
  return (folder / (name.empty() ? std::filesystem::path(deckName).stem().string() : name)).lexically_normal();
}

void writeOnFirstRank(const Comm& comm, const std::function<void()>& write)
{
  std::string failure;
  if (comm.rank() == 0) {
    try {
      write();
    } catch (const InputError& error) {
      failure = error.what();
    }
  }
  comm.broadcast(failure);
  if (!failure.empty())
    throw InputError(failure);
}

} // namespace ndframe
