#pragma once

#include <memory>
#include <optional>

#include "ndframe/algebra/sparse_cholesky.hpp"
#include "ndframe/subdomain/status_method.hpp"
#include "network_bodies.hpp"

namespace ndframe
{

/// The contact of a network of bodies with stored operators for one set of closed unknowns: these give away one entry
/// of v each (ClosedRows), v = Z y + v_0, and  Z^T S Z y = Z^T (g - S v_0)  is sparse, factored by CHOLMOD. Memory and
/// time of a pass grow linearly with the bodies but for the fill of a plane graph.
class NetworkProblem final : public StatusSystem
{
public:
  /// The network must outlive the problem.
  NetworkProblem(const Network& network, Ledger& ledger);

  /// By the factor: its pivots vanish where a motion is left.
  bool holds(const std::vector<char>& closed) override;
  /// proximal: 0; for sets that hold the bodies (NetworkStatuses).
  void solve(const std::vector<char>& closed, double proximal, StatusPass& pass) override;
  /// In a network some body or other is often without contact for a while.
  ProximalLimits proximalLimits() const override { return {100, 1e-6}; }
  const std::vector<std::string>& motions() const override { return motions_; }

  /// Of the last pass.
  const Vector& displacement() const { return v_; }

private:
  SymmetricEntries reducedStiffness() const;
  void addBody(std::size_t body, std::vector<int>& local, SymmetricEntries& entries) const;
  Vector unbalanced(const Vector& v) const;

  const Network& network_;
  Ledger& ledger_;
  std::vector<std::string> motions_;
  NetworkBodies bodies_;
  Vector v_;
  std::vector<char> closed_; ///< that the following belongs to
  std::optional<ClosedRows> rows_;
  SymmetricEntries stiffness_;
  std::unique_ptr<SparseCholesky> factor_; ///< null where nothing holds the bodies
};

} // namespace ndframe
