#include "element_recovery.hpp"

#include <fmt/format.h>

#include "element_tractions.hpp"
#include "ndframe/equilibrium/cell_form.hpp"

namespace ndframe
{
namespace
{

/// Stresses by element equilibration (element_tractions.hpp), body by body. Every rank finds all of them: a small part
/// of the work of an estimate.
class ElementRecovery final : public StressRecovery
{
public:
  explicit ElementRecovery(int degree) : degree_(degree) {}

  int degree(int order) const override { return degree_ == 0 ? order : degree_; }
  bool optimises(int /*dim*/) const override { return false; }
  std::string refusal(int dim, int order, bool optimise) const override;
  std::vector<SceneStress> recover(const RecoveryScene& scene, const std::vector<SceneField>& fields, const Comm& comm,
                                   Ledger& ledger) const override;

private:
  int degree_;
};

std::string ElementRecovery::refusal(int dim, int order, bool optimise) const
{
  if (dim != 2)
    return "element equilibration is defined in two dimensions only; choose Type Automatic";
  if (degree(order) < order || degree(order) > order + 1)
    return fmt::format("Degree = {} does not suit displacements of order {}; it may be {} or {}", degree_, order, order,
                       order + 1);
  if (optimise)
    return "element equilibration takes the traction between the bodies as it is; choose Type Star, or Interface "
           "Traction/Type Projected";
  return {};
}

std::vector<SceneStress> ElementRecovery::recover(const RecoveryScene& scene, const std::vector<SceneField>& fields,
                                                  const Comm&, Ledger& ledger) const
{
  std::vector<EdgeMap> edges;
  for (const BodyModel* body : scene.bodies)
    edges.push_back(body->isRigid ? EdgeMap() : edgeMap(*body));
  std::vector<SceneStress> stresses;
  for (const SceneField& field : fields) {
    NDFRAME_ASSERT(!field.optimise, "refusal() says that tractions are not optimised");
    stresses.push_back({{}, field.tractions});
    for (std::size_t body = 0; body < scene.bodies.size(); ++body) {
      if (scene.bodies[body]->isRigid) {
        stresses.back().corrections.push_back(zeroCorrection(scene.bodies[body]->mesh, scene.data[body].degree));
        continue;
      }
      const Vector contact = contactShares(scene.patches, field.tractions, int(body));
      stresses.back().corrections.push_back(equilibrateElements(edges[body], *scene.bodies[body], scene.data[body],
                                                                {field.displacement[body], &contact}));
      ledger.count("element problems", scene.bodies[body]->mesh.numCells());
    }
  }
  return stresses;
}

} // namespace

void registerElementRecovery(Registry<StressRecovery>& registry)
{
  registry.add(
      "Element",
      "Element equilibration (Ladeveze, Pelle and Rougeot 1991): edge tractions from nodal forces, plane bodies; "
      "cheap, less sharp than stars, poor on stretched meshes.",
      {{"Degree", 0, inClosedRange(0, 3),
        "Degree of the stresses: the order of the displacements or one more; 0 means the order."}},
      [](const Params& p) { return std::make_unique<ElementRecovery>(p.get<int>("Degree")); });
}

} // namespace ndframe
