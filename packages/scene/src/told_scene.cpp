#include "ndframe/scene/told_scene.hpp"

#include <algorithm>

#include "ndframe/mesh/byte_stream.hpp"
#include "ndframe/scene/model.hpp"
#include "ndframe/scene/rigid_check.hpp"

namespace ndframe
{
namespace
{

void walk(ByteWriter& stream, const DenseMatrix& matrix)
{
  stream.number(matrix.rows());
  stream.number(matrix.cols());
  for (int j = 0; j < matrix.cols(); ++j)
    stream.array(matrix.column(j));
}

void walk(ByteReader& stream, DenseMatrix& matrix)
{
  int rows = 0, columns = 0;
  stream.number(rows);
  stream.number(columns);
  matrix = DenseMatrix(rows, columns);
  for (int j = 0; j < columns; ++j) {
    Vector column;
    stream.array(column);
    std::copy_n(column.begin(), rows, matrix.col(j));
  }
}

/// Everything, in one order for both directions.
template <class Stream, class Scene>
void walk(Stream& stream, Scene& scene)
{
  stream.arrays(scene.heldBy);
  stream.array(scene.diameters);
  stream.array(scene.rigid);
  for (auto* motions : {&scene.freeMotions, &scene.balancedMotions}) {
    stream.length(*motions);
    for (auto& matrix : *motions)
      walk(stream, matrix);
  }
  stream.array(scene.pulledOff);
  stream.length(scene.warnings);
  for (auto& warning : scene.warnings) {
    stream.array(warning.kind);
    stream.array(warning.what.file);
    stream.number(warning.what.line);
    stream.array(warning.what.path);
    stream.array(warning.what.message);
  }
  stream.length(scene.sides);
  for (auto& side : scene.sides) {
    stream.array(side.name);
    stream.number(side.dim);
    stream.array(side.points);
    stream.array(side.facets);
    stream.array(side.measures);
    stream.array(side.endNormals);
  }
}

} // namespace

ToldScene told(const Model& whole)
{
  ToldScene scene{{}, {}, whole.rigid, whole.freeMotions, whole.balancedMotions, {}, {}, {}};
  for (std::size_t b = 0; b < whole.bodies.size(); ++b) {
    scene.heldBy.push_back(heldBy(whole, int(b)));
    scene.diameters.push_back(diameter(whole.bodies[b].mesh));
  }
  try {
    refusePulledOff(whole);
  } catch (const NotConverged& refusal) {
    scene.pulledOff = refusal.what();
  }
  return scene;
}

std::string toBytes(const ToldScene& scene)
{
  ByteWriter writer;
  walk(writer, scene);
  return writer.take();
}

ToldScene toldSceneFromBytes(std::string_view bytes)
{
  ByteReader reader(bytes);
  ToldScene scene;
  walk(reader, scene);
  reader.requireEnd();
  return scene;
}

} // namespace ndframe
