#include "global_recovery.hpp"

#include <algorithm>
#include <atomic>

#include <fmt/format.h>

#include "ndframe/algebra/threads.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "stress_descent.hpp"
#include "wrench_balance.hpp"

namespace ndframe
{
namespace
{

constexpr int highestDegree = 2;   ///< of stresses in space
constexpr int starsTogether = 128; ///< that are kept until they are added in order; 16 kB each

/// Tells how many stars are in balance, then how many cells have their matrices, then how many steps are taken. Any
/// thread may say so.
class RecoveryProgress
{
public:
  RecoveryProgress(const RecoveryScene& scene, std::size_t descents, int steps, const Comm& comm, Ledger& ledger)
      : ledger_(ledger), steps_(std::int64_t(descents) * steps)
  {
    for (const BodyModel* body : scene.bodies)
      if (!body->isRigid) {
        stars_ += body->mesh.numPoints();
        cells_ += body->mesh.numCells() / comm.size(); // of this rank
      }
  }

  void starIsBalanced() { tell("star", ++balanced_, stars_); }
  void cellIsRead() { tell("cell", ++read_, cells_); }
  void stepIsTaken() { tell("step", ++taken_, steps_); }

private:
  void tell(const char* name, std::int64_t number, std::int64_t of)
  {
    ledger_.tell(Depth::Step, Progress::part(name, number, of, double(number) / double(of)));
  }

  Ledger& ledger_;
  std::int64_t stars_ = 0, cells_ = 0, steps_;
  std::atomic<std::int64_t> balanced_ = 0, read_ = 0, taken_ = 0;
};

/// One recovery of all fields.
class GlobalStages
{
public:
  GlobalStages(const RecoveryScene& scene, const std::vector<SceneField>& fields, int steps, const Comm& comm,
               Ledger& ledger)
      : scene_(scene), fields_(fields), steps_(steps), comm_(comm), ledger_(ledger), threads_(numThreads(comm)),
        progress_(scene, fields.size() * (optimises() ? 1 : numElastic()), steps, comm, ledger)
  {
    for (const SceneField& field : fields) {
      stresses_.push_back({{}, field.tractions});
      for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        stresses_.back().corrections.push_back(zeroCorrection(scene.bodies[b]->mesh, scene.data[b].degree));
    }
  }

  /// Bodies whose tractions may change together are recovered together, the others one by one.
  std::vector<SceneStress> run()
  {
    std::vector<int> elastic;
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
      if (!scene_.bodies[b]->isRigid)
        elastic.push_back(int(b));
    if (optimises())
      recover(elastic, scene_.patches);
    else
      for (const int body : elastic)
        recover({body}, {});
    return std::move(stresses_);
  }

private:
  void recover(const std::vector<int>& bodies, const std::vector<ContactPatch>& contact)
  {
    std::vector<std::unique_ptr<StarBody>> stars(scene_.bodies.size());
    std::vector<const StarBody*> pointers;
    for (const int body : bodies)
      stars[std::size_t(body)] =
          std::make_unique<StarBody>(*scene_.bodies[std::size_t(body)], scene_.data[std::size_t(body)]);
    for (const auto& star : stars)
      pointers.push_back(star.get());
    const StressCells cells(std::move(pointers));
    const StressFaces faces(cells, contact);
    for (const int body : bodies)
      balance(body, faces);
    const DescentWatch watch{[this] { progress_.cellIsRead(); }, [this] { progress_.stepIsTaken(); }};
    StressDescent descent(faces, contact, descentFields(), watch, comm_, threads_);
    ledger_.count("cell matrices", descent.numMatrices());
    descent.lower(steps_);
    for (std::size_t f = 0; f < fields_.size(); ++f)
      if (changes(f))
        stresses_[f].tractions[1] = stresses_[f].tractions[0];
  }

  bool optimises() const
  {
    return std::any_of(fields_.begin(), fields_.end(), [](const SceneField& field) { return field.optimise; });
  }

  std::size_t numElastic() const
  {
    return std::size_t(std::count_if(scene_.bodies.begin(), scene_.bodies.end(),
                                     [](const BodyModel* body) { return !body->isRigid; }));
  }

  bool changes(std::size_t field) const { return fields_[field].optimise && steps_ > 0; }

  std::vector<DescentField> descentFields()
  {
    std::vector<DescentField> all(fields_.size());
    for (std::size_t f = 0; f < all.size(); ++f) {
      for (StressCorrection& correction : stresses_[f].corrections)
        all[f].corrections.push_back(&correction);
      if (changes(f)) {
        all[f].traction = &stresses_[f].tractions[0];
        all[f].opening = &fields_[f].opening;
      }
    }
    return all;
  }

  void balance(int body, const StressFaces& faces)
  {
    const auto b = std::size_t(body);
    std::vector<Vector> contact;
    std::vector<FieldInput> inputs;
    BodyCorrections corrections;
    for (const SceneField& field : fields_)
      contact.push_back(contactShares(scene_.patches, field.tractions, body));
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      inputs.push_back({fields_[f].displacement[b], &contact[f]});
      corrections.push_back(&stresses_[f].corrections[b]);
    }
    const StarBody& stars = faces.cells().body(body);
    StarLoads loads(stars, inputs);
    loads.keepStresses(threads_);
    const WrenchBalance balance(body, faces);
    const int vertices = scene_.bodies[b]->mesh.numPoints();
    for (int first = 0, last = 0; first < vertices; first = last) {
      last = std::min(first + starsTogether, vertices);
      std::vector<BalancedStar> balanced(std::size_t(last - first));
      runInRanges(last - first, threads_, [&](int from, int to) {
        for (int i = from; i < to; ++i) {
          balanced[std::size_t(i)] = balancedStar(stars.star(first + i), loads, balance);
          progress_.starIsBalanced();
        }
      });
      for (const BalancedStar& star : balanced)
        addTo(stars, star, corrections);
    }
  }

  struct BalancedStar
  {
    Star star;
    StarFields x;
    Vector left, force; ///< per field
  };

  static BalancedStar balancedStar(Star star, const StarLoads& loads, const WrenchBalance& balance)
  {
    BalancedStar result{std::move(star), {}, {}, {}};
    result.x = loads.initial(result.star, result.force);
    result.left = balance.balance(result.star, result.x);
    return result;
  }

  static void addTo(const StarBody& stars, const BalancedStar& star, const BodyCorrections& corrections)
  {
    add(stars, star.star, star.x, corrections);
    for (std::size_t f = 0; f < corrections.size(); ++f) {
      corrections[f]->imbalance = std::max(corrections[f]->imbalance, star.left[f]);
      corrections[f]->force = std::max(corrections[f]->force, star.force[f]);
    }
  }

  const RecoveryScene& scene_;
  const std::vector<SceneField>& fields_;
  int steps_;
  const Comm& comm_;
  Ledger& ledger_;
  int threads_;
  RecoveryProgress progress_;
  std::vector<SceneStress> stresses_; ///< per field
};

class GlobalRecovery final : public StressRecovery
{
public:
  GlobalRecovery(int degree, int steps) : degree_(degree), steps_(steps) {}

  std::vector<SceneStress> recover(const RecoveryScene& scene, const std::vector<SceneField>& fields, const Comm& comm,
                                   Ledger& ledger) const override
  {
    GlobalStages stages(scene, fields, steps_, comm, ledger);
    std::vector<SceneStress> stresses = stages.run();
    ledger.count("recovery steps", std::int64_t(steps_) * std::int64_t(fields.size()));
    return stresses;
  }

  int degree(int order) const override { return degree_ == 0 ? order : degree_; }

  bool optimises(int /*dim*/) const override { return true; }

  std::string refusal(int dim, int order, bool /*optimise*/) const override
  {
    if (dim != 3)
      return "Global is defined for solids; choose Star";
    if (degree(order) < order || degree(order) > highestDegree)
      return fmt::format("Degree = {} does not suit displacements of order {} in 3 dimensions; it may be {}", degree_,
                         order, order == highestDegree ? "2" : "1 or 2");
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
               "Solids: all tractions of a body together, some steps of conjugate gradients towards the minimum "
               "energy; faster and sharper than stars there.",
               {{"Degree", 0, inClosedRange(0, highestDegree),
                 "Degree of the stresses: the order of the displacements or one more; 0 means the order."},
                {"Steps", 10, atLeast(0), "Steps of conjugate gradients; 20 are a few per cent sharper than 10."}},
               [](const Params& p) { return makeGlobalRecovery(p.get<int>("Degree"), p.get<int>("Steps")); });
}

} // namespace ndframe
