#pragma once

#include <array>
#include <vector>

#include "ndframe/estimation/corner_exponents.hpp"
#include "ndframe/estimation/prediction.hpp"
#include "ndframe/mesh/bisection.hpp"

namespace ndframe
{

/// Refinement of a scene's meshes for a smaller error: smooth cells are halved several times at once, those around a
/// corner graded towards it, so that all new cells contribute the same.
class GradedRefinement
{
public:
  /// contributions: eta_K per body and cell of the meshes. exponents: as learned for these meshes.
  GradedRefinement(const std::vector<Mesh>& meshes, const std::vector<Vector>& contributions,
                   const CornerExponents& exponents, int degree);

  /// target: of sqrt(sum eta_K^2).
  Prediction predict(double target) const;

  void apply(Bisection& bisection, const Prediction& prediction) const;

private:
  /// A cell as it was when its contribution was measured, and the corner that it touches, if it touches one.
  struct Origin
  {
    bool atCorner = false;
    double area = 0.0, squaredDistance = 0.0; ///< of its centre from the corner
    std::array<double, 2> corner{};
  };

  int halvingsOf(std::size_t body, std::size_t ancestor, const Mesh& mesh, int cell, bool first, double level) const;
  double logSquared(std::size_t body, std::size_t ancestor, const Mesh& mesh, int cell) const;

  int degree_;
  std::vector<std::vector<CellDecay>> cells_;
  std::vector<std::vector<Origin>> origins_;
};

} // namespace ndframe
