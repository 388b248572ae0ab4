#pragma once

#include "feti_set.hpp"

namespace ndframe
{

/// StatusSystem::mostDraws() of networks, where loose bodies that lean on each other lead in circles.
inline constexpr int networkDraws = 400;

/// Where the iterations of a pass end.
struct FetiStop
{
  double tolerance;  ///< residual in the norm of M, relative to the forces in the norm of F
  double goal = 0.0; ///< for FetiProblem::error(), if that ends them earlier
};

/// The contact of a network for one set of closed unknowns, by its forces r:  with B the closed rows of D - N,
///
///   v = S^+ (g + B^T r) + R a,   B v = bound,   R^T (g + B^T r) = 0
///
/// gives  F r + B R a = d,  G r = e,  F = B S^+ B^T,  G = R^T B^T,  solved by projected conjugate gradients (Farhat,
/// Roux 1991; Farhat, Mandel, Roux 1994), started from the forces of the pass before. Preconditioner
/// M = B_D S_A B_D^T (Dirichlet), B_D = (B D^-1 B^T)^-1 B D^-1, D = diag S, S_A the bodies' stiffness on the closed
/// entries; projection P = 1 - Q G^T (G Q G^T)^-1 G with Q = M + 0.1 / diag(B D^-1 B^T), so that jumps of the
/// stiffness cost no iterations (as scaled projections of Klawonn and Widlund do). Every iteration costs two dense
/// solves and products a body; nothing of the size of the network is factored but the coarse problem G Q G^T.
class FetiProblem final : public StatusSystem
{
public:
  /// The network must outlive the problem.
  FetiProblem(const Network& network, const FetiStop& stop, Ledger& ledger);

  bool holds(const std::vector<char>& closed) override;
  void solve(const std::vector<char>& closed, double proximal, StatusPass& pass) override;
  ProximalLimits proximalLimits() const override { return {100, 1e-6}; }
  int mostDraws() const override { return networkDraws; }
  const std::vector<std::string>& motions() const override { return motions_; }
  StatusMemory memory() override;
  bool recall(const StatusMemory& memory) override;

  /// Passes end at this tolerance from now on.
  void endAt(double tolerance) { stop_.tolerance = tolerance; }
  /// The next pass begins with these forces, one per unknown.
  void startFrom(const Vector& force) { force_ = force; }
  /// Of the last pass.
  const Vector& displacement() const { return v_; }
  /// Of the last pass, in the energy norm, the larger one of two: the residual in the norm of M, no less than what the
  /// displacements are wrong by for their set (P^T F has no eigenvalue below 1 in that norm); and what moves them to
  /// where nothing penetrates, |B_D^T (B v - bound)_+|.
  double error() const { return error_; }
  /// Of the forces and openings of the last pass, relative to the largest: what is not known of them.
  double roundOff() const;

private:
  struct Iterate;
  Vector moved(Vector v, const Vector& amplitudes) const;
  Vector placed(const Vector& strained) const;
  Vector rest(const Vector& v) const;
  Iterate begun(double proximal) const;
  void advance(Iterate& now) const;
  double violation(const Iterate& now, const std::vector<char>& closed) const;
  double penetration(const Vector& v) const;
  bool isEnough(const Iterate& now, int iteration, const std::vector<char>& closed);

  const Network& network_;
  FetiStop stop_;
  Ledger& ledger_;
  std::vector<std::string> motions_;
  NetworkBodies bodies_;
  std::unique_ptr<FetiSet> set_;
  Vector flexibility_;           ///< per unknown: of B D^-1 B^T, what its own force opens
  Vector v_, force_;             ///< force: per unknown
  Vector amplitude_;             ///< of the motions in v
  std::vector<int> independent_; ///< unknowns that do not follow from others
  Averages weighted_;            ///< of these
  double error_ = 0.0, relativeError_ = 0.0;
};

/// Where forces are to be as good as those of factors.
inline constexpr double refinedTolerance = 1e-12;

/// Soft bodies let stiff ones move far, and a product with a stiff operator loses the strain in that motion. Forces as
/// unknowns do not: where digits are lost those of the settled set are found again, in a few iterations. v: the
/// network's displacements; returned with the changes, as is the state.
Vector refinedForces(const Network& network, const Vector& v, UnilateralState& status, Ledger& ledger);

} // namespace ndframe
