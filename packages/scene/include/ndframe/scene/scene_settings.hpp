#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ndframe/interface/interface_settings.hpp"

namespace ndframe
{

/// What contact is asked of on bodies of second order: values at the nodes, or Bernstein coefficients (ContactBasis).
enum class ContactConditions
{
  Nodal,
  Bernstein
};

const Names<DrawnGap>& drawnGapNames(); ///< of Gap From Geometry

/// A part of a body with a material of its own.
struct RegionSettings
{
  ListPlace place; ///< for mistakes that show later
  std::string name;
  std::vector<std::string> cells; ///< groups of cells; none: the one of its own name
  Params material;                ///< for the builder
};

/// A body of the deck. Lists of components are for their builders.
struct BodySettings
{
  ListPlace place; ///< for mistakes that show later
  std::string name;
  bool isRigid = false;
  Params shape = Params(nullptr); ///< list Mesh; of a rigid body, list Rigid
  std::vector<ListPlace> idle;    ///< lists that mean nothing to a rigid body
  std::optional<Params> material; ///< of the cells in no region
  bool hasRegions = false;        ///< the list is there, perhaps empty
  std::vector<RegionSettings> regions;
  std::vector<Params> supports, loads;
  bool namesCells = false;  ///< its regions or a load are of groups of cells
  std::string materialText; ///< of the lists Material, Regions and Rigid
  std::string supportText, loadText;

  /// Where the material of a region stands; empty name: of the rest.
  const Params& materialOf(const std::string& region) const;
};

/// What the deck says of the bodies, their contact and how they are solved, read once.
struct SceneSettings
{
  ListPlace discretization, bodiesPlace, interfacesPlace; ///< for mistakes that show later
  int order = 2;                                          ///< of the displacement: 1 or 2
  std::optional<ContactConditions> conditions;            ///< none: Bernstein in space and Nodal in the plane
  std::vector<BodySettings> bodies;
  std::vector<InterfaceSettings> interfaces; ///< without those that a list Automatic stands for
  Params linearSolver = Params(nullptr), interfaceOperator = Params(nullptr); ///< for the builders
  bool certifies = false;                                                     ///< the deck has a list Error Estimation
  bool hasTarget = false;                                                     ///< the deck has a list Accuracy
  std::string discretizationText, interfacesText;

  const InterfaceSettings& interface(const std::string& name) const; ///< InternalError if there is none
};

/// Of a validated deck.
SceneSettings readScene(const Params& deck);

} // namespace ndframe
