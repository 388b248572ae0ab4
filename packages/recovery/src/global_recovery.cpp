#include "global_recovery.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "flow_settler.hpp"
#include "ndframe/algebra/threads.hpp"
#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/equilibrium/self_touching.hpp"
#include "ndframe/recovery/scene_pieces.hpp"
#include "recovery_progress.hpp"
#include "stress_descent.hpp"
#include "wrench_balance.hpp"

namespace ndframe
{
namespace
{

constexpr int highestDegree = 2;   ///< of stresses in space
constexpr int starsTogether = 128; ///< that are kept until they are added in order; 2 kB each

/// One recovery of all fields.
class GlobalStages
{
public:
  GlobalStages(const RecoveryScene& scene, const std::vector<SceneField>& fields, const DescentEnd& end,
               const Comm& comm, Ledger& ledger)
      : scene_(scene), fields_(fields), end_(end), comm_(comm), ledger_(ledger), threads_(numThreads(comm)),
        progress_(scene, end.leastGain, comm, ledger)
  {
    if (comm.size() > 1)
      pieces_ = cutScene(scene, optimises(), comm);
    for (const SceneField& field : fields) {
      stresses_.push_back({{}, field.tractions, pieces_});
      for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        stresses_.back().corrections.push_back(zeroCorrection(model(b).mesh, scene.data[b].degree));
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
      recover(elastic, pieces_ ? pieces_->patches : scene_.patches);
    else
      for (const int body : elastic)
        recover({body}, {});
    ledger_.count("recovery steps", steps_);
    const std::int64_t messages = comm_.sum(messages_), bytes = comm_.sum(bytes_);
    if (comm_.size() > 1) {
      ledger_.count("recovery messages", messages);
      ledger_.count("recovery bytes", bytes);
    }
    return std::move(stresses_);
  }

private:
  const BodyPiece* piece(std::size_t body) const { return pieces_ ? pieces_->bodies[body].get() : nullptr; }
  /// What this rank has of a body.
  const BodyModel& model(std::size_t b) const { return piece(b) ? piece(b)->model : *scene_.bodies[b]; }
  const StaticData& data(std::size_t b) const { return piece(b) ? piece(b)->data : scene_.data[b]; }

  void recover(const std::vector<int>& bodies, const std::vector<ContactPatch>& contact)
  {
    std::vector<std::unique_ptr<StarBody>> stars(scene_.bodies.size());
    std::vector<const StarBody*> pointers;
    std::vector<const BodyPiece*> pieces;
    for (const int body : bodies)
      stars[std::size_t(body)] = std::make_unique<StarBody>(model(std::size_t(body)), data(std::size_t(body)));
    for (const auto& star : stars)
      pointers.push_back(star.get());
    for (std::size_t b = 0; pieces_ && b < stars.size(); ++b)
      pieces.push_back(stars[b] ? piece(b) : nullptr);
    const StressCells cells =
        pieces_ ? StressCells(std::move(pointers), pieces, comm_) : StressCells(std::move(pointers));
    const StressFaces faces(cells, contact);
    for (const int body : bodies)
      balance(body, faces);
    const DescentWatch watch{[this] { progress_.cellIsRead(); }, [this](double gain) { progress_.stepIsTaken(gain); }};
    StressDescent descent(faces, contact, descentFields(), watch, comm_, threads_);
    const auto [allMatrices, mostMatrices] = descent.numMatrices();
    ledger_.count("cell matrices", allMatrices);
    steps_ += descent.lower(end_);
    if (pieces_) {
      ledger_.count("cell matrices of the largest rank", mostMatrices);
      fetchGhosts(bodies, descent.shared());
    }
    for (std::size_t f = 0; f < fields_.size(); ++f)
      if (changes(f))
        stresses_[f].tractions[1] = stresses_[f].tractions[0];
  }

  bool optimises() const
  {
    return std::any_of(fields_.begin(), fields_.end(), [](const SceneField& field) { return field.optimise; });
  }

  bool changes(std::size_t field) const { return fields_[field].optimise && end_.most > 0; }

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
      all[f].beside = fields_[f].beside;
      all[f].enough = fields_[f].enough;
    }
    return all;
  }

  /// All ranks stop where the mesh of a body touches itself.
  void balance(int body, const StressFaces& faces)
  {
    std::optional<int> touching; // a vertex of `piece`
    const BodyPiece* piece = this->piece(std::size_t(body));
    definiteOnEveryRank(comm_, [&] {
      try {
        balanceOwn(body, faces);
      } catch (const SelfTouching& place) {
        if (piece == nullptr)
          throw;
        touching = place.vertex;
      }
    });
    if (piece != nullptr)
      refuseTouching(piece->model, touching, comm_);
    BodyCorrections corrections;
    for (SceneStress& stress : stresses_)
      corrections.push_back(&stress.corrections[std::size_t(body)]);
    settleByFlows(body, faces, piece, corrections, comm_);
  }

  void balanceOwn(int body, const StressFaces& faces)
  {
    const auto b = std::size_t(body);
    std::vector<Vector> contact;
    std::vector<FieldInput> inputs;
    BodyCorrections corrections;
    for (const SceneField& field : fields_) {
      contact.push_back(contactShares(scene_.patches, field.tractions, body));
      if (piece(b) != nullptr)
        contact.back() = piece(b)->ofContact(contact.back());
    }
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      inputs.push_back({fields_[f].displacement[b], &contact[f]});
      corrections.push_back(&stresses_[f].corrections[b]);
    }
    WrenchBalance balance(body, faces, inputs, corrections, threads_);
    const std::vector<int> vertices = ownVertices(b);
    for (int first = 0, last = 0; first < int(vertices.size()); first = last) {
      last = std::min(first + starsTogether, int(vertices.size()));
      std::vector<WrenchBalance::Flows> balanced(std::size_t(last - first));
      runInRanges(last - first, threads_, [&](int from, int to) {
        for (int i = from; i < to; ++i) {
          balanced[std::size_t(i)] = balance.balance(vertices[std::size_t(first) + std::size_t(i)]);
          progress_.starIsBalanced();
        }
      });
      for (const WrenchBalance::Flows& star : balanced)
        balance.add(star);
    }
    balance.finish();
  }

  /// Those that an own cell has; other ranks do the stars of the others.
  std::vector<int> ownVertices(std::size_t body) const
  {
    const Mesh& mesh = model(body).mesh;
    std::vector<char> isOwn(std::size_t(mesh.numPoints()), 0);
    for (int cell = 0; cell < mesh.numCells(); ++cell)
      for (int i = 0; i < 4 && (piece(body) == nullptr || piece(body)->owns(cell)); ++i)
        isOwn[std::size_t(mesh.cell(cell)[i])] = 1;
    std::vector<int> vertices;
    for (int v = 0; v < mesh.numPoints(); ++v)
      if (isOwn[std::size_t(v)] != 0)
        vertices.push_back(v);
    return vertices;
  }

  void fetchGhosts(const std::vector<int>& bodies, const SharedValues& unknowns)
  {
    messages_ += unknowns.messages();
    bytes_ += unknowns.bytes();
    for (const int body : bodies) {
      const BodyPiece& own = *piece(std::size_t(body));
      for (SceneStress& stress : stresses_)
        own.fetchGhosts(stress.corrections[std::size_t(body)]);
    }
  }

  const RecoveryScene& scene_;
  const std::vector<SceneField>& fields_;
  DescentEnd end_;
  const Comm& comm_;
  Ledger& ledger_;
  int threads_;
  RecoveryProgress progress_;
  std::shared_ptr<const ScenePieces> pieces_; ///< null on a single process
  std::vector<SceneStress> stresses_;         ///< per field
  std::int64_t steps_ = 0;                    ///< of all descents
  std::int64_t messages_ = 0, bytes_ = 0;     ///< that this rank has sent
};

class GlobalRecovery final : public StressRecovery
{
public:
  GlobalRecovery(int degree, const DescentEnd& end) : degree_(degree), end_(end) {}

  std::vector<SceneStress> recover(const RecoveryScene& scene, const std::vector<SceneField>& fields, const Comm& comm,
                                   Ledger& ledger) const override
  {
    return GlobalStages(scene, fields, end_, comm, ledger).run();
  }

  int degree(int order) const override { return degree_ == 0 ? order : degree_; }

  bool optimises(int /*dim*/) const override { return true; }

  bool settles(int /*dim*/) const override { return true; }

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
  int degree_;
  DescentEnd end_;
};

} // namespace

std::unique_ptr<StressRecovery> makeGlobalRecovery(int degree, const DescentEnd& end)
{
  return std::make_unique<GlobalRecovery>(degree, end);
}

void registerGlobalRecovery(Registry<StressRecovery>& registry)
{
  registry.add(
      "Global",
      "Solids: all tractions of a body together, as many steps of conjugate gradients towards the minimum "
      "energy as lower the bound; faster and sharper than stars there.",
      {{"Degree", 0, inClosedRange(0, highestDegree),
        "Degree of the stresses: the order of the displacements or one more; 0 means the order."},
       {"Least Gain", usualEnd.leastGain, inClosedRange(0.0, 1.0),
        "Steps end when each lowers the bound by less than this share of it, in the mean of the last four; 0: "
        "all of Steps are taken. 0.01 takes some 11 on well-shaped cells and more where cells are stretched. With a "
        "target, a few more are taken where they will reach it."},
       {"Steps", usualEnd.most, atLeast(0), "No more steps of conjugate gradients than this."}},
      [](const Params& p) {
        return makeGlobalRecovery(p.get<int>("Degree"), {p.get<int>("Steps"), p.get<double>("Least Gain")});
      });
}

} // namespace ndframe
