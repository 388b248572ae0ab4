#include "interface_stars.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "ndframe/admissibility/turning_normal.hpp"
#include "ndframe/algebra/threads.hpp"

namespace ndframe
{
namespace
{

/// Passes over the vertices in the initial pass; more change the bound in its third digit.
constexpr int passes = 3;

/// Vertices that a thread takes at once.
constexpr int block = 4;

/// A vertex's change of t_N in what the stresses carry of it.
void addTurned(const EndTables& modes, const std::vector<ContactPatch>& patches, const InterfaceVertex& vertex,
               const Vector& change, ContactTraction& traction)
{
  const std::size_t size = change.size() / vertex.ends.size();
  auto first = change.begin();
  for (const PatchEnd& end : vertex.ends) {
    addTurned(modes, patches, std::size_t(end.patch), end.vertex, Vector(first, first + std::ptrdiff_t(size)),
              traction);
    first += std::ptrdiff_t(size);
  }
}

} // namespace

InterfaceStars::InterfaceStars(const RecoveryScene& scene, std::vector<const StarBody*> bodies)
    : scene_(scene), bodies_(std::move(bodies)), vertices_(interfaceVertices(scene))
{
  const auto meet = [&](const InterfaceVertex& vertex) { return starsMeet(scene_, bodies_, vertex); };
  vertices_.erase(std::remove_if(vertices_.begin(), vertices_.end(), meet), vertices_.end());
}

std::vector<TractionStep> InterfaceStars::firstSteps(const SceneField& field,
                                                     const std::vector<std::unique_ptr<StarLoads>>& loads,
                                                     int threads) const
{
  std::vector<std::optional<TractionStep>> found(vertices_.size());
  const auto last = int(vertices_.size());
  runConcurrently((last + block - 1) / block, threads, [&](int task) {
    for (int v = task * block; v < std::min(last, (task + 1) * block); ++v) {
      const InterfaceStar star(scene_, bodies_, vertices_[std::size_t(v)]);
      std::vector<StarFields> x(star.sides().size());
      Vector forces;
      for (std::size_t s = 0; s < x.size(); ++s) {
        const InterfaceStar::Side& side = star.sides()[s];
        x[s] = loads[std::size_t(side.body)]->initial(side.system.star(), forces);
        side.system.balance(x[s]);
      }
      found[std::size_t(v)] = star.step(x, field.opening);
    }
  });
  std::vector<TractionStep> steps;
  for (std::optional<TractionStep>& step : found)
    steps.push_back(std::move(*step));
  return steps;
}

ContactTraction InterfaceStars::optimise(const SceneField& field, int threads, Ledger& ledger) const
{
  ContactTraction traction = field.tractions[0];
  std::vector<Vector> contact;
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    contact.push_back(contactShares(scene_.patches, field.tractions, int(body)));
  std::vector<std::unique_ptr<StarLoads>> loads;
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    loads.push_back(bodies_[body] == nullptr
                        ? nullptr
                        : std::make_unique<StarLoads>(
                              *bodies_[body], std::vector<FieldInput>{{field.displacement[body], &contact[body]}}));

  std::vector<TractionStep> steps = firstSteps(field, loads, threads);
  const EndTables turning = turningModes(2, traction.degree, traction.degree);
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t v = 0; v < vertices_.size(); ++v)
      addTurned(turning, scene_.patches, vertices_[v], steps[v].apply(traction), traction);
  ledger.count("interface stars", std::int64_t(passes) * std::int64_t(steps.size()));
  return traction;
}

void InterfaceStars::sweep(const Vector& opening, ContactTraction& traction,
                           const std::vector<StressCorrection*>& corrections, Ledger& ledger) const
{
  const EndTables turning = turningModes(2, traction.degree, traction.degree);
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    const InterfaceVertex& vertex = vertices_[v % 2 == 0 ? v / 2 : vertices_.size() - 1 - v / 2];
    const InterfaceStar star(scene_, bodies_, vertex);
    std::vector<StarFields> x(star.sides().size());
    for (std::size_t s = 0; s < x.size(); ++s) {
      const InterfaceStar::Side& side = star.sides()[s];
      x[s] = gather(*bodies_[std::size_t(side.body)], side.system.star(), {corrections[std::size_t(side.body)]});
    }
    const Vector change = star.step(x, opening).apply(traction);
    addTurned(turning, scene_.patches, vertex, change, traction);
    for (std::size_t s = 0; s < x.size(); ++s) {
      const InterfaceStar::Side& side = star.sides()[s];
      side.system.relax(x[s], multiply(side.released, DenseMatrix(change)));
      scatter(*bodies_[std::size_t(side.body)], side.system.star(), x[s], {corrections[std::size_t(side.body)]});
    }
  }
  ledger.count("interface stars", std::int64_t(vertices_.size()));
}

} // namespace ndframe
