#include "certificate/sweep_options.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>

namespace ndframe::test
{

SweepOptions readOptions(int argc, char** argv)
{
  SweepOptions options;
  const std::map<std::string, std::function<void(const std::string&)>> known{
      {"--scenes", [&](const std::string& value) { options.scenes = std::stoi(value); }},
      {"--seed", [&](const std::string& value) { options.seed = std::stoull(value); }},
      {"--first", [&](const std::string& value) { options.first = std::stoi(value); }},
      {"--folder", [&](const std::string& value) { options.folder = value; }},
      {"--keep", [&](const std::string& value) { options.keep = value == "yes"; }}};
  try {
    for (int i = 1; i < argc; i += 2) {
      if (i + 1 == argc)
        throw std::invalid_argument("value");
      known.at(argv[i])(argv[i + 1]);
    }
  } catch (const std::exception&) {
    std::fputs("certificate_sweep [--scenes N] [--seed S] [--first N] [--folder F] [--keep yes]\n", stderr);
    std::exit(2);
  }
  std::filesystem::create_directories(options.folder);
  options.table = options.folder + "/sweep.csv";
  return options;
}

} // namespace ndframe::test
