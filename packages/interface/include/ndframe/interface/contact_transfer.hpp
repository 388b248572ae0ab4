#pragma once

#include "ndframe/base/registry.hpp"
#include "ndframe/interface/body_trace.hpp"

namespace ndframe
{

/// A contact state with the interface meshes it lives on; per interface node, numbered one interface after another.
struct CarriedContact
{
  std::vector<InterfaceMesh> interfaces; ///< empty: nothing is carried
  InterfaceValues traction;              ///< Lambda along n_c, a stress; negative in compression
  std::vector<char> closed;              ///< 1: closed
};

/// What of the contact on one mesh the iteration on the next one begins with.
class ContactTransfer
{
public:
  virtual ~ContactTransfer() = default;

  /// The state on other meshes of the same interfaces. Empty: the iteration begins as if there were no mesh before.
  virtual CarriedContact onto(const std::vector<InterfaceMesh>& to, const CarriedContact& from) const = 0;
};

/// "Carried" (default), "None".
void registerContactTransfers(Registry<ContactTransfer>& registry);

} // namespace ndframe
