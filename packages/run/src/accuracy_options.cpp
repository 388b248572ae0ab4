#include "ndframe/run/accuracy_options.hpp"

namespace ndframe
{

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

} // namespace ndframe
