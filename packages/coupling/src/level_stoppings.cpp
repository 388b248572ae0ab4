#include "ndframe/coupling/level_stopping.hpp"

namespace ndframe
{
namespace
{

class Balanced final : public LevelStopping
{
public:
  double allowed(double mesh, double share) const override { return share * mesh; }
};

class Tolerance final : public LevelStopping
{
public:
  double allowed(double, double) const override { return 0.0; }
};

} // namespace

void registerLevelStoppings(Registry<LevelStopping>& registry)
{
  registry.add("Balanced", "When the iteration's part of the error is below Iteration Share times the mesh's.", {},
               [](const Params&) { return std::make_unique<Balanced>(); });
  registry.add("Tolerance", "On every mesh as Coupling/Stopping says.", {},
               [](const Params&) { return std::make_unique<Tolerance>(); });
}

} // namespace ndframe
