// Integrates a load that jumps inside a triangle: the samples' points lie on both sides of the jump.
#include <cmath>

#include "ndframe/sampling/adaptive_samples.hpp"

int main()
{
  using namespace ndframe;
  const SampledFunction jump{std::make_shared<const ExpressionTree>("x > 0.25 ? 3 : 1"),
                             [](const double*, int, double) {}}; // it is finite everywhere
  DataSampler sampler({jump}, 2);

  const double points[3][2] = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
  const DataSampler::Vertices triangle{points[0], points[1], points[2]};
  const double scale = sampler.scaleOn([&](const DataSampler::Visit& visit) { visit(2, triangle); });
  const Samples samples = sampler.sample(2, triangle, scale);

  double mean = 0.0;
  for (int g = 0; g < samples.rule.size(); ++g)
    mean += samples.rule.weights[std::size_t(g)] * samples.values[std::size_t(g)];
  const double beyond = 0.75 * 0.75; // the share of the triangle where x > 0.25
  return samples.areCertain() && std::abs(mean - (1.0 + 2.0 * beyond)) < 1e-12 ? 0 : 1;
}
