#include <fmt/format.h>

#include "box_deck.hpp"
#include "mesh_sources.hpp"

namespace ndframe
{

namespace
{

/// A box cut into simplices.
class Box final : public MeshSource
{
public:
  explicit Box(const Params& params) : params_(params), grid_(BoxDeck(params).grid()) {}

  Mesh read() const override
  {
    Mesh mesh = boxMesh(grid_);
    const std::vector<std::string> mistakes = checkMesh(mesh);
    if (!mistakes.empty())
      throw InputError(params_.mistake("", fmt::format("the box is too thin for double precision: {}", mistakes[0])));
    return mesh;
  }

  MeshScript script() const override { refuseRemesh(params_, "Type"); }

private:
  Params params_;
  BoxGrid grid_;
};

ListSpec sizesSpec(int direction)
{
  ListSpec spec;
  spec.name = boxSizesList(direction);
  spec.doc =
      fmt::format("Relative cell sizes along {}: the cells between two points grow geometrically. With At = {{0, "
                  "1, 4}} and Size = {{1, 0.1, 1}} cells get finer towards 1 from both sides.",
                  boxDirections.name(direction));
  spec.onlyIfGiven = true;
  spec.params = {
      ParamSpec::required("At", Kind::Doubles, "Increasing coordinates, before the rotation."),
      ParamSpec::required("Size", Kind::Doubles, "Relative size of the cells at each point; only ratios count.")};
  return spec;
}

ListSpec splitsSpec()
{
  auto split = std::make_shared<ListSpec>();
  split->doc = "Cuts a side into named parts; the side's own name stays valid for all of it.";
  split->params = {
      ParamSpec::required("Side", Kind::String, "The side to be cut, or a part made by an earlier list."),
      ParamSpec::required(
          "At", Kind::Doubles,
          "Increasing coordinates along the side, before the rotation; a grid line falls exactly on each."),
      ParamSpec::required("Names", Kind::Strings, "Names of the parts in increasing direction, one more than At."),
      ParamSpec::optional("Direction", Kind::String, boxDirections.range(),
                          "Direction in which At counts; by default the first in which the side extends.")};
  ListSpec spec;
  spec.name = "Splits";
  spec.doc = "Sides cut into named parts, one list each with any name.";
  spec.each = split;
  return spec;
}

ListSpec partsSpec()
{
  auto part = std::make_shared<ListSpec>();
  part->doc = "The cells between two corners, a group with the list's name. Parts may overlap.";
  part->params = {ParamSpec::required("Lower", Kind::Doubles,
                                      "Corner with the smallest coordinates, before the rotation; a grid line falls "
                                      "exactly on it."),
                  ParamSpec::required("Upper", Kind::Doubles, "Opposite corner: lengths.")};
  ListSpec spec;
  spec.name = "Parts";
  spec.doc = "Named groups of cells, one list each, for the Regions of a body.";
  spec.onlyIfGiven = true;
  spec.each = part;
  return spec;
}

} // namespace

void registerBox(Registry<MeshSource>& registry)
{
  addMeshSource(
      registry, "Box",
      "A rectangle or brick. Sides: left, right (x), bottom, top (y) in two dimensions; left, right (x), front, back "
      "(y), "
      "bottom, top (z) in three.",
      {ParamSpec::required("Lower", Kind::Doubles, "Corner with the smallest coordinates, two or three lengths."),
       ParamSpec::required("Upper", Kind::Doubles, "Opposite corner: lengths."),
       ParamSpec::required("Cells", Kind::Ints, "Bricks per direction."),
       ParamSpec::optional("Grading", Kind::Doubles,
                           "Length of the last brick over that of the first, per direction; bricks in between grow "
                           "geometrically. Without it all are equal."),
       {"Pattern", std::string("Right"), boxPatterns.range(),
        "How a brick is cut. Right: by parallel diagonals into 2 triangles or 6 tetrahedra (Kuhn). Alternating: by "
        "diagonals of changing direction into 2 triangles or 5 tetrahedra. Crossed: by both diagonals into 4 "
        "triangles."},
       {"Rotation", 0.0, "Angle in degrees by which the finished box is rotated about the origin (the z axis)."}},
      [](const Params& params) { return std::make_unique<Box>(params); },
      {sizesSpec(0), sizesSpec(1), sizesSpec(2), splitsSpec(), partsSpec()});
}

} // namespace ndframe
