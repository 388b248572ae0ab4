#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ndframe/assembly/body_system.hpp"
#include "ndframe/assembly/rigid_modes.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/interface/interface_mesh.hpp"
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

/// An equation of a support that holds no side.
struct ToldPin
{
  int body = 0, support = 0; ///< index into Model::bodies, and into the body's supports
  std::int64_t node = 0;     ///< of the whole body (BodyShare)
  Direction direction{};     ///< NodeConstraint
  double value = 0.0;        ///< a length
};

/// What a support Hold holds.
struct ToldHold
{
  int body = 0, support = 0; ///< as in ToldPin
  DenseMatrix motions;       ///< HeldMean::motions
};

/// What ranks are told of the bodies of a scene as a whole where each has a share of them. Per body, if nothing else
/// is said:
struct ToldScene
{
  std::vector<std::string> heldBy;              ///< heldBy()
  std::vector<int> halvings;                    ///< of its mesh since it was read
  std::vector<MeshOutline> outlines;            ///< of its mesh
  std::vector<double> diameters;                ///< of its mesh
  std::vector<RigidBasis> rigid;                ///< Model::rigid
  std::vector<DenseMatrix> freeMotions;         ///< Model::freeMotions
  std::vector<DenseMatrix> balancedMotions;     ///< Model::balancedMotions
  std::vector<std::vector<BodyRegion>> regions; ///< BodyModel::regions
  std::vector<ToldPin> pins;                    ///< of all bodies
  std::vector<ToldHold> holds;                  ///< of all bodies
  DenseMatrix jointMotions;                     ///< Model::jointMotions
  std::vector<char> areCut;                     ///< per interface: InterfaceMesh::isCut
  bool areRead = false;                         ///< in pieces by all ranks; else handed out by rank 0
  std::string pulledOff;         ///< of all bodies: why refusePulledOff() would refuse them; empty: it does not
  std::vector<Warning> warnings; ///< of the scene
  /// Of interfaces: their names, points, facets, measures and normals at ends of the sides as drawn.
  std::vector<InterfaceMesh> sides;
};

/// What a model of the whole scene says; without halvings, pins, whose nodes have other numbers, warnings and sides.
ToldScene told(const Model& whole);

/// Gives supports that hold no side the equations that they have in the shares of these bodies.
void takePins(const std::vector<BodyModel>& bodies, const ToldScene& told);

/// As bytes for another rank, and read back (InternalError: they are others).
std::string toBytes(const ToldScene& scene);
ToldScene toldSceneFromBytes(std::string_view bytes); ///< the second of these

} // namespace ndframe
