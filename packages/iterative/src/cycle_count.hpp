#pragma once

#include <utility>

#include "ndframe/base/ledger.hpp"
#include "ndframe/iterative/krylov_library.hpp"

namespace ndframe
{

/// What conjugate gradients on two levels take, with the products for residuals outside of them, in the ledger.
class CycleCount
{
public:
  explicit CycleCount(const char* products = "fine products", const char* cycles = "multigrid cycles")
      : products_(products), cycles_(cycles)
  {}
  void addResidual() { ++residuals_; }

  /// `now`: all that they took since they were set up. Products for residuals count only where there are two levels.
  /// What ranks send to each other is that of all ranks. Collective.
  void enter(const CycleWork& now, const Comm& comm, Ledger& ledger)
  {
    if (now.products == 0)
      return;
    ledger.count(products_, now.products - entered_.products + std::exchange(residuals_, 0));
    ledger.count(cycles_, now.cycles - entered_.cycles);
    if (comm.size() > 1) {
      ledger.count("halo messages", comm.sum(now.traffic.messages - entered_.traffic.messages));
      ledger.count("halo bytes", comm.sum(now.traffic.bytes - entered_.traffic.bytes));
    }
    entered_ = now;
  }

private:
  const char *products_, *cycles_; ///< what they are called
  CycleWork entered_;
  int residuals_ = 0;
};

} // namespace ndframe
