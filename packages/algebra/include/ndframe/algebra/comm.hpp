#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ndframe
{

class Ledger;

/// Numbers of any unit, one after the other.
using Vector = std::vector<double>;

/// The processes of a run. A run without mpirun has one and starts no MPI; MPI itself is started on first need only.
/// A program that has its own processes hands in their communicator.
///
/// All functions are collective.
class Comm
{
public:
  /// Joins the processes that mpirun started (recognised by the launcher's environment); else a single process.
  static Comm world(int& argc, char**& argv);
  /// The processes of a communicator, as MPI_Comm_c2f gives it; it must live as long as the run. Several at a time, one
  /// for each part of a program's processes, do not disturb each other.
  static Comm of(int communicator);
  /// Those of the processes that name the same colour, in the same order. Collective; lasts until MPI ends.
  Comm split(int colour) const;
  /// One process, no MPI.
  static Comm single() { return Comm(0, 1, 0); }

  int rank() const { return rank_; } ///< number of this process, from 0
  int size() const { return size_; } ///< number of processes
  /// As MPI_Comm_c2f gives it; means nothing on a single process.
  int communicator() const { return communicator_; }

  /// Element-wise sum over ranks, the result on every rank.
  void sum(Vector& values) const;
  std::int64_t sum(std::int64_t value) const; ///< the sum over ranks, on every rank
  /// Rank 0's value on every rank.
  void broadcast(Vector& values) const;
  void broadcast(std::string& text) const; ///< rank 0's text on every rank
  /// Ends all processes of a run at once, where one has failed in a way that the others do not know of: they would wait
  /// for it in the next collective call. Does nothing on a single process.
  void abort(int exitCode) const;

private:
  Comm(int rank, int size, int communicator) : rank_(rank), size_(size), communicator_(communicator) {}
  int rank_;
  int size_;
  int communicator_;
};

/// Enters in the ledger what all ranks got from all of them since the last call: "reductions", which are sums, extremes
/// and gathered lists, "reduction bytes" of their results, and "largest reduction", bytes. What libraries reduce for
/// themselves is not counted, nor what one rank sends to all. Enters nothing where there is one rank.
void countReductions(Ledger& ledger);

/// Starts MPI if it is not running (MUMPS needs it even on one rank). Finalised at exit by finishMpi().
void startMpi();
/// Whether startMpi(), or a launcher, has started it, and it has not ended.
bool mpiIsRunning();
/// Ends MPI and what needs it, if they were started; called once at the end of main.
void finishMpi();
/// What finishMpi() calls first.
void beforeMpiEnds(void (*end)());

} // namespace ndframe
