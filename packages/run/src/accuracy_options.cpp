#include "ndframe/run/accuracy_options.hpp"

namespace ndframe
{
namespace
{

/// An optional limit; without it there is none.
double limit(const Params& list, const char* key, double unit)
{
  return list.has(key) ? unit * list.get<double>(key) : std::numeric_limits<double>::infinity();
}

} // namespace

const Names<AccuracyOf>& accuracyOfNames()
{
  static const Names<AccuracyOf> names{{"Displacement", AccuracyOf::Displacement},
                                       {"Mean Stress", AccuracyOf::MeanStress}};
  return names;
}

const Names<AccuracyStart>& accuracyStartNames()
{
  static const Names<AccuracyStart> names{{"Coarsest", AccuracyStart::Coarsest}, {"Deck", AccuracyStart::Deck}};
  return names;
}

bool wantsAccuracy(const Params& deck)
{
  return deck.hasSub("Accuracy");
}

AccuracyOptions accuracyOptions(const Params& deck)
{
  const Params list = deck.sub("Accuracy");
  AccuracyOptions options;
  options.relative = list.has("Target");
  options.target = list.get<double>(options.relative ? "Target" : "Absolute Target");
  options.of = accuracyOfNames().value(list.get<std::string>("Of"));
  options.start = accuracyStartNames().value(list.get<std::string>("Start"));
  options.maximumDofs = list.get<int>("Maximum Dofs");
  options.maximumLevels = list.get<int>("Maximum Levels");
  options.maximumMemory = limit(list, "Maximum Memory", 1e9);
  options.maximumSeconds = limit(list, "Maximum Time", 1.0);
  options.iterationShare = list.get<double>("Iteration Share");
  return options;
}

} // namespace ndframe
