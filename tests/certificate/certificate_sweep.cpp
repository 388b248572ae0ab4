// The central claim: no bound below its error, whatever the scene. And, with --sharpness, how far above it.

#include <cstdio>
#include <fstream>

#include "certificate/report.hpp"
#include "certificate/sharpness.hpp"
#include "ndframe/algebra/comm.hpp"

using namespace ndframe;
using namespace ndframe::test;

namespace
{

DrawnScene sceneOf(const SweepOptions& options, int index)
{
  if (options.needles)
    return drawNeedleScene(options.seed, index);
  if (!options.turning)
    return drawScene(options.seed, index);
  DrawnScene scene = drawTurningScene(options.seed, index);
  if (options.ownNormals)
    scene.deck.set("Interfaces/contact/Corner Angle", 0.0);
  return scene;
}

bool searchViolations(const SweepOptions& options)
{
  std::vector<Trial> trials;
  std::ofstream table(options.folder + "/sweep.csv");
  table << titleRow();
  for (int i = options.first; i < options.first + options.scenes; ++i) {
    const DrawnScene scene = sceneOf(options, i);
    trials.push_back(runTrial(scene, i, options.folder, options.keep));
    table << row(trials.back()) << std::flush;
    for (const auto& violation : trials.back().violations)
      fmt::print("scene {} ({}): {}\n", i, trials.back().kind, violation);
    std::fflush(stdout);
  }
  fmt::print("{}", report(trials));
  return !violated(trials);
}

} // namespace

int main(int argc, char** argv)
{
  const SweepOptions options = readOptions(argc, argv);
  Comm::world(argc, argv);
  const bool good = options.sharpness ? measureSharpness(options) : searchViolations(options);
  finishMpi();
  return good ? 0 : 1;
}
