#pragma once

#include <string>
#include <vector>

#include "ndframe/base/deck.hpp"

namespace ndframe::test
{

/// A deck that is put together entry by entry and becomes a Teuchos XML text. Paths as in --set.
class DeckText
{
public:
  explicit DeckText(const std::string& name) { root_.name = name; }

  void set(const std::string& path, const std::string& value) { put(path, "string", value); }
  void set(const std::string& path, const char* value) { put(path, "string", value); }
  void set(const std::string& path, double value);
  void set(const std::string& path, int value);
  void set(const std::string& path, bool value) { put(path, "bool", value ? "true" : "false"); }
  void set(const std::string& path, const std::vector<double>& values);
  void set(const std::string& path, const std::vector<int>& values);
  void set(const std::string& path, const std::vector<std::string>& values);

  std::string xml() const;

private:
  void put(const std::string& path, const std::string& type, const std::string& value);

  DeckList root_;
};

} // namespace ndframe::test
