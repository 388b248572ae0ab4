#include "ndframe/report/checkpoint_bytes.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "ndframe/base/diagnostics.hpp"

namespace nlohmann
{

template <class Value>
struct adl_serializer<std::optional<Value>>
{
  static void to_json(json& target, const std::optional<Value>& value)
  {
    target = value ? json(*value) : json(nullptr);
  }
  static void from_json(const json& source, std::optional<Value>& value)
  {
    value = source.is_null() ? std::nullopt : std::optional(source.get<Value>());
  }
};

template <class Where>
struct adl_serializer<ndframe::Field<Where>>
{
  static void to_json(json& target, const ndframe::Field<Where>& field) { target = field.whole(); }
  static void from_json(const json& source, ndframe::Field<Where>& field)
  {
    field = ndframe::ofAll<Where>(source.get<ndframe::Vector>());
  }
};

} // namespace nlohmann

namespace ndframe
{

using Json = nlohmann::json;

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NumberBracket, lower, upper)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LevelSummary, level, dofs, elements, worstShape, sweeps, bound, relative, iteration,
                                   mesh, worstBody, worstPoint, dofsToTarget, seconds, energy, doubt)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RoleSummary, dirichletBodies, neumannBodies, exchanged, contraction, theta,
                                   bestTheta, contractionExchanged)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LevelNumbers, bound, target, relative, iteration, mesh, contact)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EndBracket, closed, open)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EndOnSide, bracket, length)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LevelLesson, errors, contributions, ends, brackets)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EnergyEnd, value, roundOff, name)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EnergyEnds, lower, upper, certificates)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LevelRecord, summary, lesson, maximumDofs, meshes, nextTraction, tractionNeumann,
                                   closed, dirichletBodies, roles, energy)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SweepRecord, sweep, epsTau, iterationError, theta, statusChanges, statusPasses,
                                   closed, open, forceDirichlet, forceNeumann, turned, penetration, note)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(InterfaceState, uDirichlet, uNeumann, motionsNeumann, strainedNeumann,
                                   forceDirichlet, forceNeumann, tractionDirichlet, tractionNeumann, closed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StatusMemory, displacement, force, motions, isOfForces, fields, levelClosed,
                                   levelProximal, tolerance, earlyPasses)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StatusHistory, seen, fewest, single, cycled, drawn)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StatusPasses, first, closed, passes, proximal, u, history, system, counts)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SweepsDone, history, state, traction, relaxation, counts, passes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SweepsRecord, done, goal, isRough, before, iterationBefore, boundBefore, energy)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StageRecord, name, seconds, peakBytes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SharedPasses, places, interfaces, isInParts)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Checkpoint, version, deckJson, isFinished, results, levels, sweeps, shared, pieces,
                                   stamp, solution, seconds, firstMemory, peakMemory, counts, stages)

namespace
{

constexpr const char *kindKey = "kind", *formatKey = "format", *contentKey = "content";
constexpr const char* kind = "ndframe checkpoint";
constexpr int format = 8;

std::string refusal(const std::string& path, const std::string& why)
{
  return fmt::format("\"{}\" {}; run without --restart, from the beginning.", path, why);
}

} // namespace

std::string toBytes(const Checkpoint& checkpoint)
{
  std::string bytes;
  Json::to_cbor(Json{{kindKey, kind}, {formatKey, format}, {contentKey, checkpoint}}, bytes);
  return bytes;
}

Checkpoint checkpointFromBytes(const std::string& bytes, const std::string& path, const std::string& version)
{
  const Json file = Json::from_cbor(bytes, true, false);
  if (!file.is_object() || file.value(kindKey, Json()) != kind)
    throw InputError(refusal(path, "is not an ndframe checkpoint, or ends too early"));
  try {
    const std::string writer = file.at(contentKey).at("version");
    if (file.at(formatKey) != format || writer != version)
      throw InputError(refusal(path, fmt::format("was written by ndframe {} (format {}), and this is {} (format {})",
                                                 writer, file.at(formatKey).dump(), version, format)));
    Checkpoint checkpoint = file.at(contentKey).get<Checkpoint>();
    if (checkpoint.levels.empty() && !checkpoint.sweeps && !checkpoint.isFinished)
      throw InputError(refusal(path, "has neither levels nor sweeps"));
    return checkpoint;
  } catch (const Json::exception&) {
    throw InputError(refusal(path, "lacks a part of a checkpoint"));
  }
}

} // namespace ndframe
