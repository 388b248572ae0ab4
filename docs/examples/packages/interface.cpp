// Finds which points of two sides that were meshed independently face each other, and cuts the meshes to match.
#include <cmath>

#include "ndframe/interface/insertion.hpp"
#include "ndframe/interface/interface_mesh.hpp"

using namespace ndframe;

/// Triangles between the vertices of the side "contact", at these places on y = 0, and one point at the height y.
Mesh fan(const std::vector<double>& x, double y)
{
  Mesh mesh;
  mesh.dim = 2;
  mesh.points = {0.5, y};
  mesh.sides = {{"contact", {}}};
  for (std::size_t i = 0; i < x.size(); ++i) {
    mesh.points.insert(mesh.points.end(), {x[i], 0.0});
    if (i > 0) {
      const int left = int(i), right = int(i) + 1;
      mesh.sides[0].facets.push_back({mesh.numCells(), 0}); // opposite to the first vertex
      mesh.cells.insert(mesh.cells.end(), {0, y > 0.0 ? left : right, y > 0.0 ? right : left});
    }
  }
  return mesh;
}

int main()
{
  const std::vector<Mesh> meshes{fan({0.0, 0.5, 1.0}, 1.0), fan({0.0, 0.3, 0.65, 1.0}, -1.0)};
  const double cornerAngle = 35.0;
  const auto polygon = [&](const Mesh& mesh) { return SidePolygon(mesh, mesh.sides[0].facets, cornerAngle); };
  const auto map = std::make_shared<const SideMap>(polygon(meshes[0]), polygon(meshes[1]));
  bool ok = map->segments().size() == 1 && map->touches(); // the same straight line
  ok = ok && !sidesMatch(meshes[0], meshes[0].sides[0], meshes[1], meshes[1].sides[0]);

  const std::vector<DerivedMesh> cut = insertion(meshes, {{0, 1, "contact", "contact", map}});
  const Mesh &upper = cut[0].mesh, &lower = cut[1].mesh;
  ok = ok && checkMesh(upper).empty() && checkMesh(lower).empty();
  ok = ok && sidesMatch(upper, upper.sides[0], lower, lower.sides[0]);
  const auto pieces = facingPieces(*map, upper, upper.sides[0].facets, lower, lower.sides[0].facets);
  ok = ok && pieces.size() == 4 && upper.sides[0].facets.size() == 4; // cut at 0.3, 0.5 and 0.65
  for (const FacingPiece& piece : pieces)                             // pieces are whole facets on both sides now
    ok = ok && std::abs(std::abs(piece.onFirst[1] - piece.onFirst[0]) - 1.0) < 1e-14 &&
         std::abs(std::abs(piece.onSecond[1] - piece.onSecond[0]) - 1.0) < 1e-14;
  return ok ? 0 : 1;
}
