#include "fuzz/mutator.hpp"

#include <algorithm>
#include <array>

namespace ndframe::test
{

namespace
{

bool isNumberPart(char c)
{
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e';
}

const std::vector<std::string>& tokens()
{
  static const std::vector<std::string> list{"<",
                                             ">",
                                             "\"",
                                             "/>",
                                             "&#0;",
                                             "&#xD800;",
                                             "<!--",
                                             "<![CDATA[",
                                             "{",
                                             "}",
                                             "((((((((",
                                             "/",
                                             "=",
                                             ",",
                                             "<!DOCTYPE",
                                             "</ParameterList>",
                                             "<ParameterList name=\"a\">",
                                             "<Parameter name=\"a\" type=\"double\" value=\"1\"/>",
                                             "Array(double)",
                                             "\n$EndNodes\n",
                                             "\n$Elements\n",
                                             "\n$Nodes\n",
                                             std::string(1, '\0'),
                                             "\xFF",
                                             "\xC3\xA4",
                                             std::string(3000, 'x')};
  return list;
}

} // namespace

Mutator::Mutator(std::vector<std::string> sound, bool text, std::uint64_t seed)
    : sound_(std::move(sound)), text_(text), seed_(seed)
{}

std::string Mutator::operator()(std::uint64_t n)
{
  static constexpr std::array<Change, 10> changes{
      &Mutator::flipBit, &Mutator::setByte, &Mutator::removePiece,   &Mutator::repeatPiece, &Mutator::movePiece,
      &Mutator::splice,  &Mutator::cutOff,  &Mutator::extremeNumber, &Mutator::extremeWord, &Mutator::insertToken};
  std::seed_seq seeds{seed_, n};
  random_.seed(seeds);
  std::string data = anySound();
  for (std::size_t k = below(4) + 1; k > 0 && !data.empty(); --k) {
    const std::size_t kind = below(changes.size() + 2);
    // Numbers are where files go wrong most.
    (this->*(kind < changes.size() ? changes[kind] : text_ ? &Mutator::extremeNumber : &Mutator::extremeWord))(data);
  }
  return data;
}

std::pair<std::size_t, std::size_t> Mutator::piece(const std::string& data)
{
  std::size_t begin = below(data.size());
  std::size_t end = begin + below(200);
  if (text_) {
    begin = data.rfind('\n', begin) + 1; // npos + 1 is the beginning
    end = data.find('\n', end);
    end = end == std::string::npos ? data.size() : end + 1;
  } else {
    begin = begin / 4 * 4;
    end = (end + 3) / 4 * 4;
  }
  end = std::min(end, data.size());
  return {std::min(begin, end), end};
}

void Mutator::flipBit(std::string& data)
{
  char& c = data[below(data.size())];
  c = char(static_cast<unsigned char>(c) ^ (1U << below(8)));
}

void Mutator::setByte(std::string& data)
{
  data[below(data.size())] = text_ && below(4) > 0 ? char(' ' + below(95)) : char(below(256));
}

void Mutator::removePiece(std::string& data)
{
  const auto [begin, end] = piece(data);
  data.erase(begin, end - begin);
}

void Mutator::repeatPiece(std::string& data)
{
  const auto [begin, end] = piece(data);
  const std::string copy = data.substr(begin, end - begin);
  for (std::size_t k = below(3) + 1; k > 0; --k)
    data.insert(end, copy);
}

void Mutator::movePiece(std::string& data)
{
  const auto [begin, end] = piece(data);
  const std::string moved = data.substr(begin, end - begin);
  data.erase(begin, end - begin);
  data.insert(data.empty() ? 0 : piece(data).first, moved);
}

void Mutator::splice(std::string& data)
{
  const std::string& other = anySound();
  const auto [begin, end] = piece(other);
  data.insert(piece(data).first, other, begin, end - begin);
}

void Mutator::cutOff(std::string& data)
{
  data.resize(below(data.size()));
}

void Mutator::extremeNumber(std::string& data)
{
  static const std::vector<std::string> numbers{"0",
                                                "-1",
                                                "1",
                                                "2147483647",
                                                "2147483648",
                                                "-2147483648",
                                                "4294967296",
                                                "9223372036854775807",
                                                "-9223372036854775808",
                                                "18446744073709551616",
                                                "1e308",
                                                "1e309",
                                                "-1e308",
                                                "1e-320",
                                                "nan",
                                                "inf",
                                                "0.5",
                                                "1000000",
                                                "100000000",
                                                "007",
                                                "+3",
                                                "1e",
                                                "0x10"};
  const std::size_t from = below(data.size());
  const auto begin = std::find_if(data.begin() + std::ptrdiff_t(from), data.end(), isNumberPart);
  const auto end = std::find_if_not(begin, data.end(), isNumberPart);
  data.replace(begin, end, numbers[below(numbers.size())]);
}

void Mutator::extremeWord(std::string& data)
{
  static constexpr std::array<std::uint64_t, 12> words{0,
                                                       1,
                                                       2,
                                                       0x7F,
                                                       0xFF,
                                                       0xFFFF,
                                                       0x7FFFFFFF,
                                                       0x80000000,
                                                       0xFFFFFFFF,
                                                       0x100000000,
                                                       0x7FFFFFFFFFFFFFFF,
                                                       0xFFFFFFFFFFFFFFFF};
  const std::size_t size = std::size_t(1) << below(4);
  if (data.size() < size)
    return;
  const std::uint64_t word = words[below(words.size())] + (below(4) == 0 ? below(16) : 0);
  const bool bigEnd = below(2) == 0;
  const std::size_t at = below(data.size() - size + 1) / size * size;
  for (std::size_t i = 0; i < size; ++i)
    data[at + i] = char(word >> 8 * (bigEnd ? size - 1 - i : i));
}

void Mutator::insertToken(std::string& data)
{
  data.insert(below(data.size() + 1), tokens()[below(tokens().size())]);
}

} // namespace ndframe::test
