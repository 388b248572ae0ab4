#include "yardstick.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "found_interfaces.hpp"
#include "ndframe/base/diagnostics.hpp"
#include "ndframe/condensation/condensed_model.hpp"
#include "ndframe/io/atomic_file.hpp"
#include "ndframe/report/outputs.hpp"

namespace ndframe
{
namespace
{

struct NamedYardstick
{
  std::string name;
  Yardstick yardstick;
};

/// The bodies and, last, their sum.
std::vector<NamedYardstick> measureBodies(const Model& model)
{
  const auto systems = assembleSystems(model, Comm::single());
  std::vector<NamedYardstick> bodies;
  Yardstick sum;
  for (std::size_t b = 0; b < systems.size(); ++b) {
    const SolverProblem problem = solverProblem(model, int(b), systems[b]);
    bodies.push_back({model.bodies[b].name, measureYardstick(problem, systems[b].load.all())});
    sum += bodies.back().yardstick;
  }
  bodies.push_back({"all", sum});
  return bodies;
}

nlohmann::ordered_json json(const Seconds& seconds)
{
  return {{"wall", seconds.wall}, {"processor", seconds.processor}};
}

std::string jsonText(const std::vector<NamedYardstick>& bodies)
{
  nlohmann::ordered_json all;
  for (const auto& [name, y] : bodies)
    all[name] = {{"dofs", y.dofs},          {"nonzeros", y.nonzeros},   {"flops", y.flops},
                 {"order", json(y.order)},  {"factor", json(y.factor)}, {"solve", json(y.solve)},
                 {"total", json(y.total())}};
  return all.dump(2) + "\n";
}

std::string table(const std::vector<NamedYardstick>& bodies)
{
  std::string text = fmt::format("  {:<14}{:>9}{:>11}{:>9}{:>9}{:>9}{:>9}{:>9}{:>11}\n", "body", "dofs", "nonzeros",
                                 "flops", "order", "factor", "solve", "seconds", "processor");
  for (const auto& [name, y] : bodies)
    text +=
        fmt::format("  {:<14}{:>9}{:>11}{:>9.2e}{:>9.3f}{:>9.3f}{:>9.3f}{:>9.3f}{:>11.3f}\n", name, y.dofs, y.nonzeros,
                    y.flops, y.order.wall, y.factor.wall, y.solve.wall, y.total().wall, y.total().processor);
  return text;
}

} // namespace

std::string yardstickText(const RunSettings& settings, const Components& components, const std::string& deckName,
                          const Comm& comm)
{
  if (comm.size() > 1)
    throw InputError("--yardstick measures one process; run it without mpirun.");
  Model meshes;
  Ledger ledger;
  const RunSettings found = withFoundInterfaces(settings, components, meshes, comm, ledger, silentLog());
  const auto bodies = measureBodies(buildModel(found.scene, components));
  const std::string file = outputStem(settings.output, deckName).string() + ".yardstick.json";
  writeTextAtomically(file, jsonText(bodies));
  return table(bodies) + fmt::format("\n  wrote {}", file);
}

} // namespace ndframe
