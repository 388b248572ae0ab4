#include "interface_stars.hpp"

#include <utility>

namespace ndframe
{
namespace
{

/// Passes over the vertices in the initial pass; more change the bound in its third digit.
constexpr int passes = 3;

} // namespace

InterfaceStars::InterfaceStars(const RecoveryScene& scene, std::vector<const StarBody*> bodies)
    : scene_(scene), bodies_(std::move(bodies)), vertices_(interfaceVertices(scene))
{}

ContactTraction InterfaceStars::optimise(const SceneField& field, Ledger& ledger) const
{
  ContactTraction traction = field.onDirichlet;
  std::vector<Vector> contact;
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    contact.push_back(contactShares(scene_.facets, traction, field.onNeumann, int(body), bodies_[body]->dim()));
  std::vector<StarLoads> loads;
  for (std::size_t body = 0; body < bodies_.size(); ++body)
    loads.emplace_back(*bodies_[body], std::vector<FieldInput>{{field.displacement[body], &contact[body]}});

  std::vector<TractionStep> steps;
  for (const InterfaceVertex& vertex : vertices_) {
    const InterfaceStar star(scene_, bodies_, vertex);
    std::array<StarFields, 2> x;
    for (std::size_t s = 0; s < 2; ++s) {
      const InterfaceStar::Side& side = star.sides()[s];
      x[s] = loads[std::size_t(side.body)].initial(side.system.star());
      side.system.balance(x[s]);
    }
    steps.push_back(star.step(x, field.opening));
  }
  for (int pass = 0; pass < passes; ++pass)
    for (TractionStep& step : steps)
      step.apply(traction);
  ledger.count("interface stars", std::int64_t(passes) * std::int64_t(steps.size()));
  return traction;
}

void InterfaceStars::sweep(const Vector& opening, ContactTraction& traction,
                           const std::vector<StressCorrection*>& corrections, Ledger& ledger) const
{
  for (const InterfaceVertex& vertex : vertices_) {
    const InterfaceStar star(scene_, bodies_, vertex);
    std::array<StarFields, 2> x;
    for (std::size_t s = 0; s < 2; ++s) {
      const InterfaceStar::Side& side = star.sides()[s];
      x[s] = gather(*bodies_[std::size_t(side.body)], side.system.star(), {corrections[std::size_t(side.body)]});
    }
    const Vector change = star.step(x, opening).apply(traction);
    for (std::size_t s = 0; s < 2; ++s) {
      const InterfaceStar::Side& side = star.sides()[s];
      side.system.relax(x[s], DenseMatrix(side.own(change)));
      scatter(*bodies_[std::size_t(side.body)], side.system.star(), x[s], {corrections[std::size_t(side.body)]});
    }
  }
  ledger.count("interface stars", std::int64_t(vertices_.size()));
}

} // namespace ndframe
