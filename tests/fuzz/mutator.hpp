#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace ndframe::test
{

/// Damages files the way slips, broken disks and broken programs do. The n-th file of a seed is always the same.
class Mutator
{
public:
  /// sound: the files to start from; text: they are text, and are kept so most of the time.
  Mutator(std::vector<std::string> sound, bool text, std::uint64_t seed);

  std::string operator()(std::uint64_t n);

private:
  using Change = void (Mutator::*)(std::string&);

  std::size_t below(std::size_t end) { return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_); }
  const std::string& anySound() { return sound_[below(sound_.size())]; }
  /// Begin and end of a piece: whole lines of a text, aligned words of binary data.
  std::pair<std::size_t, std::size_t> piece(const std::string& data);

  void flipBit(std::string& data);
  void setByte(std::string& data);
  void removePiece(std::string& data);
  void repeatPiece(std::string& data);
  void movePiece(std::string& data);
  void splice(std::string& data);
  void cutOff(std::string& data);
  void extremeNumber(std::string& data);
  void extremeWord(std::string& data);
  void insertToken(std::string& data);

  std::vector<std::string> sound_;
  bool text_;
  std::uint64_t seed_;
  std::mt19937_64 random_;
};

} // namespace ndframe::test
