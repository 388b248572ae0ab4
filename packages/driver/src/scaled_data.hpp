#pragma once

#include <map>
#include <string>
#include <vector>

#include "ndframe/base/deck.hpp"
#include "ndframe/base/param_spec.hpp"

namespace ndframe
{

/// What the factors of load cases can multiply in a deck, by its path: loads and supports with their given expressions
/// ("Bodies/punch/Loads/press" -> Value), interfaces with their gaps, rigid bodies with their displacements.
class ScalableData
{
public:
  /// `spec`: that of the deck.
  ScalableData(const DeckList& deck, const ListSpec& spec);

  bool has(const std::string& path) const { return places_.count(path) > 0; }
  std::vector<std::string> paths() const;

  /// Multiplies what stands in `deck` (the one that this was made from, or a copy) under a path that has() knows. A
  /// factor of 1 changes no text.
  void multiply(DeckList& deck, const std::string& path, double factor) const;

private:
  /// A list of the deck, and those of its keys that are multiplied.
  struct Place
  {
    std::vector<std::string> lists; ///< their names, the outermost first
    std::vector<std::string> keys;
  };
  void add(std::vector<std::string> lists, std::vector<std::string> keys);

  std::map<std::string, Place> places_;
};

} // namespace ndframe
