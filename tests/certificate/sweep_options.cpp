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
      {"--finest", [&](const std::string& value) { options.finest = std::stoi(value); }}};
  const std::map<std::string, bool SweepOptions::*> flags{{"--keep", &SweepOptions::keep},
                                                          {"--needles", &SweepOptions::needles},
                                                          {"--sharpness", &SweepOptions::sharpness},
                                                          {"--turning", &SweepOptions::turning},
                                                          {"--own-normals", &SweepOptions::ownNormals}};
  try {
    for (int i = 1; i < argc; ++i)
      if (const auto flag = flags.find(argv[i]); flag != flags.end())
        options.*flag->second = true;
      else if (i + 1 < argc)
        known.at(argv[i])(argv[i + 1]), ++i;
      else
        throw std::invalid_argument("value");
  } catch (const std::exception&) {
    std::fputs("certificate_sweep [--scenes N] [--seed S] [--first N] [--folder F] [--keep] [--needles] [--sharpness "
               "[--finest N]] [--turning [--own-normals]]\n",
               stderr);
    std::exit(2);
  }
  std::filesystem::create_directories(options.folder);
  return options;
}

} // namespace ndframe::test
