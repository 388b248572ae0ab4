#include "ndframe/scene/recipe.hpp"

#include <filesystem>

#include <fmt/format.h>

namespace ndframe
{
namespace
{

/// Which state of which file it is; a file that cannot be looked at is refused when it is read.
std::string fileStamp(const std::string& path)
{
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  const auto time = std::filesystem::last_write_time(path, ignored).time_since_epoch().count();
  return fmt::format("{} {} {}", std::filesystem::absolute(path, ignored).string(), size, time);
}

/// The mesh's text with the states of all files that it names.
std::string meshText(const Params& mesh)
{
  std::string text = toXml(mesh) + (mesh.has("File") ? fileStamp(mesh.file("File")) : std::string());
  if (mesh.hasSub("Joints"))
    for (const Params& part : mesh.sub("Parts").subs())
      text += meshText(part);
  return text;
}

} // namespace

bool SceneRecipe::sameModel(const SceneRecipe& other) const
{
  return !bodies.empty() && bodies == other.bodies && interfaces == other.interfaces;
}

bool SceneRecipe::sameSolver(const SceneRecipe& other) const
{
  return solver == other.solver && solvesWhole == other.solvesWhole;
}

bool SceneRecipe::sameSystems(const SceneRecipe& other) const
{
  return sameModel(other) && sameSolver(other) && representation == other.representation;
}

SceneRecipe recipeOf(const SceneSettings& scene)
{
  SceneRecipe recipe;
  for (const BodySettings& body : scene.bodies) {
    const bool mayNameCells = body.hasRegions || body.loadText.find("Cells") != std::string::npos;
    recipe.bodies.push_back(
        {body.name, meshText(body.shape) + scene.discretizationText + (mayNameCells ? " with groups of cells" : ""),
         body.materialText, body.supportText + body.loadText});
  }
  recipe.interfaces = scene.interfacesText;
  recipe.solver = toXml(scene.linearSolver);
  recipe.representation = toXml(scene.interfaceOperator);
  return recipe;
}

} // namespace ndframe
