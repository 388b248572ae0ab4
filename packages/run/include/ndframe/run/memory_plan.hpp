#pragma once

#include <string>

#include "ndframe/run/run_settings.hpp"
#include "ndframe/scene/model.hpp"

namespace ndframe
{

/// About how many bytes a body with so many dofs takes, factor and all: measured, within a factor of 1.5 for compact
/// bodies and direct solvers.
///
///   n (45 + 75 log2 n) in two dimensions, 200 n^(4/3) in three
double memoryOfBody(double dofs, int dim);

/// About how many bytes each of so many ranks takes where solids of so many dofs together are solved by Multigrid and
/// Monolithic: its share of matrix and levels, and what it has of the whole scene (docs/scaling.md).
double memoryOfRank(double dofs, int ranks);

/// The same where their error is bounded, too: what stars, faces and edges of a rank's cells take, and what it has of
/// all.
double memoryOfCertificate(double dofs, int ranks);

/// "about 0.38 GB for some 250 000 dofs; 19 GB (the machine) are left": from the deck alone, for boxes; for Multigrid
/// in three dimensions, which Automatic may choose, that of a rank, how much of the scene a rank has, and how many
/// machines would do where this one does not. solvesWhole: so does the coupling with solids.
std::string memoryPlan(const RunSettings& settings, const LinearSolver& solver, bool solvesWhole, int ranks);

/// Refuses a scene that would take more than twice the memory that is left to some process. Direct solvers only.
/// having: of so many ranks those that have the model: all, or one that hands it out. Collective among them.
void checkMemory(const Model& model, const RunSettings& settings, const LinearSolver& solver, int ranks,
                 const Comm& having, Diagnostics& diagnostics);

} // namespace ndframe
