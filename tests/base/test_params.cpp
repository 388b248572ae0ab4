#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/sample_spec.hpp"
#include "ndframe/base/deck.hpp"

using namespace ndframe;
using test::fullDeck;
using test::validated;

namespace
{

ListSpec numbersSpec()
{
  ListSpec spec;
  spec.params = {ParamSpec::required("Value", Kind::Double, "A number."),
                 ParamSpec::required("Values", Kind::Doubles, "Numbers.")};
  return spec;
}

} // namespace

TEST(EffectiveDeck, ReadsBackToTheSameParams)
{
  for (const auto& deck : {test::smallestDeck(), fullDeck()}) {
    const Params params = validated(deck);
    const Params again = validated(toXml(params));
    EXPECT_EQ(toJson(again), toJson(params));
    EXPECT_TRUE(again.teuchos() == params.teuchos());
    EXPECT_EQ(toXml(again), toXml(params));
  }
}

TEST(EffectiveDeck, KeepsEveryBitOfADouble)
{
  using limits = std::numeric_limits<double>;
  std::uint64_t state = 88172645463325252U; // xorshift64, any seed
  for (int i = 0; i < 1000; ++i) {
    state ^= state << 13U;
    state ^= state >> 7U;
    state ^= state << 17U;
    double value = 0.0;
    std::memcpy(&value, &state, sizeof value);
    if (!std::isfinite(value))
      continue;
    DeckList deck{"numbers", "deck.xml", 1, {}, {}};
    Diagnostics none;
    applySetting(deck, fmt::format("Value={:.17g}", value), none);
    applySetting(deck, fmt::format("Values={{{:.17g}, {}, {}}}", value, limits::max(), limits::min()), none);
    const Params params = validate(deck, numbersSpec(), none);
    ASSERT_TRUE(none.empty()) << none.list()[0].text();
    const Params again = validated(toXml(params), numbersSpec());
    EXPECT_EQ(params.get<double>("Value"), value);
    EXPECT_EQ(again.get<double>("Value"), value);
    EXPECT_EQ(again.get<std::vector<double>>("Values"), (std::vector<double>{value, limits::max(), limits::min()}));
  }
}

TEST(EffectiveDeck, IsIndentedXml)
{
  const std::string xml = toXml(validated(test::smallestDeck()));
  EXPECT_NE(xml.find("<ParameterList name=\"small\">\n  <Parameter name=\"Title\" type=\"string\" value=\"\"/>\n"),
            std::string::npos)
      << xml;
  EXPECT_NE(xml.find("\n      <ParameterList name=\"Material\">\n        <Parameter name=\"Type\""), std::string::npos)
      << xml;
}

TEST(EffectiveDeck, IsJsonWithTheSameShape)
{
  const auto json = nlohmann::json::parse(toJson(validated(fullDeck())));
  EXPECT_EQ(json["Title"], "Punch <&\"'> \u00e9");
  EXPECT_EQ(json["Grading"], (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(json["Bodies"]["upper"]["Material"]["Young Modulus"], 2.1e11);
  EXPECT_EQ(json["Bodies"]["lower"]["Parts"], nlohmann::json::array());
  EXPECT_EQ(json["Output"]["Exodus"], false);
  EXPECT_EQ(json["Coupling"]["Relaxation"]["History"]["Depth"], 3);
}

TEST(EffectiveDeck, IsATeuchosListWithTeuchosTypes)
{
  const Teuchos::ParameterList list = validated(fullDeck()).teuchos();
  EXPECT_EQ(list.name(), "full");
  EXPECT_EQ(list.get<std::string>("Gap"), "0.5*x^2");
  EXPECT_EQ(list.get<Teuchos::Array<double>>("Grading")[1], 2.0);
  EXPECT_EQ(list.sublist("Coupling").sublist("Stopping").get<double>("Tolerance"), 0.1);
  EXPECT_EQ(list.sublist("Library").get<int>("level"), 2);
}
