#pragma once

#include <string>
#include <vector>

#include "ndframe/scene/scene_settings.hpp"

namespace ndframe
{

/// What the parts of a scene are made from, as text of the deck: parts with the same recipe are the same, bit by bit,
/// and may be handed on from one run to the next. Recipes hold everything a part depends on but what another part
/// hands to it (the interface nodes of a body, say), which whoever reuses it compares itself.
struct BodyRecipe
{
  std::string name; ///< of the body, in the deck
  std::string mesh; ///< list Mesh, order of the elements; path, size and time of the mesh file; with or without groups
                    ///< of cells
  std::string matrix; ///< lists Material and Regions
  std::string load;   ///< lists Supports and Loads

  /// All texts are the same, so that everything made from them is.
  bool operator==(const BodyRecipe& other) const
  {
    return name == other.name && mesh == other.mesh && matrix == other.matrix && load == other.load;
  }
};

/// The recipes of all bodies, in the order of the deck, and of what joins and solves them.
struct SceneRecipe
{
  std::vector<BodyRecipe> bodies; ///< none: nothing is known, nothing is the same
  std::string interfaces;         ///< list Interfaces; those whose sides changed places since (giveOneRole)
  std::string solver;             ///< list Linear Solver
  bool solvesWhole = false;       ///< Model::solvesWhole
  std::string representation;     ///< list Interface Operator

  /// The same meshes, materials, supports, loads and interfaces.
  bool sameModel(const SceneRecipe& other) const;
  bool sameSolver(const SceneRecipe& other) const; ///< bodies are factored in the same way
  /// The same model, solved in the same way.
  bool sameSystems(const SceneRecipe& other) const;
};

/// Limit: of a mesh made by a .geo script only the script itself is looked at, not the files that it includes.
SceneRecipe recipeOf(const SceneSettings& scene);

} // namespace ndframe
