#pragma once

#include "ndframe/base/registry.hpp"
#include "ndframe/mechanics/elasticity.hpp"

namespace ndframe
{

/// A material as the deck describes it.
class MaterialLaw
{
public:
  virtual ~MaterialLaw() = default;
  virtual Hypothesis hypothesis() const = 0; ///< as the deck says
  virtual Elasticity elasticity() const = 0; ///< reduced to the hypothesis
};

/// "Isotropic", "Orthotropic".
void registerMaterials(Registry<MaterialLaw>& registry);

} // namespace ndframe
