#include "fuzz/targets.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>

#include <exodusII.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/base/deck.hpp"
#include "ndframe/driver/components.hpp"
#include "ndframe/driver/deck_spec.hpp"
#include "reading/mesh_files.hpp"

namespace ndframe::test
{

namespace
{

std::string contents(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> filesIn(const std::string& folder, const std::string& extension)
{
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == extension)
      paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end()); // the same inputs on every machine
  std::vector<std::string> found;
  for (const auto& path : paths)
    found.push_back(contents(path));
  return found;
}

Target deckTarget(const std::string&)
{
  const std::shared_ptr<const Components> components = makeComponents();
  const ListSpec spec = makeDeckSpec(*components);
  return {true, filesIn(NDFRAME_DECKS, ".xml"), [components, spec](const std::string& path) {
            Diagnostics diagnostics;
            const DeckList deck = readDeck(path);
            validate(deck, spec, diagnostics);
            diagnostics.throwIfAny();
          }};
}

std::function<void(const std::string&)> meshReader(const std::string& type)
{
  return [type](const std::string& path) { readMesh(text("Type", type) + text("File", path)); };
}

Target mshTarget(const std::string&)
{
  const std::string small = asMsh41(readMesh(text("Type", "Box") + doubles("Lower", "0, 0, 0") +
                                             doubles("Upper", "1, 1, 1") + ints("Cells", "1, 2, 1")));
  std::vector<std::string> sound = filesIn(NDFRAME_MESHES, ".msh");
  sound.push_back(small);
  return {true, std::move(sound), meshReader("Gmsh")};
}

/// What is still a script runs, in a child process.
Target geoTarget(const std::string& scratch)
{
  const std::string script = scratch + "/input.geo";
  std::vector<std::string> sound = filesIn(NDFRAME_DECKS "/meshes", ".geo");
  for (std::string& bodies : sound)
    bodies += "Delete Physicals;\n"; // two bodies become one
  return {true, std::move(sound), [script](const std::string& path) {
            std::filesystem::copy_file(path, script, std::filesystem::copy_options::overwrite_existing);
            readMesh(text("Type", "Gmsh") + text("File", script) + integer("Maximum Seconds", "1"));
          }};
}

Target exodusTarget(const std::string& scratch)
{
  const std::string path = scratch + "/sound.e";
  std::vector<std::string> sound = filesIn(NDFRAME_MESHES, ".e");
  const Mesh plane =
      readMesh(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "1, 1") + ints("Cells", "2, 2"));
  const Mesh solid = readMesh(text("Type", "Box") + doubles("Lower", "0, 0, 0") + doubles("Upper", "1, 1, 1") +
                              ints("Cells", "1, 1, 1"));
  for (const Mesh* mesh : {&plane, &solid})
    for (const int format : {EX_NORMAL_MODEL, EX_LARGE_MODEL, EX_NETCDF4}) {
      writeExodus(path, asExodusSample(*mesh), format);
      sound.push_back(contents(path));
    }
  std::filesystem::remove(path);
  return {false, std::move(sound), meshReader("Exodus")};
}

} // namespace

Target makeTarget(const std::string& name, const std::string& scratch)
{
  static const std::map<std::string, Target (*)(const std::string&)> targets{
      {"deck", deckTarget}, {"msh", mshTarget}, {"geo", geoTarget}, {"exodus", exodusTarget}};
  const auto found = targets.find(name);
  if (found == targets.end())
    throw std::runtime_error("there is no reader \"" + name + "\": deck, msh, geo, exodus");
  return found->second(scratch);
}

} // namespace ndframe::test
