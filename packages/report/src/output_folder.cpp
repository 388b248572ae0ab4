#include <algorithm>
#include <climits>
#include <filesystem>

#include <unistd.h>

#include <fmt/format.h>

#include "ndframe/algebra/from_rank_zero.hpp"
#include "ndframe/io/atomic_file.hpp"
#include "ndframe/report/outputs.hpp"

namespace ndframe
{

namespace
{

/// The longest of what follows a name: NAME.study.partial.csv, and the number of a study's case before that.
constexpr std::size_t longestEnding = 24;

std::filesystem::path absoluteFolder(const OutputOptions& output)
{
  std::error_code failure;
  auto folder = std::filesystem::absolute(output.directory, failure);
  if (failure) // only where the working directory is gone
    throw InputError(output.place.mistake("Directory",
                                          "the working directory does not exist any more; change to another one, "
                                          "or give Directory as an absolute path."));
  return folder;
}

std::string baseName(const OutputOptions& output, const std::string& deckName)
{
  const auto name = output.name;
  return name.empty() ? std::filesystem::path(deckName).stem().string() : name;
}

/// The mesh files of a body: those of its parts, where it is tied.
void eachMeshFile(const Params& mesh, const std::function<void(const Params&)>& look)
{
  if (mesh.hasSub("Parts"))
    for (const Params& part : mesh.sub("Parts").subs())
      eachMeshFile(part, look);
  if (mesh.has("File"))
    look(mesh);
}

/// The last of the files from `first` on that are pieces of the same as this; `first` itself where it is no piece.
std::size_t lastPiece(const std::vector<std::string>& files, std::size_t first)
{
  const auto beginning = [](const std::string& file) { return file.substr(0, file.rfind('.') + 1); };
  const auto isPiece = [](const std::string& file) {
    return file.find_first_not_of("0123456789", file.rfind('.') + 1) == std::string::npos;
  };
  std::size_t last = first;
  while (last + 1 < files.size() && isPiece(files[first]) && isPiece(files[last + 1]) &&
         beginning(files[last + 1]) == beginning(files[first]))
    ++last;
  return last;
}

} // namespace

void checkMeshesStay(const RunSettings& settings, const std::string& deckName)
{
  if (!settings.output.exodus)
    return;
  const std::string name = baseName(settings.output, deckName);
  std::error_code none;
  const std::string fields =
      (std::filesystem::weakly_canonical(absoluteFolder(settings.output), none) / (name + ".e")).string();
  const auto look = [&](const Params& mesh) {
    const std::string file =
        std::filesystem::weakly_canonical(std::filesystem::absolute(mesh.file("File"), none), none).string();
    if (file == fields || file.compare(0, fields.size() + 1, fields + ".") == 0) // the whole, or pieces
      throw InputError(mesh.mistake("File", fmt::format("{} would be replaced by the results, which are called {}.e; "
                                                        "give another Output/Name or Output/Directory.",
                                                        mesh.get<std::string>("File"), name)));
  };
  for (const BodySettings& body : settings.scene.bodies)
    if (!body.isRigid)
      eachMeshFile(body.shape, look);
}

void checkNameLength(const OutputOptions& output, const std::string& name)
{
  const std::size_t longest = longestFileName() - longestEnding;
  if (name.size() > longest)
    throw InputError(output.place.mistake(
        "Name", fmt::format("the files' names would begin with {} characters, and at most {} fit there, with what is "
                            "added to them; give a shorter Name.",
                            name.size(), longest)));
}

void checkOutput(const RunSettings& settings, const std::string& deckName)
{
  const OutputOptions& output = settings.output;
  const bool writes = output.exodus || output.summary || output.contactTable || output.probeTable ||
                      output.checkpoint || (settings.accuracy && output.levelTable);
  if (!writes)
    return;
  std::filesystem::path folder = absoluteFolder(output);
  const bool longPart =
      std::any_of(folder.begin(), folder.end(), [](const auto& part) { return part.native().size() > NAME_MAX; });
  if (longPart || folder.native().size() + NAME_MAX >= PATH_MAX)
    throw InputError(output.place.mistake("Directory",
                                          "Directory is longer than the system lets a folder's path be; name "
                                          "another one."));
  checkNameLength(output, baseName(output, deckName));
  checkMeshesStay(settings, deckName);
  std::error_code none;
  while (!std::filesystem::exists(folder, none) && folder.has_relative_path())
    folder = folder.parent_path(); // missing folders are made
  const bool isFolder = std::filesystem::is_directory(folder, none);
  if (!isFolder || access(folder.c_str(), W_OK) != 0)
    throw InputError(
        output.place.mistake("Directory", fmt::format("\"{}\" is not a writable folder; name another Directory.",
                                                      isFolder ? folder.string() : output.directory)));
}

std::filesystem::path outputStem(const OutputOptions& output, const std::string& deckName)
{
  const std::filesystem::path folder = output.directory;
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    throw InputError(output.place.mistake(
        "Directory", fmt::format("cannot make the folder \"{}\": {}.", folder.string(), failure.message())));
  return (folder / baseName(output, deckName)).lexically_normal();
}

std::string commonStem(const OutputOptions& output, const std::string& deckName, const Comm& comm)
{
  std::string stem;
  onEveryRank(comm, [&] { stem = outputStem(output, deckName).string(); });
  return stem;
}

std::string namesText(const std::vector<std::string>& files)
{
  std::string text;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!text.empty())
      text += ", ";
    text += files[i];
    const std::size_t last = lastPiece(files, i);
    if (last > i) {
      text += (last > i + 1 ? ", ..., " : ", ") + files[last];
      i = last;
    }
  }
  return text;
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
