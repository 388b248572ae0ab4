// Wrong input through the program: the whole message and exit code 2. The cases stand in wrong_decks.json:
//
//   deck      the shipped deck that is made wrong (or `text`, the deck itself),
//   edits     texts of the deck replaced by others,
//   settings  for --set,
//   message   what stands on the error stream, line by line, without the closing count. A line number of the deck is
//             written as {the text of that line}.

#include <filesystem>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "driver/program.hpp"
#include "driver/scene.hpp"
#include "io/temporary_folder.hpp"

using namespace ndframe;
using namespace ndframe::test;
using Json = nlohmann::json;

namespace
{

const Json& cases()
{
  static const Json all = Json::parse(contentsOf(NDFRAME_WRONG_DECKS));
  return all;
}

std::string caseName(const testing::TestParamInfo<std::size_t>& info)
{
  return cases()[info.param]["name"];
}

std::string deckOf(const Json& wrong)
{
  if (wrong.contains("text"))
    return wrong["text"];
  std::string deck = contentsOf(shippedDeck(wrong["deck"]));
  for (const auto& edit : wrong.value("edits", Json::array()))
    deck = replacedOnce(deck, edit[0], edit[1]);
  return deck;
}

/// Damaged mesh files beside the shipped ones.
void writeMeshes(const TemporaryFolder& folder)
{
  const std::string meshes = std::string(NDFRAME_DECKS) + "/meshes";
  std::filesystem::create_directory_symlink(meshes, folder.file("meshes"));
  const std::string msh = contentsOf(meshes + "/punch-foundation-2.2.msh");
  writeFile(folder.file("truncated.msh"), msh.substr(0, msh.size() * 2 / 3));
  writeFile(folder.file("corrupt.msh"), replacedOnce(msh, "0.1425726359385743 0 0", "0.14x5726359385743 0 0"));
  writeFile(folder.file("no-elements.msh"), msh.substr(0, msh.find("$Elements")) + "$Elements\n0\n$EndElements\n");
  writeFile(folder.file("empty.msh"), "");
  static const std::regex triangle(R"((\n\d+ 2 2 7 \d+ \d+) (\d+) (\d+))");
  writeFile(folder.file("inverted.msh"),
            std::regex_replace(msh, triangle, "$1 $3 $2", std::regex_constants::format_first_only));
  writeFile(folder.file("bent.msh"), replacedOnce(msh, "\n7 2 -1 0\n", "\n7 2 -1.2 0\n"));
  const std::string exodus = contentsOf(meshes + "/punch-foundation.e");
  writeFile(folder.file("truncated.e"), exodus.substr(0, exodus.size() / 2));
  writeFile(folder.file("corrupt.e"), std::string(exodus).replace(30, 8, std::string(8, '\xff')));
  writeFile(folder.file("wrong.geo"), "Point(1) = {0, 0;\n");
}

std::string trimmed(const std::string& line)
{
  const auto first = line.find_first_not_of(' ');
  return first == std::string::npos ? "" : line.substr(first);
}

/// "deck.xml:41: ..." becomes "deck.xml:{text of line 41}: ...".
std::string withLinesQuoted(const std::string& message, const std::string& deck)
{
  std::vector<std::string> lines;
  std::istringstream text(deck);
  for (std::string line; std::getline(text, line);)
    lines.push_back(trimmed(line));
  static const std::regex place(R"((deck\.xml:|first in line )(\d+))");
  std::string result;
  auto rest = message.begin();
  for (std::sregex_iterator match(message.begin(), message.end(), place), end; match != end; ++match) {
    result.append(rest, (*match)[0].first);
    result += (*match)[1].str() + "{" + lines.at(std::stoul((*match)[2]) - 1) + "}";
    rest = (*match)[0].second;
  }
  return result.append(rest, message.end());
}

class WrongInput : public testing::TestWithParam<std::size_t>
{};

} // namespace

TEST_P(WrongInput, IsAnsweredWithPlaceReasonAndRemedy)
{
  const Json& wrong = cases()[GetParam()];
  const TemporaryFolder folder;
  writeMeshes(folder);
  const std::string deck = deckOf(wrong);
  writeFile(folder.file("deck.xml"), deck);
  const auto filesBefore = filesIn(folder.file("."));
  std::vector<std::string> arguments{"-q", "-i", "deck.xml"};
  for (const auto& setting : wrong.value("settings", Json::array()))
    arguments.insert(arguments.end(), {"--set", setting});
  std::string expected;
  for (const auto& line : wrong["message"])
    expected += line.get<std::string>() + "\n";
  const auto count = wrong["message"].size();
  expected += fmt::format("{} error{}; nothing was computed.\n", count, count == 1 ? "" : "s");

  const auto run = runProgram(arguments, folder.file("."));
  EXPECT_EQ(withLinesQuoted(run.err, deck), expected);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.exitCode, 2);
  EXPECT_EQ(filesIn(folder.file(".")), filesBefore);

  arguments.push_back("--check");
  const auto check = runProgram(arguments, folder.file("."));
  EXPECT_EQ(check.err, run.err);
  EXPECT_EQ(check.exitCode, 2);
}

INSTANTIATE_TEST_SUITE_P(Cases, WrongInput, testing::Range(std::size_t(0), cases().size()), caseName);
