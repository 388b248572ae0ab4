// ndframe with a component that breaks an assertion: what the program does about a bug (regression case `bug`).

#include "ndframe/base/diagnostics.hpp"
#include "ndframe/driver/main.hpp"

namespace
{

using namespace ndframe;

class Faulty final : public RelaxationController
{
public:
  void start() override {}
  RelaxedTraction next(const InterfaceValues& dirichlet, const InterfaceValues& /*neumann*/) override
  {
    NDFRAME_ASSERT(dirichlet.empty(), "broken on purpose");
    return {};
  }
  RelaxationMemory memory() const override { return {}; }
  bool recall(const RelaxationMemory& memory) override { return memory.empty(); }
};

void registerFaulty(Components& components)
{
  components.relaxations.add("Faulty", "Breaks an assertion.", {},
                             [](const Params&) { return std::make_unique<Faulty>(); });
}

} // namespace

int main(int argc, char** argv)
{
  return ndframe::runMain(argc, argv, registerFaulty);
}
