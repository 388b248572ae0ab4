#include "summary_json.hpp"

// docs/summary.schema.json describes what is written here; tests/report holds the two together.

namespace ndframe
{
namespace
{

template <class Value, class Convert>
Json orNull(const std::optional<Value>& value, Convert convert)
{
  return value ? convert(*value) : Json();
}

Json orNull(const std::optional<double>& number)
{
  return orNull(number, [](double value) { return Json(value); });
}

Json measureJson(const ErrorMeasureSummary& measure)
{
  return {{"absolute", measure.absolute}, {"relative", measure.relative},     {"elements", measure.elements},
          {"contact", measure.contact},   {"projection", measure.projection}, {"oscillation", measure.oscillation}};
}

Json referenceJson(const ReferenceSummary& reference)
{
  return {{"refinements", reference.refinements},
          {"dofs", reference.dofs},
          {"note", reference.note},
          {"displacement", reference.displacement},
          {"relative", reference.relative},
          {"stress", orNull(reference.stress)},
          {"mean_stress", orNull(reference.meanStress)},
          {"effectivity", orNull(reference.effectivity)},
          {"mean_stress_effectivity", orNull(reference.meanStressEffectivity)}};
}

/// The bound and whether it is one.
Json globalJson(const ErrorSummary& errors)
{
  return orNull(errors.global, [&](const ErrorMeasureSummary& measure) {
    auto json = measureJson(measure);
    json["guaranteed"] = errors.guaranteed;
    json["reason"] = errors.reason;
    return json;
  });
}

Json meanStressJson(const ErrorSummary& errors)
{
  return orNull(errors.meanStress, [&](double absolute) {
    return Json{{"absolute", absolute}, {"relative", orNull(errors.meanStressRelative)}};
  });
}

} // namespace

Json errorsJson(const std::optional<ErrorSummary>& errors)
{
  return orNull(errors, [](const ErrorSummary& e) {
    return Json{{"mode", e.mode},
                {"recovery", e.recovery},
                {"degree", e.degree},
                {"interface_traction", e.interfaceTraction},
                {"global", globalJson(e)},
                {"algorithm", orNull(e.algorithm, measureJson)},
                {"discretization", orNull(e.discretization, measureJson)},
                {"split_stress", orNull(e.splitStress)},
                {"mean_stress", meanStressJson(e)},
                {"zienkiewicz_zhu", orNull(e.zienkiewiczZhu)},
                {"residual", orNull(e.residual)},
                {"equilibrium", orNull(e.equilibrium)},
                {"equilibrium_discretization", orNull(e.equilibriumDiscretization)},
                {"reference", orNull(e.reference, referenceJson)},
                {"energy_bracket", energyJson(e.energyBracket)},
                {"advice", e.advice}};
  });
}

} // namespace ndframe
