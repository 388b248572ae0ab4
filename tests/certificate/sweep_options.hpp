#pragma once

#include <cstdint>
#include <string>

namespace ndframe::test
{

struct SweepOptions
{
  int scenes = 200;
  int first = 0; ///< the first scene's number: one scene again with --first N --scenes 1
  std::uint64_t seed = 1;
  std::string folder = "certificate-sweep"; ///< decks of violations, the table
  bool keep = false;                        ///< keep all decks
  bool sharpness = false;                   ///< measure effectivities instead of looking for violations
  bool needles = false;                     ///< scenes whose data are narrower than the mesh
  bool turning = false;                     ///< scenes whose sides are curved or kinked
  bool ownNormals = false;                  ///< Corner Angle = 0 in these
  int finest = 24;                          ///< cells a side of the sharpness scenes, at most
};

/// --scenes N --seed S --first N --folder F --keep --needles --sharpness --turning --own-normals --finest N. Anything
/// else ends the program with code 2.
SweepOptions readOptions(int argc, char** argv);

} // namespace ndframe::test
