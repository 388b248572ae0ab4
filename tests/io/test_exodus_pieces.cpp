#include "ndframe/io/exodus_pieces.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include "io/sample_meshes.hpp"
#include "io/temporary_folder.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/io/atomic_file.hpp"

// That pieces are the whole is read with netCDF in read_back.py; here: who gets what, and names.

using namespace ndframe;
using ndframe::test::sampleMesh;
using ndframe::test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace
{

struct TwoBodies
{
  Mesh first = sampleMesh(2, 0.0), second = sampleMesh(2, 1.0);
  NodeMap firstNodes = makeNodeMap(first, 2), secondNodes = makeNodeMap(second, 1);
  std::vector<ExodusBody> bodies{{"first", &first, &firstNodes}, {"second", &second, &secondNodes}};
};

int numCellsOf(const ExodusSharing& sharing, int piece)
{
  int cells = 0;
  for (const auto& owners : sharing.owner)
    cells += int(std::count(owners.begin(), owners.end(), piece));
  return cells;
}

void touch(const std::string& path)
{
  writeTextAtomically(path, "something");
}

} // namespace

TEST(ShareCells, GivesEveryPieceACell)
{
  const TwoBodies two;
  for (int pieces = 1; pieces <= 8; ++pieces) {
    const ExodusSharing sharing = shareCells(two.bodies, pieces);
    int all = 0;
    for (int piece = 0; piece < pieces; ++piece) {
      EXPECT_GT(numCellsOf(sharing, piece), 0) << piece << " of " << pieces;
      all += numCellsOf(sharing, piece);
    }
    EXPECT_EQ(all, 8);
  }
}

TEST(CellsOfPieces, GivesACellToThePieceOfItsLowestVertexAndPerhapsNothingToAnother)
{
  const TwoBodies two;
  std::vector<std::vector<int>> pieces;
  for (const ExodusBody& body : two.bodies)
    pieces.emplace_back(std::size_t(body.mesh->numPoints()), 3);
  pieces[0][std::size_t(two.first.cell(0)[0])] = 1;
  const ExodusSharing sharing = cellsOfPieces(two.bodies, 5, pieces);
  EXPECT_EQ(sharing.pieces, 5);
  EXPECT_EQ(numCellsOf(sharing, 1) + numCellsOf(sharing, 3), 8);
  for (int cell = 0; cell < two.first.numCells(); ++cell) {
    const int lowest = *std::min_element(two.first.cell(cell), two.first.cell(cell) + 3);
    EXPECT_EQ(sharing.owner[0][std::size_t(cell)], pieces[0][std::size_t(lowest)]);
  }
}

TEST(ShareCells, RefusesMorePiecesThanCells)
{
  const TwoBodies two;
  EXPECT_THROW(shareCells(two.bodies, 9), InternalError);
}

TEST(PieceName, HasAsManyDigitsAsTheNumberOfPieces)
{
  EXPECT_EQ(pieceName("a.e", 1, 0), "a.e.1.0");
  EXPECT_EQ(pieceName("a.e", 9, 8), "a.e.9.8");
  EXPECT_EQ(pieceName("a.e", 16, 3), "a.e.16.03");
  EXPECT_EQ(pieceName("out/a.e", 1000, 42), "out/a.e.1000.0042");
}

TEST(PiecesBeside, FindsPiecesOfThisFileOnly)
{
  const TemporaryFolder folder;
  for (const char* name : {"a.e.2.0", "a.e.2.1", "a.e.10.09", "a.e", "a.e.2.2", "a.e.2.01", "a.e.10.9", "b.e.2.0",
                           "a.e.2.", "a.e.2.0.bak", "a.e.-2.0", "a.e.2", "a.e.99999999999.00000000000", "xa.e.2.0"})
    touch(folder.file(name));
  EXPECT_THAT(piecesBeside(folder.file("a.e")),
              ElementsAre(folder.file("a.e.10.09"), folder.file("a.e.2.0"), folder.file("a.e.2.1")));
  EXPECT_THAT(piecesBeside(folder.file("no/a.e")), ElementsAre());
}

TEST(ExodusPiece, WithoutAFolderIsRefusedWithTheReason)
{
  const TemporaryFolder folder;
  const TwoBodies two;
  const ExodusSharing sharing = shareCells(two.bodies, 2);
  const auto write = [&](const std::string& path) {
    writeExodusPiece(path, "title", two.bodies, {}, {}, {}, sharing, 1);
  };
  EXPECT_GT(writeAtomically(folder.file("a.e.2.1"), write), 0);
  EXPECT_THAT([&] { write(folder.file("no/a.e.2.1")); }, ThrowsMessage<std::runtime_error>(HasSubstr("the file")));
}

TEST(PendingFile, AppearsWhenItIsKept)
{
  const TemporaryFolder folder;
  PendingFile file(folder.file("a"), [](const std::string& path) { touch(path); });
  EXPECT_EQ(file.bytes(), 9);
  EXPECT_EQ(folder.numEntries(), 1); // the temporary one
  file.keep();
  EXPECT_EQ(folder.numEntries(), 1);
  EXPECT_THROW(file.keep(), InputError); // there is nothing to rename any more
}

TEST(PendingFile, LeavesNothingWhenItIsNotKept)
{
  const TemporaryFolder folder;
  touch(folder.file("a"));
  {
    const PendingFile file(folder.file("a"), [](const std::string& path) { writeTextAtomically(path, "other"); });
    EXPECT_EQ(folder.numEntries(), 2);
  }
  EXPECT_EQ(folder.numEntries(), 1);
}
