#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "anderson_mixing.hpp"
#include "ndframe/algebra/dense.hpp"
#include "relaxations.hpp"

namespace ndframe
{
namespace
{

constexpr double unknownTheta = 0.5; ///< that of two equal bodies

/// With a better factor of all errors the constant theta needs no help.
constexpr double slow = 0.6;

/// The eigenvalues are estimates from inside, and other statuses turn tractions for once: theta is lowered by this in
/// the second sweep running in which they turn and grow.
constexpr double lowered = 0.5;
constexpr int running = 2;

/// A factor to the two digits that a few steps of Lanczos' method are sure of, so that it does not depend on the
/// numbering of the nodes.
double rounded(double theta)
{
  const double unit = std::pow(10.0, std::floor(std::log10(theta)) - 1.0);
  return unit * std::round(theta / unit);
}

/// The best constant factor, from the extreme eigenvalues mu of the sweep (role_spectrum.hpp):
///
///   theta = 2 / (2 + mu_min + mu_max),   contraction (mu_max - mu_min) / (2 + mu_min + mu_max).
///
/// While statuses change the sweep is a contraction all the same: its derivative has the eigenvalues of fewer nodes,
/// which lie between the same bounds, and 0 for the open ones, so that the error shrinks by max |1 - theta|,
/// |1 - theta (1 + mu_max)| in the norm of S_N^-1. Where mu is far below 1 for some motions and far above it for others
/// that is slow in any roles; then earlier sweeps are mixed in (anderson_mixing.hpp).
class Automatic final : public RelaxationController
{
public:
  bool needsSpectrum() const override { return true; }

  void start() override { begin(unknownTheta, true); }

  void startWith(const RoleSpectrum& spectrum) override
  {
    if (spectrum.isKnown())
      begin(rounded(spectrum.bestTheta()), std::max(spectrum.contraction(), 1.0 - spectrum.bestTheta()) > slow);
    else
      start();
  }

  RelaxedTraction next(const InterfaceValues& dirichlet, const InterfaceValues& neumann) override
  {
    const std::string note = watch(dirichlet, neumann);
    InterfaceValues next = mixes_ ? mixing_.next(dirichlet, neumann, theta_) : relax(dirichlet, neumann, theta_);
    return {std::move(next), theta_, note};
  }

  RelaxationMemory memory() const override
  {
    RelaxationMemory memory = mixing_.memory();
    memory.push_back(residual_);
    memory.push_back({theta_, double(overshoots_)});
    return memory;
  }

  bool recall(const RelaxationMemory& memory) override
  {
    if (memory.size() < 2 || memory.back().size() != 2 || !mixing_.recall({memory.begin(), memory.end() - 2}))
      return false;
    residual_ = memory[memory.size() - 2];
    theta_ = memory.back().front();
    overshoots_ = int(memory.back().back());
    return true;
  }

private:
  void begin(double theta, bool mixes)
  {
    theta_ = theta;
    mixes_ = mixes;
    overshoots_ = 0;
    residual_.clear();
    mixing_.start();
  }

  /// Lowers theta where tractions overshoot; returns the note.
  std::string watch(const InterfaceValues& dirichlet, const InterfaceValues& neumann)
  {
    Vector residual = difference(dirichlet, neumann);
    const bool grows = !residual_.empty() && dot(residual, residual_) < 0.0 && norm(residual) > norm(residual_);
    overshoots_ = grows ? overshoots_ + 1 : 0;
    residual_ = std::move(residual);
    if (overshoots_ < running)
      return {};
    overshoots_ = 0;
    theta_ *= lowered;
    return fmt::format("theta lowered to {:.3g}", theta_);
  }

  double theta_ = unknownTheta;
  bool mixes_ = false;
  int overshoots_ = 0; ///< sweeps running in which the tractions turned and grew
  Vector residual_;    ///< of the sweep before; empty in the first
  AndersonMixing mixing_;
};

} // namespace

void registerAutomatic(Registry<RelaxationController>& registry)
{
  registry.add(
      "Automatic",
      "The best constant factor, from the bodies' stiffnesses on the interface, found before the first sweep by a few "
      "steps that cost as much as a sweep each; where that would be slow, earlier sweeps are mixed in.",
      {}, [](const Params&) { return std::make_unique<Automatic>(); });
}

} // namespace ndframe
