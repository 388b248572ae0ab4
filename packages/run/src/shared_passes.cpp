#include "ndframe/run/shared_passes.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "ndframe/algebra/exchanged_values.hpp"
#include "ndframe/base/byte_hash.hpp"
#include "ndframe/base/diagnostics.hpp"

namespace ndframe
{
namespace
{

constexpr std::size_t axes = 3;
using Place = std::array<double, axes>;

std::string hashOf(const std::vector<InterfaceMesh>& interfaces)
{
  std::uint64_t hash = byteHash(nullptr, 0);
  for (const InterfaceMesh& interface : interfaces)
    for (const double value : interface.points) {
      const double coordinate = value + 0.0; // no zeros with a sign
      hash = byteHash(&coordinate, sizeof(double), hash);
    }
  return fmt::format("{:016x}", hash);
}

/// The bodies whose fields passes have: those that touch others.
std::vector<const BodyModel*> bodiesOf(const Model& model)
{
  std::vector<const BodyModel*> bodies;
  for (const int b : model.elasticBodies())
    if (model.touches(b))
      bodies.push_back(&model.bodies[std::size_t(b)]);
  return bodies;
}

/// Of the nodes that this rank has fields at: its own ones, or all.
Vector heldPlaces(const BodyModel& body)
{
  Vector places;
  const auto add = [&](int node) {
    const auto x = body.nodes.point(node);
    for (std::size_t k = 0; k < axes; ++k)
      places.push_back(k < std::size_t(body.mesh.dim) ? x[k] + 0.0 : 0.0); // no zeros with a sign
  };
  if (body.share)
    for (const int node : body.share->ownNodes())
      add(node);
  else
    for (int node = 0; node < body.nodes.numNodes(); ++node)
      add(node);
  return places;
}

/// Which rank answers for the nodes at a place.
std::size_t homeOf(const double* place, int ranks)
{
  return std::size_t(byteHash(place, axes * sizeof(double)) % std::uint64_t(ranks));
}

/// Values at places, each on some rank, and what their homes know of them.
class Directory
{
public:
  Directory(const Vector& places, const Vector& values, std::size_t width, const Comm& comm)
      : width_(width), comm_(comm)
  {
    std::vector<Vector> sent(std::size_t(comm.size()));
    for (std::size_t i = 0; i * axes < places.size(); ++i) {
      const double* const place = places.data() + i * axes;
      Vector& message = sent[homeOf(place, comm.size())];
      message.insert(message.end(), place, place + axes);
      const auto first = values.begin() + std::ptrdiff_t(i) * std::ptrdiff_t(width);
      message.insert(message.end(), first, first + std::ptrdiff_t(width));
    }
    for (const Vector& message : exchangedValues(sent, comm))
      for (std::size_t at = 0; at < message.size(); at += axes + width)
        known_[placeAt(message, at)] = {message.begin() + std::ptrdiff_t(at + axes),
                                        message.begin() + std::ptrdiff_t(at + axes + width)};
  }

  /// The values at these places; false where some are not known, on every rank.
  bool find(const Vector& places, Vector& values) const
  {
    std::vector<Vector> wanted(std::size_t(comm_.size()));
    std::vector<std::vector<std::size_t>> numbers(wanted.size()); // of the places that are asked for
    for (std::size_t i = 0; i * axes < places.size(); ++i) {
      const double* const place = places.data() + i * axes;
      const std::size_t home = homeOf(place, comm_.size());
      wanted[home].insert(wanted[home].end(), place, place + axes);
      numbers[home].push_back(i);
    }
    std::vector<Vector> answers(wanted.size());
    std::int64_t missing = 0;
    const std::vector<Vector> asked = exchangedValues(wanted, comm_);
    for (std::size_t rank = 0; rank < asked.size(); ++rank)
      for (std::size_t at = 0; at < asked[rank].size(); at += axes) {
        const auto found = known_.find(placeAt(asked[rank], at));
        missing += found == known_.end() ? 1 : 0;
        const Vector value = found == known_.end() ? Vector(width_, 0.0) : found->second;
        answers[rank].insert(answers[rank].end(), value.begin(), value.end());
      }
    answers = exchangedValues(answers, comm_);
    values.assign(places.size() / axes * width_, 0.0);
    for (std::size_t home = 0; home < answers.size(); ++home)
      for (std::size_t i = 0; i < numbers[home].size(); ++i)
        std::copy_n(answers[home].begin() + std::ptrdiff_t(i) * std::ptrdiff_t(width_), width_,
                    values.begin() + std::ptrdiff_t(numbers[home][i]) * std::ptrdiff_t(width_));
    return comm_.sum(missing) == 0;
  }

private:
  static Place placeAt(const Vector& numbers, std::size_t at)
  {
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
  }

  std::size_t width_;
  const Comm& comm_;
  std::map<Place, Vector> known_;
};

[[noreturn]] void refuse(const std::string& why)
{
  throw InputError("The status passes to go on from " + why + "; run without --restart, from the beginning.");
}

/// The fields at this rank's nodes. Whole ones are given by rank 0.
void takeOwn(StatusMemory& memory, const SharedPasses& from, const Model& model, const Comm& comm)
{
  const std::vector<const BodyModel*> bodies = bodiesOf(model);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const bool gives = from.isInParts || comm.rank() == 0;
    const Directory directory(gives ? from.places[b] : Vector(), memory.fields[b], std::size_t(bodies[b]->mesh.dim),
                              comm);
    if (!directory.find(heldPlaces(*bodies[b]), memory.fields[b]))
      refuse(fmt::format("have no displacements at some nodes of \"{}\"", bodies[b]->name));
  }
}

} // namespace

bool haveFields(const SweepsDone& done)
{
  return done.passes && !done.passes->system.fields.empty();
}

bool arePassesOf(const SweepsDone& done, const SharedPasses& shared, const Model& model)
{
  if (!haveFields(done))
    return true;
  const std::size_t fields = done.passes->system.fields.size();
  return shared.interfaces == hashOf(model.interfaces) && fields == bodiesOf(model).size() &&
         fields == shared.places.size();
}

SweepsKept sharedPasses(SweepsKept sweeps, const Model& model, SharedPasses& shared, const Comm& comm)
{
  if (sweeps.after && !arePassesOf(*sweeps.after, shared, model))
    refuse("are those of other interfaces");
  const bool areShared = bool(model.told);
  if ((areShared || shared.isInParts) && sweeps.after && haveFields(*sweeps.after))
    takeOwn(sweeps.after->passes->system, shared, model, comm);
  shared = {};
  if (!model.solvesWhole || !sweeps.keep)
    return sweeps;
  shared.interfaces = hashOf(model.interfaces);
  shared.isInParts = areShared;
  for (const BodyModel* const body : bodiesOf(model))
    shared.places.push_back(areShared || comm.rank() == 0 ? heldPlaces(*body) : Vector());
  return sweeps;
}

} // namespace ndframe
