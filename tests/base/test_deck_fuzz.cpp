#include <random>

#include <gtest/gtest.h>

#include "base/sample_spec.hpp"
#include "ndframe/base/diagnostics.hpp"

using namespace ndframe;

namespace
{

/// Changes a text the way slips and broken disks do: letters, cuts, doublings, moved pieces, markup in odd places.
class Mutator
{
public:
  std::string operator()(std::string text)
  {
    for (int changes = below(2); changes >= 0; --changes)
      change(text);
    return text;
  }

private:
  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
  std::size_t placeIn(const std::string& text)
  {
    return static_cast<std::size_t>(below(static_cast<int>(text.size()) + 1));
  }

  void change(std::string& text)
  {
    static const std::vector<std::string> pieces{"<",         ">",
                                                 "\"",        "/>",
                                                 "&#0;",      "&#xD800;",
                                                 "<!--",      "<![CDATA[",
                                                 "{",         "nan",
                                                 "1e999",     "\xFF",
                                                 "/",         "=",
                                                 "<!DOCTYPE", "</ParameterList>",
                                                 "type",      "<ParameterList name=\"a\">"};
    const std::size_t at = placeIn(text);
    const std::size_t length = std::min<std::size_t>(static_cast<std::size_t>(below(60)), text.size() - at);
    switch (below(6)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(placeIn(text), text.substr(at, length));
      break;
    case 2:
      text.insert(at, pieces[static_cast<std::size_t>(below(static_cast<int>(pieces.size())))]);
      break;
    case 3:
      replaceDigit(text, at);
      break;
    case 4:
      text.resize(at);
      break;
    default:
      text.insert(at, 1, static_cast<char>(below(256)));
    }
  }

  void replaceDigit(std::string& text, std::size_t from)
  {
    const auto at = text.find_first_of("0123456789", from);
    if (at != std::string::npos)
      text[at] = static_cast<char>('0' + below(10));
  }

  std::mt19937 random_{20240607}; // any seed; fixed, so that a failure can be repeated
};

} // namespace

TEST(DeckFuzz, EveryMutatedDeckIsReadOrAnsweredWithAnInputError)
{
  Mutator mutated;
  int right = 0;
  int wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::string deck = mutated(i % 2 == 0 ? test::fullDeck() : test::smallestDeck());
    try {
      const Params params = test::validated(deck);
      EXPECT_EQ(toJson(test::validated(toXml(params))), toJson(params)) << deck;
      ++right;
    } catch (const InputError& error) {
      EXPECT_FALSE(error.list().empty());
      ++wrong;
    }
  }
  // The mutations are neither harmless nor hopeless.
  EXPECT_GT(right, 100);
  EXPECT_GT(wrong, 1000);
}

TEST(DeckFuzz, TextThatIsNoDeckIsAnsweredWithAnInputError)
{
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string text(random() % 200, '\0');
    for (auto& c : text)
      c = static_cast<char>(random() % 256);
    EXPECT_THROW(test::validated(text), InputError);
  }
}
