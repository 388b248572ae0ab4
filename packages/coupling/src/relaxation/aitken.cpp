#include <fmt/format.h>

#include "ndframe/algebra/dense.hpp"
#include "relaxations.hpp"

namespace ndframe
{
namespace
{

/// Factors that may be used, an open range. A proposal outside says that the last two residuals do not belong to one
/// linear iteration (statuses changed); clipping it to a small factor would stop the iteration for good.
constexpr double lowestTheta = 0.0, highestTheta = 2.0;

/// Aitken's dynamic relaxation of the interface traction (Irons and Tuck 1969).
///
///   theta_p = - theta_{p-1} <r_{p-1}, r_p - r_{p-1}> / |r_p - r_{p-1}|^2,   r_p = Lambda_dir(p) - Lambda_neu(p-1)
///   (18), (27)
///
/// The first sweep uses `Initial Theta`. Theta is dimensionless and stays in (0, 2): a proposal outside leaves the
/// factor as it is and is reported in the history. Limits: one factor for the whole interface; while statuses still
/// change it may overshoot for one sweep.
class Aitken final : public RelaxationController
{
public:
  explicit Aitken(double initialTheta) : initialTheta_(initialTheta), theta_(initialTheta) {}

  void start() override
  {
    theta_ = initialTheta_;
    residual_.clear();
  }

  RelaxedTraction next(const InterfaceValues& dirichlet, const InterfaceValues& neumann) override
  {
    Vector residual = difference(dirichlet, neumann);
    std::string note;
    if (!residual_.empty()) {
      const Vector change = difference(residual, residual_);
      const double squared = dot(change, change);
      const double proposed = squared > 0.0 ? -theta_ * dot(residual_, change) / squared : theta_;
      if (proposed > lowestTheta && proposed < highestTheta)
        theta_ = proposed;
      else
        note = fmt::format("theta {:.3g} refused", proposed);
    }
    residual_ = std::move(residual);
    return {relax(dirichlet, neumann, theta_), theta_, std::move(note)};
  }

  RelaxationMemory memory() const override { return {{theta_}, residual_}; }
  bool recall(const RelaxationMemory& memory) override
  {
    if (memory.size() != 2 || memory.front().size() != 1)
      return false;
    theta_ = memory.front().front();
    residual_ = memory.back();
    return true;
  }

private:
  double initialTheta_, theta_;
  Vector residual_; ///< of the sweep before; empty in the first
};

} // namespace

void registerAitken(Registry<RelaxationController>& registry)
{
  registry.add("Aitken", "Dynamic relaxation from the last two residuals; no factor to tune.",
               {{"Initial Theta", 0.5, inOpenRange(0.0, 2.0), "Factor of the first sweep."}},
               [](const Params& p) { return std::make_unique<Aitken>(p.get<double>("Initial Theta")); });
}

} // namespace ndframe
