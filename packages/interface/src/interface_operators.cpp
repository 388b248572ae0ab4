#include "operators.hpp"

namespace ndframe
{
namespace
{

/// Condensed where S comes with the factor and stays small, else matrix free.
class AutomaticOperator final : public InterfaceOperator
{
public:
  explicit AutomaticOperator(int largestCondensed) : largestCondensed_(largestCondensed) {}
  std::unique_ptr<SymmetricOperator> represent(const CondensedBody& body, int size) const override
  {
    if (body.hasCheapSchur() && size <= largestCondensed_)
      return makeDenseOperator(body.schurComplement());
    return makeMatrixFree(body, size, interfaceTolerance);
  }

private:
  int largestCondensed_;
};

} // namespace

void registerAutomaticOperator(Registry<InterfaceOperator>& registry)
{
  registry.add("Automatic",
               "Condensed where the dense Schur complement comes with the factorisation and the interface is not "
               "larger than `Largest Condensed`; otherwise matrix free.",
               {ParamSpec("Largest Condensed", 10000, atLeast(0),
                          "Interface nodes up to which S is stored (24 n^2 bytes per body with its factors). Stored is "
                          "faster wherever it fits: 1.4 times at 500 nodes, 9 times at 2000.")},
               [](const Params& p) { return std::make_unique<AutomaticOperator>(p.get<int>("Largest Condensed")); });
}

void registerInterfaceOperators(Registry<InterfaceOperator>& registry)
{
  registerAutomaticOperator(registry);
  registerCondensedOperator(registry);
  registerMatrixFreeOperator(registry);
}

} // namespace ndframe
