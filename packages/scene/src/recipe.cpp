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

std::string materialText(const Params& body)
{
  return (body.hasSub("Material") ? toXml(body.sub("Material")) : std::string()) +
         (body.hasSub("Regions") ? toXml(body.sub("Regions")) : std::string()) +
         (body.hasSub("Rigid") ? toXml(body.sub("Rigid")) : std::string());
}

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

SceneRecipe recipeOf(const Params& deck)
{
  SceneRecipe recipe;
  for (const auto& body : deck.sub("Bodies").subs()) {
    const Params mesh = body.sub(body.hasSub("Rigid") ? "Rigid" : "Mesh");
    recipe.bodies.push_back({body.name(),
                             meshText(mesh) + toXml(deck.sub("Discretization")) +
                                 (body.hasSub("Regions") || toXml(body.sub("Loads")).find("Cells") != std::string::npos
                                      ? " with groups of cells"
                                      : ""),
                             materialText(body), toXml(body.sub("Supports")) + toXml(body.sub("Loads"))});
  }
  recipe.interfaces = toXml(deck.sub("Interfaces"));
  recipe.solver = toXml(deck.sub("Linear Solver"));
  recipe.representation = toXml(deck.sub("Interface Operator"));
  return recipe;
}

} // namespace ndframe
