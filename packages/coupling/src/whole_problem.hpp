#pragma once

#include <memory>
#include <optional>

#include "ndframe/algebra/joined_system.hpp"
#include "ndframe/subdomain/status_method.hpp"
#include "whole_rows.hpp"

namespace ndframe
{

/// The contact of bodies that are solved by iterations on all their dofs: closed unknowns give away one entry of v each
/// (ClosedRows), kept dofs follow what is left, and conjugate gradients solve all bodies at once, each time from where
/// the statuses before left them. Nothing is condensed.
///
/// While statuses change a pass stops at a residual of 1e-2, and earlier ones at less than that the fewer they are; the
/// first pass that contradicts none of its statuses goes on to the tolerance of the solver, as do all after it.
///
/// Source of the steps: the inexact semismooth Newton method (Hintermueller, Ito, Kunisch 2002, for exact ones).
class WholeProblem final : public StatusSystem
{
public:
  /// The system must outlive it, and all its bodies must be solved whole. start: the fields, and how far to go.
  WholeProblem(const InterfaceSystem& system, const CouplingStart& start);

  /// Statuses and fields to begin with, from the contact of functions that are linear between the vertices. first: the
  /// statuses with which it begins itself. Before the first pass.
  std::vector<char> settleOnVertices(std::vector<char> first, Ledger& ledger);

  bool holds(const std::vector<char>& closed) override;
  void solve(const std::vector<char>& closed, double proximal, StatusPass& pass) override;
  ProximalLimits proximalLimits() const override { return {100, 1e-6}; }
  const std::vector<std::string>& motions() const override { return motions_; }
  StatusMemory memory() override;
  bool recall(const StatusMemory& memory) override;

  const Network& network() const { return network_; }
  const Vector& displacement() const { return v_; } ///< of the last pass
  /// The fields of the last pass, per body, in the nodes' own axes; no pass can follow. Collective.
  std::vector<NodalField> takeFields() &&;
  /// What signs and gaps are compared with at the end.
  double roundOff() const;

private:
  void begin(const std::vector<NodalField>& fields);
  void follow(const std::vector<char>& closed, double proximal);
  double finest() const { return toleranceFor(exactness_, joined_->tolerance()); }
  void settle(double tolerance, StatusPass& pass);
  void moveTo(const ClosedRows& closed);
  void evaluate(const Vector& rest, StatusPass& pass) const;

  Network network_;
  std::vector<std::string> motions_;
  DenseMatrix approach_; ///< of both sides per unknown under the free motions
  WholeRows rows_;
  std::vector<const SparseField*> loads_;
  Vector v_, kept_;                  ///< per entry, the latter as the kept dofs have it
  std::optional<ClosedRows> closed_; ///< of the last pass
  std::unique_ptr<JoinedSystem> joined_;
  Exactness exactness_;
  double tolerance_;
  int earlyPasses_ = 0;
  std::vector<char> levelClosed_; ///< for which the coarse level was set up, with
  double levelProximal_ = 0.0;    ///< this term
};

/// Whether all bodies are.
bool areSolvedWhole(const InterfaceSystem& system);

} // namespace ndframe
