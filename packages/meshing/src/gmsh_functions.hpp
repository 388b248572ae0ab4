#pragma once

#include <gmshc.h>

namespace ndframe
{

/// The functions of gmsh's C interface that are used, bound at run time; nothing links gmsh.
class GmshFunctions
{
public:
  /// Loads the library at the first call. Throws FileError when that is not possible.
  static const GmshFunctions& get();

#define NDFRAME_GMSH(member, name) decltype(&name) member = reinterpret_cast<decltype(&name)>(find(#name))
  NDFRAME_GMSH(initialize, gmshInitialize);
  NDFRAME_GMSH(finalize, gmshFinalize);
  NDFRAME_GMSH(setNumber, gmshOptionSetNumber);
  NDFRAME_GMSH(getNumber, gmshOptionGetNumber);
  NDFRAME_GMSH(open, gmshOpen);
  NDFRAME_GMSH(dimension, gmshModelGetDimension);
  NDFRAME_GMSH(generate, gmshModelMeshGenerate);
  NDFRAME_GMSH(write, gmshWrite);
  NDFRAME_GMSH(startLog, gmshLoggerStart);
  NDFRAME_GMSH(stopLog, gmshLoggerStop);
  NDFRAME_GMSH(getLog, gmshLoggerGet);
  NDFRAME_GMSH(free, gmshFree);
  NDFRAME_GMSH(clear, gmshClear);
  NDFRAME_GMSH(entities, gmshModelGetEntities);
  NDFRAME_GMSH(groups, gmshModelGetPhysicalGroups);
  NDFRAME_GMSH(groupName, gmshModelGetPhysicalName);
  NDFRAME_GMSH(groupEntities, gmshModelGetEntitiesForPhysicalGroup);
  NDFRAME_GMSH(boundary, gmshModelGetBoundary);
  NDFRAME_GMSH(setVisibility, gmshModelSetVisibility);
  NDFRAME_GMSH(value, gmshModelGetValue);
  NDFRAME_GMSH(derivative, gmshModelGetDerivative);
  NDFRAME_GMSH(closestPoint, gmshModelGetClosestPoint);
  NDFRAME_GMSH(setBackground, gmshModelMeshFieldSetAsBackgroundMesh);
  NDFRAME_GMSH(setSizeCallback, gmshModelMeshSetSizeCallback);
  NDFRAME_GMSH(removeConstraints, gmshModelMeshRemoveConstraints);
  NDFRAME_GMSH(clearMesh, gmshModelMeshClear);
  NDFRAME_GMSH(nodes, gmshModelMeshGetNodes);
  NDFRAME_GMSH(setNode, gmshModelMeshSetNode);
  NDFRAME_GMSH(addNodes, gmshModelMeshAddNodes);
  NDFRAME_GMSH(addElements, gmshModelMeshAddElementsByType);
#undef NDFRAME_GMSH

private:
  GmshFunctions() = default;
  static void* find(const char* name);
};

} // namespace ndframe
