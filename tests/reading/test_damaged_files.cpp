#include <algorithm>
#include <cmath>
#include <random>

#include <exodusII.h>
#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "reading/mesh_files.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;

/// A damaged file is either refused by an InputError or read as a sound mesh; anything else is a failure of the test.
/// Returns true when it was refused.
bool isRefused(const std::string& type, const std::string& contents)
{
  try {
    const Mesh mesh = readMesh(text("Type", type) + text("File", scratchFile("damaged", contents)));
    EXPECT_TRUE(checkMesh(mesh).empty());
    return false;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("damaged: "), std::string::npos) << error.what();
    return true;
  }
}

void expectEveryTruncationIsRefused(const std::string& type, const std::string& contents, std::size_t needed,
                                    std::size_t step)
{
  for (std::size_t length = 0; length < needed; length += step)
    ASSERT_TRUE(isRefused(type, contents.substr(0, length))) << "cut to " << length << " of " << contents.size();
}

/// Overwrites one to three bytes; in an ASCII file by characters that occur in one.
void surviveMutations(const std::string& type, const std::string& contents, bool binary, int rounds)
{
  const std::string alphabet = "0123456789 .-e\n$x\"";
  std::mt19937 random(7);
  const auto upTo = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  for (int round = 0; round < rounds; ++round) {
    std::string damaged = contents;
    for (std::size_t k = 0; k <= upTo(3); ++k)
      damaged[upTo(damaged.size())] = binary ? char(upTo(256)) : alphabet[upTo(alphabet.size())];
    isRefused(type, damaged);
  }
}

std::string exodusFile(int format)
{
  const std::string path = scratchPath("sound.e");
  const Mesh mesh =
      readMesh(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "1, 1") + ints("Cells", "3, 3"));
  writeExodus(path, asExodusSample(mesh), format);
  return contentsOf(path);
}

class DamagedMsh : public testing::TestWithParam<const char*>
{};

TEST_P(DamagedMsh, TruncatedFilesAreRefused)
{
  const std::string contents = contentsOf(dataPath(GetParam()));
  // Without the last end of line the file is still whole.
  expectEveryTruncationIsRefused("Gmsh", contents, contents.size() - 1, contents.size() / 100);
}

TEST_P(DamagedMsh, MutatedFilesAreRefusedOrSound)
{
  const bool binary = std::string(GetParam()).find("binary") != std::string::npos;
  surviveMutations("Gmsh", contentsOf(dataPath(GetParam())), binary, 200);
}

INSTANTIATE_TEST_SUITE_P(All, DamagedMsh,
                         testing::Values("square-2.2-ascii.msh", "square-2.2-binary.msh", "square-4.1-ascii.msh",
                                         "square-4.1-binary.msh", "cube-4.1-binary.msh"));

class DamagedExodus : public testing::TestWithParam<int>
{};

TEST_P(DamagedExodus, TruncatedFilesAreRefused)
{
  const std::string contents = exodusFile(GetParam());
  expectEveryTruncationIsRefused("Exodus", contents, contents.size() - 3, contents.size() / 100);
}

/// Offset of the number of the dimension of a variable (of rank 1) in a classic header.
std::size_t dimensionOf(const std::string& contents, const std::string& variable)
{
  const std::size_t padded = (variable.size() + 3) / 4 * 4;
  return contents.find(std::string("\0\0\0", 3) + char(variable.size()) + variable) + 4 + padded + 4;
}

TEST(DamagedExodusHeader, ArraysOfAnotherLengthThanTheirDimensionAreRefused)
{
  const std::string contents = exodusFile(EX_LARGE_MODEL);
  const std::string longer = contents.substr(dimensionOf(contents, "elem_ss1"), 4);
  for (const char* variable : {"eb_prop1", "eb_status", "ss_prop1", "ss_status"}) {
    std::string damaged = contents;
    damaged.replace(dimensionOf(contents, variable), 4, longer);
    EXPECT_TRUE(isRefused("Exodus", damaged)) << variable;
  }
}

TEST_P(DamagedExodus, MutatedFilesAreRefusedOrSound)
{
  surviveMutations("Exodus", exodusFile(GetParam()), true, 200);
}

INSTANTIATE_TEST_SUITE_P(All, DamagedExodus, testing::Values(EX_NORMAL_MODEL, EX_LARGE_MODEL, EX_NETCDF4));

} // namespace
