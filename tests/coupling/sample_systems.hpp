#pragma once

#include <memory>
#include <string>

#include "ndframe/coupling/coupling.hpp"

namespace ndframe::test
{

/// The relaxation controllers that ndframe ships, and those a test adds.
Registry<RelaxationController>& relaxations();

/// The list `Relaxation` with these entries ("Type" among them); InputError goes through.
std::unique_ptr<RelaxationController> makeRelaxation(const std::string& entries);

/// The list `Coupling` with these entries and lists.
std::unique_ptr<Coupling> makeCoupling(const std::string& entries);
/// Neumann-Dirichlet; `more`: further entries and lists.
std::unique_ptr<Coupling> neumannDirichlet(double tolerance, const std::string& more = {}, int maximumSweeps = 1000);
std::string relaxation(const std::string& type, const std::string& key, double value);

CouplingResult run(const Coupling& coupling, const InterfaceSystem& system);
CouplingResult run(const Coupling& coupling, const InterfaceSystem& system, Ledger& ledger,
                   const CouplingStart& start = {});

/// A system without bodies on a straight interface of this many equal P1 facets.
InterfaceSystem emptySystem(int nodes);
/// A body that touches the listed unknowns with one role; `floats`: contact alone holds it against translation.
BodyTrace makeBody(std::vector<int> unknowns, bool isDirichlet, DenseMatrix S, Vector g, bool floats = false);

/// stiffness (I + a random positive part): bodies that the iteration can bring together.
DenseMatrix mildStiffness(int size, unsigned seed, double stiffness);
/// A chain that floats, soft enough for theta = 0.5: the iteration amplifies no round-off.
DenseMatrix softChain(int size);
/// The contact matrix, stored.
DenseMatrix storedContactMatrix(const InterfaceSystem& system);

/// A floating block pressed by the uniform pressure 1 onto a foundation that follows the pressure: the patch test.
InterfaceSystem patchSystem();
/// A held (or floating) body over another one, random loads and gaps: part of the contact opens.
InterfaceSystem randomSystem(unsigned seed, bool floats);

/// A held body below which a floating one is pressed up, random loads and gaps: part of the contact opens.
InterfaceSystem floatingNeumannSystem(unsigned seed);
/// Two scenes on the halves of one interface.
InterfaceSystem sideBySide(const InterfaceSystem& first, const InterfaceSystem& second);
/// randomSystem with an obstacle of random height at each end of the interface, which the Dirichlet body alone meets.
InterfaceSystem obstacleSystem(unsigned seed, bool floats);
/// Random loads and gaps: scenes in which no body floats, a Dirichlet body, a Neumann body, one of each in scenes side
/// by side, one of each that hold each other, and obstacles with a held and a floating body.
std::vector<InterfaceSystem> randomScenes(unsigned seed);
/// The same scene with the roles exchanged: what is counted along n_c changes its sign.
InterfaceSystem exchanged(InterfaceSystem system);
/// The same scene with stiffnesses and lengths in other units.
InterfaceSystem inOtherUnits(InterfaceSystem system, double stiffness, double length);

/// Every body's equation: S1 u1 = g1 + C Lambda_dir,  S2 u2 = g2 - C Lambda_neu, and the tractions belong to the
/// forces.
void expectEquilibrium(const InterfaceSystem& system, const InterfaceState& state, double tolerance = 1e-11);
/// u1 - u2 <= gap, forces <= 0, product zero.
void expectComplementarity(const InterfaceSystem& system, const InterfaceState& state, double tolerance = 1e-11);
/// Displacements, tractions and statuses.
void expectSameState(const InterfaceState& a, const InterfaceState& b, double tolerance);

/// A run and the sweeps that it kept, or passes.
struct Kept
{
  CouplingResult result;
  std::vector<SweepsDone> done;
  std::map<std::string, std::int64_t> counts; ///< of the ledger
};

/// goal: CouplingStart::iterationError.
Kept keepSweeps(const Coupling& coupling, const InterfaceSystem& system, int every,
                std::optional<SweepsDone> after = std::nullopt, std::optional<double> goal = std::nullopt);

} // namespace ndframe::test
