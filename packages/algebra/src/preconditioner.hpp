#pragma once

#include <memory>

#include "ndframe/base/registry.hpp"

namespace ndframe
{

struct TpetraSystem;
struct PreconditionerHandle;

/// A symmetric positive definite approximation of the inverse of the interior matrix, for conjugate gradients.
class Preconditioner
{
public:
  virtual ~Preconditioner() = default;
  virtual std::shared_ptr<PreconditionerHandle> build(const TpetraSystem& system) const = 0;
  virtual std::string name() const = 0;
};

/// One function per component file.
void registerMueLu(Registry<Preconditioner>& registry);
void registerIfpack2(Registry<Preconditioner>& registry);

} // namespace ndframe
