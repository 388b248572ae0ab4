#include "materials.hpp"

namespace ndframe
{
namespace
{

/// Hooke's law  sigma = lambda tr(eps) I + 2 mu eps,  lambda = E nu / ((1 + nu)(1 - 2 nu)), mu = E / (2 (1 + nu)).
///
/// Limits: -1 < nu < 0.5 (at 0.5 plane strain and space are incompressible; displacement elements lock on the way
/// there).
class Isotropic final : public MaterialLaw
{
public:
  Isotropic(double young, double poisson, Hypothesis hypothesis)
      : young_(young), poisson_(poisson), hypothesis_(hypothesis)
  {}

  Hypothesis hypothesis() const override { return hypothesis_; }

  Elasticity elasticity() const override
  {
    const double mu = young_ / (2.0 * (1.0 + poisson_));
    const double lambda = young_ * poisson_ / ((1.0 + poisson_) * (1.0 - 2.0 * poisson_));
    SpatialStiffness C{};
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        C[6 * std::size_t(i) + std::size_t(j)] = lambda + (i == j ? 2.0 * mu : 0.0);
      C[7 * std::size_t(i + 3)] = mu;
    }
    return reduceTo(hypothesis_, C);
  }

private:
  double young_, poisson_;
  Hypothesis hypothesis_;
};

} // namespace

void registerIsotropic(Registry<MaterialLaw>& registry)
{
  registry.add("Isotropic", "Hooke's law with one Young modulus and one Poisson ratio.",
               {ParamSpec::required("Young Modulus", Kind::Double, above(0.0), "Young's modulus E, a stress."),
                ParamSpec::required("Poisson Ratio", Kind::Double, inOpenRange(-1.0, 0.5), "Poisson's ratio nu."),
                hypothesisSpec()},
               [](const Params& p) {
                 return std::make_unique<Isotropic>(p.get<double>("Young Modulus"), p.get<double>("Poisson Ratio"),
                                                    hypothesisNames().value(p.get<std::string>("Hypothesis")));
               });
}

} // namespace ndframe
