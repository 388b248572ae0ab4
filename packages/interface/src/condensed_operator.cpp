#include "operators.hpp"

namespace ndframe
{
namespace
{

/// S stored densely: taken once from the factor, then every sweep and status change is dense algebra of interface size.
class CondensedOperator final : public InterfaceOperator
{
public:
  std::unique_ptr<SymmetricOperator> represent(const CondensedBody& body, int) const override
  {
    return makeDenseOperator(body.schurComplement());
  }
};

} // namespace

void registerCondensedOperator(Registry<InterfaceOperator>& registry)
{
  registry.add("Condensed", "The dense Schur complement of each body on its interface nodes (8 n^2 bytes per body).",
               {}, [](const Params&) { return std::make_unique<CondensedOperator>(); });
}

} // namespace ndframe
