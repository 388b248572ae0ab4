// Mesh/File = NAME.e.4: the mesh whose pieces NAME.e.4.0, ..., NAME.e.4.3 are.

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "meshing/mesh_deck.hpp"
#include "ndframe/io/exodus_pieces.hpp"
#include "reading/mesh_files.hpp"

namespace
{

using namespace ndframe;
using namespace ndframe::test;
using testing::HasSubstr;

std::string box(int dim)
{
  return text("Type", "Box") +
         (dim == 2 ? doubles("Lower", "0, 0") + doubles("Upper", "2, 1") + ints("Cells", "4, 3") +
                         list("Parts", list("core", doubles("Lower", "0, 0") + doubles("Upper", "0.5, 1")))
                   : doubles("Lower", "0, 0, 0") + doubles("Upper", "2, 1, 1") + ints("Cells", "3, 2, 2"));
}

std::string fromFile(const std::string& path)
{
  return text("Type", "Exodus") + text("File", path);
}

/// The pieces of a mesh and beside them the whole; returns the path of the whole.
std::string writeMesh(const Mesh& mesh, int pieces, const std::string& name = "pieces.e")
{
  const NodeMap nodes = makeNodeMap(mesh, 2);
  std::vector<ExodusBody> bodies{{"", &mesh, &nodes}};
  if (!mesh.groups.kind.empty()) {
    bodies.front().parts = {{"rest", {}}, {"core", {}}};
    for (int cell = 0; cell < mesh.numCells(); ++cell)
      bodies.front()
          .parts[mesh.groups.names[std::size_t(mesh.groups.kind[std::size_t(cell)])].empty() ? 0 : 1]
          .cells.push_back(cell);
  }
  const std::string path = scratchPath(name);
  ndframe::writeExodus(path, "mesh", bodies, {}, {}, {});
  const ExodusSharing sharing = shareCells(bodies, pieces);
  for (int piece = 0; piece < pieces; ++piece)
    writeExodusPiece(pieceName(path, pieces, piece), "mesh", bodies, {}, {}, {}, sharing, piece);
  return path;
}

void removePieces(const std::string& path)
{
  for (const std::string& piece : piecesBeside(path))
    std::filesystem::remove(piece);
}

} // namespace

TEST(PiecesMeant, AreThoseOfANameWithANumber)
{
  EXPECT_THAT(piecesMeant("out/a.e.3"), testing::ElementsAre("out/a.e.3.0", "out/a.e.3.1", "out/a.e.3.2"));
  EXPECT_EQ(piecesMeant("a.e.12").back(), "a.e.12.11");
  for (const char* name : {"a.e", "a", "", "a.e.0", "a.e.-1", "a.e.", "a.e.3x", "a.e.99999999999", "a.e.2000000"})
    EXPECT_TRUE(piecesMeant(name).empty()) << name;
}

TEST(ExodusPieces, AreTheWholeTogether)
{
  const int pieces = 5;
  const std::string path = writeMesh(readMesh(box(3)), pieces);
  const auto source = meshSource(fromFile(path + "." + std::to_string(pieces)));
  ASSERT_EQ(source->numPieces(), pieces);
  EXPECT_EQ(meshSource(fromFile(path))->numPieces(), 0);
  std::vector<NumberedMesh> parts;
  for (const auto& [first, last] : {std::pair(0, 1), {1, 4}, {4, 5}})
    parts.push_back(source->readPieces(first, last));
  NumberedMesh whole = joined(parts);
  Mesh expected = source->read();
  expected.groups = {}; // which joined() drops
  expectSameMesh(whole.mesh, expected);
  for (int point = 0; point < whole.mesh.numPoints(); ++point)
    EXPECT_EQ(whole.points[std::size_t(point)], point + 1);
  for (int cell = 0; cell < whole.mesh.numCells(); ++cell)
    EXPECT_EQ(whole.cells[std::size_t(cell)], cell + 1);
  removePieces(path);
}

TEST(ExodusPieces, AreReadAsTheWhole)
{
  for (const int dim : {2, 3})
    for (const int pieces : {1, 2, 5, 12}) {
      const std::string path = writeMesh(readMesh(box(dim)), pieces);
      const Mesh whole = readMesh(fromFile(path)), joined = readMesh(fromFile(path + "." + std::to_string(pieces)));
      expectSameMesh(joined, whole);
      EXPECT_EQ(joined.groups.names, whole.groups.names);
      EXPECT_EQ(joined.groups.kind, whole.groups.kind);
      removePieces(path);
    }
}

TEST(ExodusPieces, CanBeRefinedAndChosenByBlocks)
{
  const std::string path = writeMesh(readMesh(box(2)), 3), more = strings("Blocks", "core") + integer("Refine", "1");
  expectSameMesh(readMesh(fromFile(path + ".3") + more), readMesh(fromFile(path) + more));
  removePieces(path);
}

TEST(ExodusPieces, OfWhichOneIsMissingAreRefusedWithItsName)
{
  const std::string path = writeMesh(readMesh(box(2)), 3);
  std::filesystem::remove(path + ".3.1");
  EXPECT_THAT(messageOf(fromFile(path + ".3")),
              HasSubstr("the piece " + path + ".3.1 is missing; all 3 must be in one folder."));
  removePieces(path);
  EXPECT_THAT(messageOf(fromFile(path + ".3")), HasSubstr(path + ".3: ")); // as for any file that is not there
}

TEST(ExodusPieces, OfDifferentMeshesAreRefused)
{
  const std::string plane = writeMesh(readMesh(box(2)), 2), other = writeMesh(readMesh(box(3)), 2, "other.e");
  const std::string moved = writeMesh(
      readMesh(text("Type", "Box") + doubles("Lower", "0, 0") + doubles("Upper", "9, 1") + ints("Cells", "4, 3")), 2,
      "moved.e");
  const auto exchange = [&](const std::string& from, int piece) {
    std::filesystem::copy_file(pieceName(from, 2, piece), pieceName(plane, 2, 1),
                               std::filesystem::copy_options::overwrite_existing);
    return messageOf(fromFile(plane + ".2"));
  };
  EXPECT_THAT(exchange(other, 1), HasSubstr("they are no pieces of one mesh."));
  EXPECT_THAT(exchange(moved, 1), HasSubstr("they are no pieces of one mesh."));
  EXPECT_THAT(exchange(plane, 0), testing::AllOf(HasSubstr("is in " + plane + ".2.0 and in " + plane + ".2.1"),
                                                 HasSubstr("they are no pieces")));
  for (const std::string& path : {plane, other, moved})
    removePieces(path);
}

TEST(ExodusPieces, WithADamagedOneAreRefused)
{
  const std::string path = writeMesh(readMesh(box(2)), 2);
  std::filesystem::resize_file(path + ".2.1", std::filesystem::file_size(path + ".2.1") / 2);
  EXPECT_THAT(messageOf(fromFile(path + ".2")), HasSubstr(path + ".2"));
  removePieces(path);
}
