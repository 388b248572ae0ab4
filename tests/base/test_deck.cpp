#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/sample_spec.hpp"
#include "ndframe/base/deck.hpp"

using namespace ndframe;
using testing::HasSubstr;

namespace
{

std::string readingError(const std::string& path)
{
  try {
    readDeck(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// A file in the tests' temporary folder, removed at the end of the test.
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string& content)
      : path_(testing::TempDir() + "deck-" + std::to_string(getpid()) + ".xml")
  {
    std::ofstream(path_, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

private:
  std::string path_;
};

} // namespace

TEST(Deck, RemembersNamesTypesValuesAndLines)
{
  const DeckList deck = parseDeck(test::fullDeck(), "deck.xml");
  EXPECT_EQ(deck.name, "full");
  EXPECT_EQ(deck.line, 3);
  const DeckEntry* gap = deck.findEntry("Gap");
  ASSERT_NE(gap, nullptr);
  EXPECT_EQ(gap->type, "string");
  EXPECT_EQ(gap->value, "0.5*x^2");
  EXPECT_EQ(gap->line, 8);
  EXPECT_EQ(gap->file, "deck.xml");
  const DeckList* bodies = deck.findList("Bodies");
  ASSERT_NE(bodies, nullptr);
  EXPECT_EQ(bodies->line, 9);
  ASSERT_EQ(bodies->lists.size(), 2U);
  EXPECT_EQ(bodies->lists[0].name, "upper");
  EXPECT_EQ(bodies->lists[1].name, "lower");
  EXPECT_EQ(deck.findList("Material"), nullptr);
  EXPECT_EQ(deck.findEntry("Bodies"), nullptr);
}

TEST(Deck, DecodesTheFivePredefinedEntitiesAndCharacterReferences)
{
  const DeckList deck = parseDeck(test::fullDeck(), "deck.xml");
  EXPECT_EQ(deck.findEntry("Title")->value, "Punch <&\"'> \u00e9");
}

TEST(Deck, AcceptsTheAttributesThatTeuchosWrites)
{
  const DeckList deck = parseDeck(R"(<ParameterList name="ANONYMOUS">
    <Parameter docString="d" id="0" isDefault="false" isUsed="true" name="a" type="int" value="1"/>
    <ParameterList id="1" name="b"/>
  </ParameterList>)",
                                  "deck.xml");
  EXPECT_EQ(deck.findEntry("a")->value, "1");
  EXPECT_NE(deck.findList("b"), nullptr);
}

TEST(Deck, ReadsWindowsLineEndsAndAByteOrderMark)
{
  const DeckList deck = parseDeck(
      "\xEF\xBB\xBF<ParameterList>\r\n<Parameter name=\"a\" type=\"int\" value=\"1\"/>\r\n</ParameterList>\r\n", "d");
  EXPECT_EQ(deck.name, "");
  EXPECT_EQ(deck.findEntry("a")->line, 2);
}

TEST(Deck, IsReadFromAFile)
{
  const TemporaryFile file(test::fullDeck());
  const DeckList deck = readDeck(file.path());
  EXPECT_EQ(deck.file, file.path());
  EXPECT_EQ(deck.lists.size(), 4U);
}

TEST(Deck, ThatDoesNotExistIsNamed)
{
  EXPECT_EQ(readingError("no/such.xml"), "no/such.xml: cannot be opened: No such file or directory.");
}

TEST(Deck, ThatIsADirectoryIsRefused)
{
  EXPECT_THAT(readingError(testing::TempDir()), HasSubstr("is a directory, not a deck."));
}

TEST(Deck, ThatIsEmptyIsRefused)
{
  const TemporaryFile file(" \n\t\n");
  EXPECT_EQ(readingError(file.path()), file.path() + ":1: is empty; a deck is one <ParameterList> in XML.");
}

TEST(Deck, ThatIsNoRegularFileIsRefused)
{
  const std::string pipe = testing::TempDir() + "deck-pipe-" + std::to_string(getpid());
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0); // nobody will ever write
  EXPECT_EQ(readingError(pipe), pipe + ": is not a regular file.");
  std::filesystem::remove(pipe);
  EXPECT_EQ(readingError("/dev/zero"), "/dev/zero: is not a regular file.");
}

TEST(Deck, ThatIsLargeIsRefused)
{
  const TemporaryFile file(std::string(std::size_t(5) << 20, ' '));
  EXPECT_THAT(readingError(file.path()), HasSubstr("is larger than 4 MB"));
}

TEST(Deck, ThatIsAnotherProgramsBinaryIsRefused)
{
  const TemporaryFile file(std::string("CDF\x01\0\0\0\x05", 8));
  EXPECT_EQ(readingError(file.path()), file.path() + ":1: is not UTF-8 text: byte 0x01; save the deck as UTF-8.");
}

TEST(Deck, InAnotherEncodingIsRefusedWithItsLine)
{
  EXPECT_EQ(test::complaint("<ParameterList>\n<!-- caf\xE9 -->\n</ParameterList>"),
            "deck.xml:2: is not UTF-8 text: byte 0xE9; save the deck as UTF-8.");
}
