#include "certificate/sharpness.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "certificate/deck_run.hpp"
#include "certificate/isotropic_scene.hpp"
#include "certificate/report.hpp"

namespace ndframe::test
{
namespace
{

/// Issue 4, "Sharpness".
const std::vector<Variant> variants{{"degree 2", "Star", "Optimal", 2, 0, false, 1.17, 1.30},
                                    {"degree 2, 1 sweep", "Star", "Optimal", 2, 1, false, 1.12, 1.25},
                                    {"degree 3", "Star", "Optimal", 3, 0, false, 1.12, 1.25},
                                    {"degree 3, 2 sweeps", "Star", "Optimal", 3, 2, false, 1.06, 1.15},
                                    {"degree 2, projected", "Star", "Projected", 2, 0},
                                    {"degree 3, projected", "Star", "Projected", 3, 0},
                                    {"element, degree 2", "Element", "Projected", 2, 0},
                                    {"degree 3, 2 sweeps, aspect 5", "Star", "Optimal", 3, 2, true, 1.6, 1.6}};

/// Of references with cells of h/16; scenes with more take h/8.
constexpr std::int64_t affordableDofs = 250000;

DrawnScene withVariant(DrawnScene scene, const Variant& variant)
{
  const std::string list = "Error Estimation/";
  scene.deck.set(list + "Estimators", std::vector<std::string>{"Global"});
  scene.deck.set(list + "Recovery/Type", variant.recovery);
  scene.deck.set(list + "Recovery/Degree", variant.degree);
  if (variant.recovery == "Star")
    scene.deck.set(list + "Recovery/Sweeps", variant.sweeps);
  scene.deck.set(list + "Interface Traction/Type", variant.traction);
  return scene;
}

ErrorSummary errorsOf(const Run& run)
{
  if (!run.summary.errors || !run.summary.errors->guaranteed)
    throw std::runtime_error("no guaranteed bound: " + (run.summary.errors ? run.summary.errors->reason : run.failure));
  return *run.summary.errors;
}

/// Against a reference of this depth.
ReferenceSummary referenceOf(DrawnScene scene, int refinements, const std::string& folder)
{
  const std::string list = "Error Estimation/";
  scene.deck.set(list + "Estimators", std::vector<std::string>{"Global", "Reference"});
  scene.deck.set(list + "Reference/Refinements", refinements);
  return *errorsOf(runDeckFile(writeScene(scene, folder))).reference;
}

/// Everything about the error of a scene, which is the same for all variants.
struct Truth
{
  double error = 0.0;
  ReferenceSummary reference;
};

Truth truthOf(const DrawnScene& scene, const std::string& folder)
{
  std::int64_t dofs = 0;
  for (const auto& body : runDeckFile(writeScene(scene, folder)).summary.bodies)
    dofs += body.dofs;
  const int depth = dofs * 256 <= affordableDofs ? 4 : 3;
  const auto first = referenceOf(scene, depth - 2, folder), second = referenceOf(scene, depth - 1, folder);
  Truth truth{0.0, referenceOf(scene, depth, folder)};
  truth.error = extrapolatedError(first.displacement, second.displacement, truth.reference.displacement);
  return truth;
}

Sharpness measure(const DrawnScene& scene, const Variant& variant, const Truth& truth, const std::string& folder)
{
  const ErrorMeasureSummary bound = *errorsOf(runDeckFile(writeScene(withVariant(scene, variant), folder))).global;
  Sharpness result;
  result.kind = scene.kind;
  result.variant = variant.name;
  result.bound = bound.absolute;
  result.elements = bound.elements;
  result.contact = bound.contact;
  result.projection = bound.projection;
  result.oscillation = bound.oscillation;
  result.error = truth.error;
  result.reference = truth.reference.displacement;
  result.refinements = truth.reference.refinements;
  result.meanStress = truth.reference.meanStressEffectivity.value_or(1.0);
  return result;
}

/// All variants of a scene's group.
std::vector<Sharpness> measureScene(int index, const SweepOptions& options, bool stretched)
{
  const std::vector<std::string> kinds{"punch", "contact-loss", "linear", "random"};
  Draw draw(options.seed * 1000003u + std::uint64_t(2 * index + int(stretched)));
  const DrawnScene scene =
      drawIsotropicScene(kinds[std::size_t(index) % kinds.size()], stretched ? 5.0 : 1.0, options.finest, draw);
  const std::string folder = fmt::format("{}/sharpness-{}{}", options.folder, index, stretched ? "-stretched" : "");
  const Truth truth = truthOf(withVariant(scene, variants.front()), folder);
  std::vector<Sharpness> results;
  for (const auto& variant : variants)
    if (variant.stretched == stretched) {
      results.push_back(measure(scene, variant, truth, folder));
      results.back().scene = index;
    }
  if (!options.keep)
    std::filesystem::remove_all(folder);
  return results;
}

std::string line(const Sharpness& one)
{
  return fmt::format("{},{},\"{}\",{},{},{},{},{},{},{},{},{},{}\n", one.scene, one.kind, one.variant, one.bound,
                     one.elements, one.contact, one.projection, one.oscillation, one.error, one.reference,
                     one.refinements, one.effectivity(), one.meanStress);
}

std::vector<double> effectivities(const std::string& variant, const std::vector<Sharpness>& all)
{
  std::vector<double> values;
  for (const auto& one : all)
    if (one.variant == variant)
      values.push_back(one.effectivity());
  return values;
}

std::string limit(double value)
{
  return value < 1e300 ? fmt::format("<= {:.2f}", value) : "";
}

std::string table(const std::vector<Sharpness>& all)
{
  std::string text = fmt::format("{:<30}{:>8}{:>9}{:>9}{:>9}{:>9}\n", "variant", "scenes", "median", "", "largest", "");
  for (const auto& variant : variants) {
    const auto values = effectivities(variant.name, all);
    if (!values.empty())
      text += fmt::format("{:<30}{:>8}{:>9.3f}{:>9}{:>9.3f}{:>9}\n", variant.name, values.size(), median(values),
                          limit(variant.median), *std::max_element(values.begin(), values.end()), limit(variant.worst));
  }
  std::vector<double> mean;
  for (const auto& one : all)
    if (one.variant == variants.front().name)
      mean.push_back(one.meanStress);
  return text + fmt::format("{:<30}{:>8}{:>9.3f}{:>9}{:>9.3f}\n", "degree 2, mean stress", mean.size(), median(mean),
                            "", *std::max_element(mean.begin(), mean.end()));
}

} // namespace

double extrapolatedError(double first, double second, double third)
{
  const double step = second * second - first * first, next = third * third - second * second;
  const double ratio = next / step;
  if (!(step > 0.0 && ratio > 0.0 && ratio < 0.75))
    return third;
  return std::sqrt(third * third + next * ratio / (1.0 - ratio));
}

std::vector<std::string> judgeSharpness(const Variant& variant, const std::vector<Sharpness>& all)
{
  const auto values = effectivities(variant.name, all);
  if (values.empty())
    return {};
  std::vector<std::string> wrong;
  const auto require = [&](const char* what, double value, double most) {
    if (!(value <= most))
      wrong.push_back(fmt::format("{}: {} effectivity {:.3f} above {}", variant.name, what, value, most));
  };
  require("median", median(values), variant.median);
  require("largest", *std::max_element(values.begin(), values.end()), variant.worst);
  for (const auto& one : all)
    if (one.variant == variant.name && !(one.bound >= one.reference * (1.0 - 1e-9)))
      wrong.push_back(fmt::format("{}: scene {} ({}) has a bound below its error", variant.name, one.scene, one.kind));
  return wrong;
}

bool measureSharpness(const SweepOptions& options)
{
  std::vector<Sharpness> all;
  std::ofstream csv(options.folder + "/sharpness.csv");
  csv << "scene,kind,variant,bound,elements,contact,projection,oscillation,error,reference,refinements,effectivity,"
         "mean stress effectivity\n";
  for (int i = options.first; i < options.first + options.scenes; ++i)
    for (const bool stretched : {false, true})
      for (const auto& one : measureScene(i, options, stretched)) {
        all.push_back(one);
        csv << line(one) << std::flush;
      }
  fmt::print("{}", table(all));
  bool good = true;
  for (const auto& variant : variants)
    for (const auto& sentence : judgeSharpness(variant, all)) {
      fmt::print("WRONG: {}\n", sentence);
      good = false;
    }
  return good;
}

} // namespace ndframe::test
