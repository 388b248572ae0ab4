#include "star_recovery.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "body_stars.hpp"
#include "interface_stars.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/equilibrium/cell_form.hpp"

namespace ndframe
{
namespace
{

/// Of the interface stars after the solution of all stars, where no sweep follows, which does more. The first takes
/// most of what they can lower, a third changes the bound by a thousandth of itself; they cost little, as these stars
/// are few.
constexpr int interfacePasses = 2;

/// One recovery of all fields on all bodies, stage by stage.
class StarStages
{
public:
  StarStages(const RecoveryScene& scene, const std::vector<SceneField>& fields, const Comm& comm, Ledger& ledger)
      : scene_(scene), fields_(fields), comm_(comm), ledger_(ledger)
  {
    for (std::size_t body = 0; body < scene.bodies.size(); ++body)
      bodies_.push_back(
          scene.bodies[body]->isRigid ? nullptr : std::make_unique<BodyStars>(*scene.bodies[body], scene.data[body]));
    for (const SceneField& field : fields)
      stresses_.push_back({{}, field.tractions});
    if (std::any_of(fields.begin(), fields.end(), [](const SceneField& field) { return field.optimise; })) {
      std::vector<const StarBody*> starBodies;
      for (const auto& body : bodies_)
        starBodies.push_back(body ? &body->body() : nullptr);
      interfaces_.emplace(scene, std::move(starBodies));
    }
  }

  void chooseTractions()
  {
    for (std::size_t field = 0; field < fields_.size(); ++field)
      if (fields_[field].optimise)
        stresses_[field].tractions.fill(interfaces_->optimise(fields_[field], threads(), ledger_));
  }

  void solveStars()
  {
    corrections_.resize(bodies_.size());
    forEachBody([this](std::size_t body) {
      std::vector<Vector> contact;
      for (const SceneStress& stress : stresses_)
        contact.push_back(contactShares(scene_.patches, stress.tractions, int(body)));
      std::vector<FieldInput> inputs;
      for (std::size_t field = 0; field < fields_.size(); ++field)
        inputs.push_back({fields_[field].displacement[body], &contact[field]});
      if (bodies_[body])
        corrections_[body] = bodies_[body]->solve(inputs, comm_, ledger_);
      else
        corrections_[body].assign(fields_.size(), zeroCorrection(scene_.bodies[body]->mesh, scene_.data[body].degree));
    });
  }

  /// The interface stars of the fields whose tractions may change.
  void relaxInterfaces()
  {
    for (std::size_t field = 0; field < fields_.size(); ++field) {
      if (!fields_[field].optimise)
        continue;
      std::vector<StressCorrection*> ofField;
      for (std::vector<StressCorrection>& body : corrections_)
        ofField.push_back(&body[field]);
      interfaces_->sweep(fields_[field].opening, stresses_[field].tractions[0], ofField, ledger_);
      stresses_[field].tractions[1] = stresses_[field].tractions[0];
    }
  }

  /// All stars of the bodies with their tractions as they are, then the interface stars.
  void sweep()
  {
    forEachBody([this](std::size_t body) {
      if (bodies_[body])
        bodies_[body]->sweep(corrections_[body], comm_, ledger_);
    });
    relaxInterfaces();
    ledger_.count("star sweeps");
  }

  std::vector<SceneStress> finish()
  {
    for (std::vector<StressCorrection>& body : corrections_)
      for (std::size_t field = 0; field < fields_.size(); ++field)
        stresses_[field].corrections.push_back(std::move(body[field]));
    return std::move(stresses_);
  }

private:
  /// At the same time; ranks, which share out the stars of each body, one after the other.
  template <class Work>
  void forEachBody(const Work& work)
  {
    std::vector<int> sizes;
    for (const BodyModel* body : scene_.bodies)
      sizes.push_back(body->numDofs());
    runLargestFirst(sizes, threads(), [&](int body) { work(std::size_t(body)); });
  }

  int threads() const { return comm_.size() > 1 ? 1 : numThreads(comm_); }

  const RecoveryScene& scene_;
  const std::vector<SceneField>& fields_;
  const Comm& comm_;
  Ledger& ledger_;
  std::vector<std::unique_ptr<BodyStars>> bodies_;         ///< null for rigid ones
  std::optional<InterfaceStars> interfaces_;               ///< when a field's traction may be changed
  std::vector<SceneStress> stresses_;                      ///< per field
  std::vector<std::vector<StressCorrection>> corrections_; ///< per body, per field
};

class StarRecovery final : public StressRecovery
{
public:
  StarRecovery(int degree, int sweeps) : degree_(degree), sweeps_(sweeps) {}

  std::vector<SceneStress> recover(const RecoveryScene& scene, const std::vector<SceneField>& fields, const Comm& comm,
                                   Ledger& ledger) const override
  {
    StarStages stages(scene, fields, comm, ledger);
    stages.chooseTractions();
    stages.solveStars();
    for (int pass = 0; pass < interfacePasses && sweeps_ == 0; ++pass)
      stages.relaxInterfaces();
    for (int sweep = 0; sweep < sweeps_; ++sweep)
      stages.sweep();
    return stages.finish();
  }

  int degree(int order) const override { return degree_ == 0 ? order : degree_; }

  bool optimises(int dim) const override { return dim == 2; }

  std::string refusal(int dim, int order, bool optimise) const override
  {
    const int highest = dim == 2 ? order + 1 : 2;
    if (degree(order) < order || degree(order) > highest)
      return fmt::format("Degree = {} does not suit displacements of order {} in {} dimensions; it may be {}", degree_,
                         order, dim,
                         order == highest ? fmt::format("{}", order) : fmt::format("{} or {}", order, highest));
    if (optimise && !optimises(dim))
      return "stars choose the traction between bodies in two dimensions only; choose Type Global, or Interface "
             "Traction/Type Projected";
    return {};
  }

private:
  int degree_, sweeps_;
};

} // namespace

std::unique_ptr<StressRecovery> makeStarRecovery(int degree, int sweeps)
{
  return std::make_unique<StarRecovery>(degree, sweeps);
}

void registerStarRecovery(Registry<StressRecovery>& registry)
{
  registry.add(
      "Star",
      "Minimum energy on the star (patch) of every vertex, all loads carried exactly; sharp also on stretched meshes.",
      {{"Degree", 0, inClosedRange(0, 3),
        "Degree of the stresses: the order of the displacements or one more; 0 means the order."},
       {"Sweeps", 0, atLeast(0),
        "Sweeps over the stars that lower the bound further; each costs about as much as the recovery itself."}},
      [](const Params& p) { return makeStarRecovery(p.get<int>("Degree"), p.get<int>("Sweeps")); });
}

} // namespace ndframe
