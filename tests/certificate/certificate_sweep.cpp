// The central claim: no bound below its error, whatever the scene.

#include <cstdio>
#include <fstream>

#include "certificate/report.hpp"
#include "certificate/sweep_options.hpp"
#include "ndframe/algebra/comm.hpp"

using namespace ndframe;
using namespace ndframe::test;

int main(int argc, char** argv)
{
  const SweepOptions options = readOptions(argc, argv);
  Comm::world(argc, argv);
  std::vector<Trial> trials;
  std::ofstream table(options.table);
  table << titleRow();
  for (int i = 0; i < options.scenes; ++i) {
    trials.push_back(
        runTrial(drawScene(options.seed, options.first + i), options.first + i, options.folder, options.keep));
    table << row(trials.back()) << std::flush;
    for (const auto& violation : trials.back().violations)
      fmt::print("scene {} ({}): {}\n", trials.back().index, trials.back().kind, violation);
    std::fflush(stdout);
  }
  fmt::print("{}", report(trials));
  finishMpi();
  return violated(trials) ? 1 : 0;
}
