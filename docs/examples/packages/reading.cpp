// Reads the text of a .msh file: a square of two triangles, whose lower edge is a side.
#include <cmath>
#include <string>

#include "ndframe/reading/file_error.hpp"
#include "ndframe/reading/gmsh_converter.hpp"

int main()
{
  using namespace ndframe;
  const std::string square = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 5 "bottom"
2 6 "plate"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
$EndNodes
$Elements
3
1 1 2 5 0 1 2
2 2 2 6 0 1 2 3
3 2 2 6 0 1 3 4
$EndElements
)";
  const Mesh mesh = meshFromMsh(parseMsh(square), {"plate"});
  const double area = cellMeasure(mesh, 0) + cellMeasure(mesh, 1);
  const bool isRead =
      mesh.numCells() == 2 && mesh.findSide("bottom")->facets.size() == 1 && std::abs(area - 1.0) < 1e-15;

  try {
    parseMsh(square.substr(0, square.size() / 2)); // half of the file
    return 1;
  } catch (const FileError&) {
    return isRead ? 0 : 1;
  }
}
