#include "ndframe/scene/told_scene.hpp"

#include <algorithm>

#include "ndframe/base/ascending.hpp"
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

/// Their number, and each as `walkOne` does.
template <class Stream, class Items, class Walk>
void walkAll(Stream& stream, Items& items, const Walk& walkOne)
{
  stream.length(items);
  for (auto& item : items)
    walkOne(item);
}

template <class Stream, class BodyOutline>
void walkOutline(Stream& stream, BodyOutline& outline)
{
  stream.number(outline.measure);
  walkAll(stream, outline.sides, [&](auto& named) {
    auto& [name, side] = named;
    stream.array(name);
    stream.number(side.measure);
    stream.number(side.size);
    stream.array(side.corners);
  });
}

template <class Stream, class Side>
void walkSide(Stream& stream, Side& side)
{
  stream.array(side.name);
  stream.number(side.dim);
  stream.array(side.points);
  stream.array(side.facets);
  stream.array(side.measures);
  stream.array(side.endNormals);
}

template <class Stream, class Warning>
void walkWarning(Stream& stream, Warning& warning)
{
  stream.array(warning.kind);
  stream.array(warning.what.file);
  stream.number(warning.what.line);
  stream.array(warning.what.path);
  stream.array(warning.what.message);
}

/// Everything, in one order for both directions.
template <class Stream, class Scene>
void walk(Stream& stream, Scene& scene)
{
  stream.arrays(scene.heldBy);
  stream.array(scene.halvings);
  stream.array(scene.diameters);
  walkAll(stream, scene.outlines, [&](auto& outline) { walkOutline(stream, outline); });
  stream.array(scene.rigid);
  for (auto* motions : {&scene.freeMotions, &scene.balancedMotions})
    walkAll(stream, *motions, [&](auto& matrix) { walk(stream, matrix); });
  walkAll(stream, scene.regions, [&](auto& ofBody) {
    walkAll(stream, ofBody, [&](auto& region) {
      stream.array(region.name);
      stream.number(region.numCells);
      stream.number(region.law);
    });
  });
  stream.array(scene.pins);
  walkAll(stream, scene.holds, [&](auto& hold) {
    stream.number(hold.body);
    stream.number(hold.support);
    walk(stream, hold.motions);
  });
  walk(stream, scene.jointMotions);
  stream.array(scene.areCut);
  stream.number(scene.areRead);
  stream.array(scene.pulledOff);
  walkAll(stream, scene.warnings, [&](auto& warning) { walkWarning(stream, warning); });
  walkAll(stream, scene.sides, [&](auto& side) { walkSide(stream, side); });
}

} // namespace

ToldScene told(const Model& whole)
{
  ToldScene scene;
  scene.rigid = whole.rigid;
  scene.freeMotions = whole.freeMotions;
  scene.balancedMotions = whole.balancedMotions;
  scene.jointMotions = whole.jointMotions;
  for (std::size_t b = 0; b < whole.bodies.size(); ++b) {
    scene.heldBy.push_back(heldBy(whole, int(b)));
    scene.outlines.push_back(outlineOf(whole.bodies[b].mesh));
    scene.diameters.push_back(diameter(whole.bodies[b].mesh));
    scene.regions.push_back(whole.bodies[b].regions);
  }
  for (const HeldMean& hold : whole.holds)
    scene.holds.push_back({hold.body, int(hold.support), hold.motions});
  for (const InterfaceMesh& interface : whole.interfaces)
    scene.areCut.push_back(char(interface.isCut));
  try {
    refusePulledOff(whole);
  } catch (const NotConverged& refusal) {
    scene.pulledOff = refusal.what();
  }
  return scene;
}

void takePins(const std::vector<BodyModel>& bodies, const ToldScene& told)
{
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (std::size_t s = 0; s < bodies[b].supports.size(); ++s) {
      std::vector<NodeConstraint> pins;
      for (const ToldPin& pin : told.pins)
        if (pin.body == int(b) && pin.support == int(s))
          if (const int node = placeOf(bodies[b].share->numbers(), pin.node); node >= 0)
            pins.push_back({node, pin.direction, pin.value});
      bodies[b].supports[s]->pin(pins);
    }
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
