#pragma once

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "driver/program.hpp"
#include "driver/scene.hpp"
#include "io/temporary_folder.hpp"

namespace ndframe::test
{

/// Calls of the program, one after the other in a folder of their own.
class ProgramFolder : public testing::Test
{
protected:
  ProgramResult call(const std::vector<std::string>& arguments) const { return runProgram(arguments, path(".")); }
  /// A shipped deck with settings.
  ProgramResult callDeck(const std::string& deck, const std::vector<std::string>& settings) const
  {
    std::vector<std::string> arguments{"-i", shippedDeck(deck)};
    for (const auto& setting : settings)
      arguments.insert(arguments.end(), {"--set", setting});
    return call(arguments);
  }
  std::string path(const std::string& name) const { return folder_.file(name); }
  std::vector<std::string> files() const { return filesIn(path(".")); }
  nlohmann::json summary(const std::string& name) const
  {
    return nlohmann::json::parse(contentsOf(path(name + ".summary.json")));
  }

private:
  TemporaryFolder folder_;
};

} // namespace ndframe::test
