#include "linear_start.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr double enough = 1e-2;      ///< the residual of each pass
constexpr double fewWrong = 1e-2;    ///< of all conditions at vertices: the rest changes on all nodes anyway
constexpr int mostPasses = 40;       ///< and where it takes more, it does not help
constexpr int mostLoose = 6;         ///< passes in a row whose closed conditions do not hold the bodies
constexpr double leastSpring = 1e-6; ///< of them, relative to the stiffness

/// The passes.
class VertexContact
{
public:
  VertexContact(const WholeRows& rows, JoinedSystem& joined, const std::vector<const SparseField*>& loads,
                std::vector<char>& levelClosed)
      : rows_(rows), joined_(joined), loads_(loads), levelClosed_(levelClosed),
        v_(std::size_t(rows.network().size()), 0.0), kept_(v_)
  {
    joined_.beginOnVertices(rows_.onVertices(rows_.closedOnVertices(std::vector<char>(rows_.ends().size(), 0))));
  }

  /// The conditions that contradict their statuses.
  std::vector<int> pass(const std::vector<char>& statuses, double springs)
  {
    const Network& network = rows_.network();
    const ClosedRows closed = rows_.closedOnVertices(statuses);
    if (joined_.followOnVertices(rows_.onVertices(closed), springs))
      levelClosed_ = statuses;
    v_ = atStatuses(closed, v_);
    kept_ = rows_.kept(v_);
    const Vector rest = joined_.solveOnVertices(loads_, kept_, enough);
    v_ = rows_.values(kept_);
    StatusPass found;
    found.u = rowValues(rows_.vertexJump(), Vector(rows_.vertexJump().size(), 0.0), v_);
    found.force = closed.forces(rows_.forces(rest));
    found.displacement = largestEntry(v_);
    for (const SparseField* load : loads_)
      found.load = std::max(found.load, load->largest());
    return violations(found, rows_.atVertex(), network.bound, statuses);
  }

private:
  const WholeRows& rows_;
  JoinedSystem& joined_;
  const std::vector<const SparseField*>& loads_;
  std::vector<char>& levelClosed_;
  Vector v_, kept_; ///< the entries, and the kept dofs, of use at vertices only
};

/// The statuses at vertices, the others open.
std::vector<char> onlyAtVertices(const WholeRows& rows, std::vector<char> closed)
{
  for (std::size_t i = 0; i < closed.size(); ++i)
    closed[i] = char(closed[i] && rows.atVertex()[i]);
  return closed;
}

/// False where the loads do not press the bodies together.
bool settle(VertexContact& contact, const std::function<bool(const std::vector<char>&)>& holds, std::size_t few,
            Ledger& ledger, std::vector<char>& closed)
{
  std::set<std::vector<char>> seen;
  int loose = 0;
  for (int number = 1; number <= mostPasses && seen.insert(closed).second; ++number) {
    loose = holds(closed) ? 0 : loose + 1;
    if (loose > mostLoose)
      return false;
    ledger.tell(Depth::Pass, {"pass on the vertices", number});
    ledger.count("vertex passes");
    const std::vector<int> wrong = contact.pass(closed, loose == 0 ? 0.0 : std::max(leastSpring, std::pow(0.1, loose)));
    for (const int i : wrong)
      closed[std::size_t(i)] = !closed[std::size_t(i)];
    if (loose == 0 && wrong.size() <= few)
      return true;
  }
  return holds(closed);
}

} // namespace

bool settleOnVertices(const WholeRows& rows, JoinedSystem& joined, const std::vector<const SparseField*>& loads,
                      const std::function<bool(const std::vector<char>&)>& holds, Ledger& ledger,
                      std::vector<char>& closed, std::vector<char>& levelClosed)
{
  const auto vertices = std::count(rows.atVertex().begin(), rows.atVertex().end(), char(1));
  std::vector<char> found = onlyAtVertices(rows, closed);
  if (vertices == 0)
    return false;
  try {
    VertexContact contact(rows, joined, loads, levelClosed);
    if (!settle(contact, holds, std::size_t(fewWrong * double(vertices)), ledger, found))
      return false;
  } catch (const NotConverged&) {
    return false;
  } catch (const SingularBody&) {
    return false;
  }
  closed = found;
  return true;
}

void takeMiddles(const WholeRows& rows, const Vector& v, std::vector<char>& closed)
{
  const Network& network = rows.network();
  const Vector u = rowValues(network.jump, Vector(network.jump.size(), 0.0), v);
  const double noGap = statusRoundOff * std::max(largestEntry(v), largestEntry(network.bound));
  for (std::size_t i = 0; i < closed.size(); ++i) {
    if (rows.atVertex()[i])
      continue;
    const auto& ends = rows.ends()[i];
    int known = 0, shut = 0;
    for (const int end : ends)
      if (end >= 0) {
        ++known;
        shut += closed[std::size_t(end)] != 0;
      }
    closed[i] = char((known > 0 && shut == known) || u[i] - network.bound[i] > noGap);
  }
}

Vector atStatuses(const ClosedRows& closed, const Vector& v)
{
  Vector free(std::size_t(closed.numFree()));
  for (std::size_t entry = 0; entry < v.size(); ++entry)
    if (const int number = closed.freeNumber()[entry]; number >= 0)
      free[std::size_t(number)] = v[entry];
  return closed.expanded(free);
}

} // namespace ndframe
