#include "ndframe/interface/contact_transfer.hpp"
#include "ndframe/interface/traction_transfer.hpp"

namespace ndframe
{
namespace
{

class Carried final : public ContactTransfer
{
public:
  CarriedContact onto(const std::vector<InterfaceMesh>& to, const CarriedContact& from) const override
  {
    return {to, transferTraction(from.interfaces, from.traction, to), transferClosed(from.interfaces, from.closed, to)};
  }
};

class None final : public ContactTransfer
{
public:
  CarriedContact onto(const std::vector<InterfaceMesh>&, const CarriedContact&) const override { return {}; }
};

} // namespace

void registerContactTransfers(Registry<ContactTransfer>& registry)
{
  registry.add("Carried", "Traction and statuses of the previous mesh at the same place. One or two sweeps per mesh.",
               {}, [](const Params&) { return std::make_unique<Carried>(); });
  registry.add("None", "Every mesh starts from Coupling/Initial Traction: more sweeps.", {},
               [](const Params&) { return std::make_unique<None>(); });
}

} // namespace ndframe
