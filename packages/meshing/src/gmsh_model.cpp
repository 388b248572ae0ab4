#include "gmsh_model.hpp"

#include <algorithm>
#include <cstdlib>

#include "ndframe/reading/gmsh_converter.hpp"

namespace ndframe
{
namespace
{

/// gmsh integrates sizes along curves to 1e-9 if it is not told otherwise, which takes longer than to make the mesh.
constexpr double curvePrecision = 1e-5;
/// Tetrahedra of a worse shape are mended; with gmsh's own 0.3 a punch took 6 % more dofs to 2 %.
constexpr double mendedShape = 0.6;

/// gmsh's pairs of a dimension and a tag.
std::vector<int> dimTags(int dim, const std::vector<int>& tags)
{
  std::vector<int> pairs;
  for (const int tag : tags)
    pairs.insert(pairs.end(), {dim, tag});
  return pairs;
}

std::vector<int> tagsOf(const GmshArray<int>& pairs)
{
  std::vector<int> tags;
  for (std::size_t i = 1; i < pairs.size; i += 2)
    tags.push_back(std::abs(pairs.data[i]));
  return tags;
}

} // namespace

GmshModel::GmshModel(const std::string& script)
{
  session_.open(script);
  forgetOwnSizes();
}

std::vector<int> GmshModel::entitiesOf(int dim, const std::vector<std::string>& groups) const
{
  GmshArray<int> pairs;
  int error = 0;
  if (groups.empty()) {
    gmsh_.entities(&pairs.data, &pairs.size, dim, &error);
    require(error);
    return tagsOf(pairs);
  }
  std::vector<int> tags;
  gmsh_.groups(&pairs.data, &pairs.size, dim, &error);
  for (const int group : tagsOf(pairs)) {
    GmshArray<char> name;
    gmsh_.groupName(dim, group, &name.data, &error);
    if (std::find(groups.begin(), groups.end(), gmshGroupName(name.data, group)) == groups.end())
      continue;
    GmshArray<int> entities;
    gmsh_.groupEntities(dim, group, &entities.data, &entities.size, &error);
    tags.insert(tags.end(), entities.begin(), entities.end());
  }
  require(error);
  return tags;
}

std::vector<int> GmshModel::boundaryOf(int dim, int tag) const
{
  std::vector<int> pair{dim, tag};
  GmshArray<int> boundary;
  int error = 0;
  gmsh_.boundary(pair.data(), pair.size(), &boundary.data, &boundary.size, 0, 0, 0, &error);
  require(error);
  return tagsOf(boundary);
}

void GmshModel::showOnly(int dim, const std::vector<int>& tags)
{
  std::vector<int> all = dimTags(dim, entitiesOf(dim, {})), shown = dimTags(dim, tags);
  int error = 0;
  gmsh_.setVisibility(all.data(), all.size(), 0, 1, &error);
  gmsh_.setVisibility(shown.data(), shown.size(), 1, 1, &error); // also what it shares with others
  require(error);
  session_.setNumber("Mesh.MeshOnlyVisible", 1);
}

void GmshModel::forgetOwnSizes()
{
  for (const char* option :
       {"Mesh.MeshSizeExtendFromBoundary", "Mesh.MeshSizeFromPoints", "Mesh.MeshSizeFromCurvature", "Mesh.MeshSizeMin"})
    session_.setNumber(option, 0);
  session_.setNumber("Mesh.MeshSizeMax", 1e22);
  session_.setNumber("Mesh.MeshSizeFactor", 1);
  session_.setNumber("Mesh.ElementOrder", 1);
  session_.setNumber("Mesh.LcIntegrationPrecision", curvePrecision);
  int error = 0;
  gmsh_.clearMesh(nullptr, 0, &error); // of a script that meshes
  gmsh_.setBackground(0, &error);
  require(error);
}

void GmshModel::useSettingsForSolids()
{
  session_.setNumber("Mesh.RandomSeed", 1);
  session_.setNumber("Mesh.Algorithm3D", gmshDelaunay);
  session_.setNumber("Mesh.Optimize", 1);
  session_.setNumber("Mesh.OptimizeThreshold", mendedShape);
  session_.setNumber("Mesh.RecombineAll", 0);
  session_.setNumber("Mesh.Recombine3DAll", 0);
  session_.setNumber("Mesh.SubdivisionAlgorithm", 0);
  int error = 0;
  gmsh_.removeConstraints(nullptr, 0, &error);
  require(error);
}

void GmshModel::setSizes(SizeAt sizeAt, const void* data, int surfaceAlgorithm)
{
  session_.setNumber("Mesh.Algorithm", surfaceAlgorithm);
  int error = 0;
  gmsh_.setSizeCallback(sizeAt, const_cast<void*>(data), &error);
  require(error);
}

} // namespace ndframe
