#pragma once

#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// Takes the laws and regions of a body from its lists Material and Regions; the body's mesh is there. Mistakes, with
/// their places: a region that names groups of cells that the mesh does not have, or no cells; a cell in two regions; a
/// cell in no region of a body without Material; hypotheses that differ or do not suit the mesh. whole: of a part of a
/// body, which may have no cells of a region, the regions of the whole; null: the mesh is the whole.
void takeMaterials(BodyModel& body, const BodySettings& settings, const SceneComponents& components,
                   const std::vector<BodyRegion>* whole, Diagnostics& diagnostics);

/// A material of a body and where the deck describes it.
struct PlacedMaterial
{
  Params list;           ///< list Material of the body or of a region: place of mistakes
  const Elasticity& law; ///< owned by the body, which must live as long
};
std::vector<PlacedMaterial> materialsOf(const BodyModel& body, const BodySettings& settings); ///< per region

} // namespace ndframe
