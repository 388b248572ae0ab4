#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/interface/interface_mesh.hpp"

namespace ndframe
{

struct Model;

/// What is allowed but probably a mistake. With the deck's Strict Input it is an error.
struct Warning
{
  std::string kind; ///< of the check, e.g. "large strain"
  Diagnostic what;  ///< the place in the deck and the sentence
};

/// What ranks are told of the bodies of a scene as a whole where each has a share of them. Per body:
struct ToldScene
{
  std::vector<std::string> heldBy;          ///< heldBy()
  std::vector<double> diameters;            ///< of its mesh
  std::vector<RigidBasis> rigid;            ///< Model::rigid
  std::vector<DenseMatrix> freeMotions;     ///< Model::freeMotions
  std::vector<DenseMatrix> balancedMotions; ///< Model::balancedMotions
  std::string pulledOff;         ///< of all bodies: why refusePulledOff() would refuse them; empty: it does not
  std::vector<Warning> warnings; ///< of the scene
  /// Of interfaces: their names, points, facets, measures and normals at ends (sidesAsDrawn).
  std::vector<InterfaceMesh> sides;
};

/// What a model of the whole scene says; without warnings and sides.
ToldScene told(const Model& whole);

/// As bytes for another rank, and read back (InternalError: they are others).
std::string toBytes(const ToldScene& scene);
ToldScene toldSceneFromBytes(std::string_view bytes); ///< the second of these

} // namespace ndframe
