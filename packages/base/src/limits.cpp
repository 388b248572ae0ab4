#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "help_search.hpp"
#include "ndframe/base/help.hpp"
#include "text.hpp"

namespace ndframe
{

namespace
{

struct Limit
{
  std::vector<std::string_view> words; ///< in lower case; what a user may ask for
  std::string_view instead;
};

const std::array<Limit, 11>& limits()
{
  static const std::array<Limit, 11> all{{
      {{"friction", "coulomb", "stick", "slip", "frictional"},
       "Tied in an interface glues two sides in normal and tangential direction"},
      {{"adhesion", "cohesion", "glue"}, "Tied in an interface; contact forces never pull"},
      {{"wear", "lubrication", "fluid"}, "a Gap as an expression stands for a worn side"},
      {{"plasticity", "creep", "damage", "rubber", "hyperelastic", "nonlinear"},
       "materials are linear elastic: `ndframe --help Material`"},
      {{"buckling", "large displacements", "large rotations", "finite strain", "nlgeom"},
       "strains above Strain Limit get a warning; contact is enforced in the drawn configuration"},
      {{"dynamics", "vibration", "impact", "modal", "eigenvalues", "frequency"}, "one static state"},
      {{"time steps", "load steps", "transient"},
       "Load Cases solves a list of states in one process, each independently: `ndframe --help \"Load Cases\"`"},
      {{"temperature", "thermal", "heat"},
       "a Gap, a Displacement support or a rigid body's Displacement in place of the expansion"},
      {{"axisymmetry", "axisymmetric"}, "a quarter of the solid with two rollers"},
      {{"shells", "beams", "springs", "bolts", "trusses", "plates", "membranes", "shell", "spring", "bolt", "truss"},
       "bodies are meshes of triangles or tetrahedra; decks/flange.xml has a bolt as a body, preloaded by a prescribed "
       "displacement"},
      {{"gpu", "cuda"}, "threads and processes: OMP_NUM_THREADS, mpirun"},
  }};
  return all;
}

} // namespace

std::vector<std::string> limitWords()
{
  std::vector<std::string> all;
  for (const Limit& limit : limits())
    all.insert(all.end(), limit.words.begin(), limit.words.end());
  return all;
}

std::string limitOf(const std::string& words)
{
  const std::string low = lowered(words);
  std::vector<std::string> parts = split(low, " ");
  parts.push_back(low);
  for (const Limit& limit : limits())
    for (const auto word : limit.words)
      if (std::find(parts.begin(), parts.end(), word) != parts.end())
        return fmt::format("not in this version; nearest: {}.", limit.instead);
  return {};
}

} // namespace ndframe
