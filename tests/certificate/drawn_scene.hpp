#pragma once

#include <map>
#include <optional>
#include <string>

#include "certificate/deck_text.hpp"
#include "certificate/draw.hpp"
#include "certificate/grid_mesh.hpp"

namespace ndframe::test
{

/// The resultant of the first body's loads along its last axis, in closed form, and that of their absolute values.
struct ExpectedLoad
{
  double resultant = 0.0, size = 0.0;
};

/// A deck, its mesh files, and the words under which its results are grouped.
struct DrawnScene
{
  explicit DrawnScene(const std::string& name) : deck(name) {}

  DeckText deck;
  std::map<std::string, std::string> files; ///< contents by name, in the deck's folder
  std::string kind;
  std::optional<ExpectedLoad> load;
};

/// How all bodies of a scene are meshed.
struct MeshStyle
{
  bool random = false; ///< random diagonals and vertices, from a file; else a Box
  std::string pattern; ///< of a Box
  double grading = 1.0;
  std::string word;
};

MeshStyle drawMeshStyle(Draw& draw);

/// Bodies/BODY/Mesh. `lift`: of random meshes. Boxes take equal cells, graded upwards.
void drawMesh(DrawnScene& scene, const std::string& body, const Rectangle& rectangle, const MeshStyle& style,
              const std::function<double(double)>& lift, const Frame& frame, Draw& draw);

/// Bodies/BODY/Material of about this stiffness: isotropic or orthotropic, nu from 0 to 0.4999.
void drawMaterial(DrawnScene& scene, const std::string& body, double stiffness, const std::string& hypothesis,
                  Draw& draw);

/// A function of X and Y between about -1 and 1: constant, linear, quadratic, sine.
std::string drawField(Draw& draw);
/// The same without a sign change: between 0.1 and 1.
std::string drawPressure(Draw& draw);

/// Discretization and Error Estimation.
void drawCertificate(DrawnScene& scene, int dim, bool touches, Draw& draw);

/// Two bodies in contact.
DrawnScene drawContactScene(Draw& draw);
/// Two bodies whose sides are curved or kinked, without iteration between them.
DrawnScene drawTurningScene(std::uint64_t seed, int index);
/// One body, dim 2 or 3.
DrawnScene drawLinearScene(int dim, Draw& draw);

/// Scene `index` of a sweep.
DrawnScene drawScene(std::uint64_t seed, int index);

/// Scene `index` of the sweep for data narrower than the mesh: as pressure, traction, body force, gap and prescribed
/// displacement; two bodies, one body, one in space; some with a target.
DrawnScene drawNeedleScene(std::uint64_t seed, int index);

} // namespace ndframe::test
