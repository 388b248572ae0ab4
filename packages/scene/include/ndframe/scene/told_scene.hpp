#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/mesh/outline.hpp"

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
  std::vector<int> halvings;                ///< of its mesh since it was read
  std::vector<double> diameters;            ///< of its mesh
  std::vector<MeshOutline> outlines;        ///< of its mesh
  std::vector<RigidBasis> rigid;            ///< Model::rigid
  std::vector<DenseMatrix> freeMotions;     ///< Model::freeMotions
  std::vector<DenseMatrix> balancedMotions; ///< Model::balancedMotions
  std::string pulledOff;         ///< of all bodies: why refusePulledOff() would refuse them; empty: it does not
  std::vector<Warning> warnings; ///< of the scene
};

/// What a model of the whole scene says; without halvings and warnings.
ToldScene told(const Model& whole);

/// As bytes for another rank, and read back (InternalError: they are others).
std::string toBytes(const ToldScene& scene);
ToldScene toldSceneFromBytes(std::string_view bytes); ///< the second of these

} // namespace ndframe
