#include "global_recovery.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "stress_descent.hpp"
#include "wrench_balance.hpp"

namespace ndframe
{
namespace
{

constexpr int highestDegree = 2; ///< of stresses in space

/// Corrections of one body, one per field.
std::vector<StressCorrection> recoverBody(const BodyModel& model, const StaticData& data,
                                          const std::vector<FieldInput>& fields, int steps)
{
  const StarBody body(model, data);
  const StressFaces faces(body);
  std::vector<StressCorrection> corrections(fields.size(), zeroCorrection(model.mesh, data.degree));
  BodyCorrections pointers;
  for (StressCorrection& correction : corrections)
    pointers.push_back(&correction);
  {
    const StarLoads loads(body, fields);
    const WrenchBalance balance(body, faces);
    for (int vertex = 0; vertex < model.mesh.numPoints(); ++vertex) {
      const Star star = body.star(vertex);
      StarFields x = loads.initial(star);
      const Vector left = balance.balance(star, x), force = loads.forces(star);
      add(body, star, x, pointers);
      for (std::size_t field = 0; field < fields.size(); ++field) {
        corrections[field].imbalance = std::max(corrections[field].imbalance, left[field]);
        corrections[field].force = std::max(corrections[field].force, force[field]);
      }
    }
  }
  const StressDescent descent(body, faces);
  for (StressCorrection& correction : corrections)
    descent.lower(correction, steps);
  return corrections;
}

class GlobalRecovery final : public StressRecovery
{
public:
  GlobalRecovery(int degree, int steps) : degree_(degree), steps_(steps) {}

  std::vector<SceneStress> recover(const RecoveryScene& scene, const std::vector<SceneField>& fields, const Comm& comm,
                                   Ledger& ledger) const override
  {
    std::vector<SceneStress> stresses;
    std::vector<int> sizes;
    for (const SceneField& field : fields)
      stresses.push_back({std::vector<StressCorrection>(scene.bodies.size()), field.onDirichlet, field.onNeumann});
    for (const BodyModel* body : scene.bodies)
      sizes.push_back(body->numDofs());
    runLargestFirst(sizes, comm.size() > 1 ? 1 : numThreads(comm), [&](int number) {
      const auto b = std::size_t(number);
      const BodyModel& body = *scene.bodies[b];
      std::vector<Vector> contact;
      for (const SceneField& field : fields)
        contact.push_back(contactShares(scene.facets, field.onDirichlet, field.onNeumann, number));
      std::vector<FieldInput> inputs;
      for (std::size_t f = 0; f < fields.size(); ++f)
        inputs.push_back({fields[f].displacement[b], &contact[f]});
      auto corrections =
          body.isRigid ? std::vector<StressCorrection>(fields.size(), zeroCorrection(body.mesh, scene.data[b].degree))
                       : recoverBody(body, scene.data[b], inputs, steps_);
      for (std::size_t f = 0; f < fields.size(); ++f)
        stresses[f].corrections[b] = std::move(corrections[f]);
    });
    ledger.count("recovery steps", std::int64_t(steps_) * std::int64_t(fields.size()));
    return stresses;
  }

  int degree(int order) const override { return degree_ == 0 ? order : degree_; }

  std::string refusal(int dim, int order, bool optimise) const override
  {
    if (dim != 3)
      return "Global is defined for solids; choose Star";
    if (degree(order) < order || degree(order) > highestDegree)
      return fmt::format("Degree = {} does not suit displacements of order {} in 3 dimensions; it may be {}", degree_,
                         order, order == highestDegree ? "2" : "1 or 2");
    if (optimise)
      return "the traction between bodies can be optimised in two dimensions only; choose the projected one";
    return {};
  }

private:
  int degree_, steps_;
};

} // namespace

std::unique_ptr<StressRecovery> makeGlobalRecovery(int degree, int steps)
{
  return std::make_unique<GlobalRecovery>(degree, steps);
}

void registerGlobalRecovery(Registry<StressRecovery>& registry)
{
  registry.add("Global",
               "Solids: all tractions of a body together, some steps of conjugate gradients towards the least energy; "
               "faster and sharper than stars there.",
               {{"Degree", 0, inClosedRange(0, highestDegree),
                 "Degree of the stresses: the order of the displacements or one more; 0 means the order."},
                {"Steps", 10, atLeast(0), "Steps of conjugate gradients; 20 are a few per cent sharper than 10."}},
               [](const Params& p) { return makeGlobalRecovery(p.get<int>("Degree"), p.get<int>("Steps")); });
}

} // namespace ndframe
